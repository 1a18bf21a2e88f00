import type { Settings } from './settings.ts';

/** Where the playhead goes when a run is shown. */
export type Destination =
  /** The film begins there. */
  | { readonly kind: 'film'; readonly from: number }
  | { readonly kind: 'step'; readonly step: number }
  /** 1: the longest. Unless it was asked for by name, the longest that there is will do. */
  | { readonly kind: 'plateau'; readonly rank: number; readonly asked: boolean };

/** Where the attributes say. */
export function destinationOf({ autoplay, step, plateau }: Settings): Destination {
  // Visitors who asked for less motion start the film themselves.
  const moves = autoplay && !matchMedia('(prefers-reduced-motion: reduce)').matches;
  if (moves) return { kind: 'film', from: step ?? 1 };
  if (step !== undefined) return { kind: 'step', step };
  return { kind: 'plateau', rank: plateau ?? 1, asked: plateau !== undefined };
}

/** The same, and the film begins. */
export function playing(to: Destination | undefined): Destination {
  if (to?.kind === 'film') return to;
  return { kind: 'film', from: to?.kind === 'step' ? to.step : 1 };
}

/** The same without the film. */
export function still(to: Destination): Destination {
  return to.kind === 'film' ? { kind: 'step', step: to.from } : to;
}
