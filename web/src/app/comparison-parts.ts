import { make } from './make.ts';
import {
  createCards,
  createDiagramBox,
  createLegend,
  createShapeBox,
  createSlider,
  createTransport,
} from './run-parts.ts';

/** The run that was on the page, and the one beside it. */
export type Letter = 'A' | 'B';

/** What names a run and says where it is, with its cards and its diagram. */
export function createSideParts(letter: Letter) {
  const badge = (): HTMLElement => make('span', { class: 'run-letter', 'aria-hidden': 'true' }, letter);
  const name = make('span');
  const settings = make('p', { class: 'run-settings' });
  const readout = make('p', { class: 'run-readout' });
  const spoken = make('p', { class: 'for-readers', 'aria-live': 'polite' });
  const spokenLetter = make('span', { class: 'for-readers' }, `Run ${letter}: `);
  const head = make(
    'div',
    { id: `run-${letter.toLowerCase()}`, class: 'run-head', role: 'group', 'aria-label': `Run ${letter}` },
    make('h2', { class: 'run-name' }, badge(), spokenLetter, name),
    settings,
    readout,
    spoken,
  );
  const diagram = createDiagramBox(
    ` of run ${letter}, with its plateaus as bands. The slider Scale moves along it.`,
  );
  diagram.append(badge());
  const { cards, noCards } = createCards();
  const cardsOf = make('span');
  const answers = make(
    'section',
    { class: 'run-answers', 'aria-label': `Plateaus of run ${letter}` },
    make('h2', {}, badge(), cardsOf),
    cards,
    noCards,
  );
  return { head, name, settings, readout, spoken, diagram, cards, noCards, cardsOf, answers };
}

export type SideParts = ReturnType<typeof createSideParts>;

/** The stage of the second shape, furnished as that of the first. */
export function createSecondStage() {
  const shape = createShapeBox('Shape of run B');
  const noShape = make('p', { class: 'no-shape', hidden: '' });
  const computing = make('p', { class: 'computing', 'aria-hidden': 'true', hidden: '' });
  const words = make('span');
  const toEnd = make(
    'button',
    { class: 'button', type: 'button', title: 'Goes on to finer scales, to the last point' },
    'Run to the end',
  );
  const scan = make('p', { class: 'scan', hidden: '' }, words, toEnd);
  const notes = make('div', { class: 'run-notes' }, computing, scan);
  const length = make('span', { class: 'scale-length' });
  const text = make('span');
  const bar = make('div', { class: 'scale-bar', hidden: '' }, length, text);
  const projection = make('p', { class: 'projection', hidden: '' });
  const hint = make(
    'p',
    { class: 'drop-hint', 'aria-hidden': 'true' },
    'Drop a point cloud to compare with it',
  );
  const stage = make(
    'section',
    { class: 'stage second-stage', 'aria-label': 'Shape of run B' },
    shape,
    noShape,
    notes,
    bar,
    projection,
    hint,
  );
  return { stage, shape, noShape, notes: { computing, scan, words, toEnd }, bar, length, text, projection };
}

/** One film for both: its buttons, and both diagrams over one axis under one slider. */
export function createComparedFilm(diagrams: readonly HTMLElement[]) {
  const transport = createTransport();
  const close = make(
    'button',
    { id: 'close-compare', type: 'button', class: 'button', title: 'Back to run A alone (V)' },
    make('span', {}, 'Close', make('span', { class: 'spare' }, ' comparison')),
  );
  transport.readout.after(close);
  const axis = make('select', { 'aria-label': 'Axis of 1/ε', title: 'Logarithmic or linear (L)' });
  axis.append(new Option('log', 'log'), new Option('linear', 'linear'));
  const together = make('input', { type: 'checkbox', checked: '' });
  const turns = make(
    'label',
    { class: 'check', title: 'Turning one shape turns the other' },
    together,
    make('span', {}, 'Turn both'),
  );
  const legend = createLegend();
  legend.append(make('div', { class: 'scales' }, turns, make('label', { class: 'field' }, '1/ε', axis)));
  const slider = createSlider('Scale');
  const timeline = make('div', { class: 'timeline' }, slider, ...diagrams);
  const film = make(
    'section',
    { id: 'compared-film', class: 'film compared-film', 'aria-label': 'Film over scale of both runs' },
    transport.bar,
    legend,
    timeline,
  );
  return { ...transport, slider, close, axis, together, turns, timeline, film };
}
