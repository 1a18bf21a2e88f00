import { iconButton, make } from './make.ts';

const BETTI_NAMES = ['β₀ components', 'β₁ loops', 'β₂ voids', 'β₃', 'β₄', 'β₅', 'β₆'];

/** The lines of a diagram by their colors. */
export function createLegend(): HTMLElement {
  const lines = BETTI_NAMES.map((name, k) =>
    make('span', { class: `betti-${k}`, 'aria-hidden': 'true', ...(k > 2 ? { hidden: '' } : {}) }, name),
  );
  return make('div', { class: 'legend' }, ...lines);
}

/** What turns by keyboard; `called`: "Shape", and of what where there are several. */
export function createShapeBox(called: string): HTMLElement {
  return make('div', {
    class: 'shape',
    role: 'application',
    tabindex: '0',
    'aria-label': `${called}: arrow keys turn it, plus and minus bring it nearer or farther`,
  });
}

/** Back, Play and Step with the numbers of the playhead; inert until there is something to move. */
export function createTransport() {
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
  const bar = make(
    'div',
    { class: 'transport', inert: '' },
    back.button,
    play.button,
    forward.button,
    readout,
    status,
    spoken,
  );
  return {
    bar,
    readout,
    status,
    spoken,
    buttons: { play: play.button, label: play.label, back: back.button, forward: forward.button },
  };
}

/** The playhead for keys and screen readers; it lies over a diagram. */
export function createSlider(called: string): HTMLInputElement {
  return make('input', {
    class: 'slider',
    type: 'range',
    min: '1',
    max: '1',
    value: '1',
    step: '1',
    'aria-label': called,
  });
}

/** `about`: where it is of one run of several, and which slider moves along it. */
export function createDiagramBox(about: string): HTMLElement {
  return make('div', {
    class: 'diagram',
    role: 'img',
    'aria-label': `Betti numbers over 1/ε${about}`,
  });
}

/** Plateau cards, and what is said where there are none. */
export function createCards() {
  return { cards: make('ol', { class: 'cards' }), noCards: make('p', { class: 'honest' }) };
}
