import {
  createCards,
  createDiagramBox,
  createLegend,
  createShapeBox,
  createSlider,
  createTransport,
} from '../app/run-parts.ts';
import { icon, make } from './dom.ts';

/** Where the licence is kept and what it asks for: beside this program. */
function credit(): HTMLElement {
  const link = (file: string, text: string): HTMLElement =>
    make('a', { href: new URL(/* @vite-ignore */ `./${file}`, import.meta.url).href }, text);
  return make(
    'p',
    { class: 'credit' },
    'Plateau, free software: ',
    link('source.tar.gz', 'source'),
    ' · ',
    link('licences.txt', 'licences'),
  );
}

/** Everything inside an element, as nodes that its classes take. */
export function createParts() {
  const shape = createShapeBox('Shape');
  const noShape = make('p', { class: 'note', hidden: '' });
  const empty = make('p', { class: 'note', hidden: '' });
  const still = make('canvas', { class: 'still', 'aria-hidden': 'true' });
  const unopened = make('p', { class: 'note unopened' }, 'Open this figure first, then print.');
  const stage = make('div', { class: 'stage' }, still, shape, noShape, empty, unopened);

  const { bar, readout, status, spoken, buttons } = createTransport();
  const slider = createSlider('Step');
  const diagram = createDiagramBox(', with the plateaus as bands. The slider Step moves along it.');
  const timeline = make('div', { class: 'timeline' }, slider, diagram);
  const film = make(
    'div',
    { class: 'film', role: 'group', inert: '', 'aria-label': 'Film over scale' },
    createLegend(),
    timeline,
  );

  const { cards, noCards } = createCards();
  const side = make(
    'div',
    { class: 'side', role: 'group', 'aria-label': 'Plateaus' },
    make('p', { class: 'title' }, 'What it sees'),
    cards,
    noCards,
    credit(),
  );

  const said = make('p', { role: 'alert' });
  const dismiss = make('button', { type: 'button', class: 'dismiss', 'aria-label': 'Dismiss' });
  dismiss.append(icon({ 'M4 3l4 4 4-4 1 1-4 4 4 4-1 1-4-4-4 4-1-1 4-4-4-4z': 'solid' }));
  const again = make('button', { type: 'button', class: 'button again', hidden: '' }, 'Try again');
  const trouble = make('div', { class: 'trouble', hidden: '' }, said, again, dismiss);

  const column = make('div', { class: 'column' }, stage, bar, film);
  // Its words and numbers are English, whatever the language of the page.
  const english = { lang: 'en', dir: 'ltr' };
  const view = make(
    'div',
    { class: 'view', role: 'group', tabindex: '-1', ...english },
    trouble,
    column,
    side,
  );
  const box = make('div', { class: 'box' }, view);
  return {
    box,
    view,
    trouble,
    said,
    again,
    dismiss,
    stage,
    still,
    shape,
    noShape,
    empty,
    readout,
    status,
    spoken,
    bar,
    transport: { ...buttons, slider },
    timeline,
    diagram,
    film,
    cards,
    noCards,
  };
}

export type Parts = ReturnType<typeof createParts>;
