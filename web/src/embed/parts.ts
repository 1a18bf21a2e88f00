import { icon, iconButton, make } from './dom.ts';

const BETTI_NAMES = ['β₀ components', 'β₁ loops', 'β₂ voids', 'β₃', 'β₄', 'β₅', 'β₆'];

function legend(): HTMLElement {
  const lines = BETTI_NAMES.map((name, k) =>
    make('span', { class: `betti-${k}`, 'aria-hidden': 'true', ...(k > 2 ? { hidden: '' } : {}) }, name),
  );
  return make('div', { class: 'legend' }, ...lines);
}

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
  const shape = make('div', {
    class: 'shape',
    role: 'application',
    tabindex: '0',
    'aria-label': 'Shape: arrow keys turn it, plus and minus bring it nearer or farther',
  });
  const noShape = make('p', { class: 'note', hidden: '' });
  const empty = make('p', { class: 'note', hidden: '' });
  const stage = make('div', { class: 'stage' }, shape, noShape, empty);

  const back = iconButton('icon', 'Back', 'Back one landmark', { 'M12.5 3v10L6 8zM3.5 3h2v10h-2z': 'solid' });
  const play = iconButton('primary', 'Play', 'Play or pause', {
    'M4 2.5v11l9-5.5z': 'solid when-paused',
    'M3.5 2.5h3v11h-3zM9.5 2.5h3v11h-3z': 'solid when-playing',
  });
  const forward = iconButton('icon', 'Step', 'One landmark further', {
    'M3.5 3v10L10 8zM10.5 3h2v10h-2z': 'solid',
  });
  const readout = make('p', { class: 'readout', 'aria-hidden': 'true' });
  const status = make('p', { class: 'for-readers', role: 'status' });
  const spoken = make('p', { class: 'for-readers', 'aria-live': 'polite' });
  const transport = make(
    'div',
    { class: 'transport', inert: '' },
    back.button,
    play.button,
    forward.button,
    readout,
    status,
    spoken,
  );

  const slider = make('input', {
    class: 'slider',
    type: 'range',
    min: '1',
    max: '1',
    value: '1',
    step: '1',
    'aria-label': 'Step',
  });
  const diagram = make('div', {
    class: 'diagram',
    role: 'img',
    'aria-label': 'Betti numbers over 1/ε, with the plateaus as bands. The slider Step moves along it.',
  });
  const timeline = make('div', { class: 'timeline' }, slider, diagram);
  const film = make(
    'div',
    { class: 'film', role: 'group', inert: '', 'aria-label': 'Film over scale' },
    legend(),
    timeline,
  );

  const cards = make('ol', { class: 'cards' });
  const noCards = make('p', { class: 'honest' });
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
  const trouble = make('div', { class: 'trouble', hidden: '' }, said, dismiss);

  const column = make('div', { class: 'column' }, stage, transport, film);
  const view = make('div', { class: 'view', role: 'group' }, trouble, column, side);
  const box = make('div', { class: 'box' }, view);
  return {
    box,
    view,
    trouble,
    said,
    dismiss,
    shape,
    noShape,
    empty,
    readout,
    status,
    spoken,
    bar: transport,
    transport: { play: play.button, label: play.label, back: back.button, forward: forward.button, slider },
    timeline,
    diagram,
    film,
    cards,
    noCards,
  };
}

export type Parts = ReturnType<typeof createParts>;
