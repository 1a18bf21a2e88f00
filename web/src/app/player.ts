import type { FilmScreen } from './film.ts';
import type { TransportActions } from './transport.ts';

/** What buttons and keys move: the run of the page, or two that are compared. */
export interface Player extends FilmScreen, TransportActions {
  nextPlateau(): void;
}
