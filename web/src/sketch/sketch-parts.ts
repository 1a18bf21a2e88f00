import { make } from '../embed/dom.ts';
import { Board } from './board.ts';
import type { Tool } from './board-input.ts';
import { LAYER_NAMES, LAYERS, layersIn, wordsOf, type Layer } from './layers.ts';

const TOOLS: readonly (readonly [Tool, string])[] = [
  ['move', 'Move'],
  ['landmark', 'Add landmarks'],
  ['witness', 'Add witnesses'],
  ['ask', 'Ask why'],
];

/** What readers can change, by the names of the attribute `offer`. */
type Offer = 'edits' | 'nu' | 'layers' | 'why' | 'clear';
const ALL_OFFERS = 'edits nu layers why';

/** Keys, what they do, and what must be offered for them to do it. */
const KEYS: readonly (readonly [string, string, (Offer | Tool)?])[] = [
  ['N, P', 'next or previous point'],
  ['Arrows', 'move it, or the cross where no point is selected; with shift by five', 'edits'],
  ['L', 'put a landmark where the cross is', 'landmark'],
  ['W', 'put a witness where the cross is', 'witness'],
  ['Delete', 'remove the selected point', 'edits'],
  ['Space', 'take the selected landmark into the question why, or out of it', 'why'],
  ['Escape', 'select nothing; the cross stays there'],
  ['Ctrl+Z', 'undo', 'edits'],
];

/** Layers that are about witnesses. */
const WITNESSED: readonly Layer[] = ['complex', 'lists', 'cover'];

function button(label: string, title: string): HTMLButtonElement {
  return make('button', { type: 'button', class: 'button', title }, label);
}

function check(label: string): { box: HTMLInputElement; label: HTMLLabelElement } {
  const box = make('input', { type: 'checkbox' });
  return { box, label: make('label', { class: 'check' }, box, label) };
}

function rank(label: string): { input: HTMLInputElement; label: HTMLLabelElement } {
  const input = make('input', { type: 'number', min: '0', max: '12', step: '1', inputmode: 'numeric' });
  return { input, label: make('label', { class: 'rank-field' }, label, input) };
}

/** Everything inside a sketch, as nodes. `group` keeps the names of its radio buttons apart from those of others. */
export function createParts(group: string) {
  const board = new Board();
  const keysId = `${group}-keys`;
  board.svg.setAttribute('aria-describedby', keysId);

  const tools = new Map<Tool, HTMLInputElement>();
  const toolBox = make('fieldset', { class: 'tools' }, make('legend', {}, 'A press on the board'));
  for (const [tool, label] of TOOLS) {
    const radio = make('input', { type: 'radio', name: `${group}-tool`, value: tool });
    radio.checked = tool === 'move';
    tools.set(tool, radio);
    toolBox.append(make('label', { class: 'check' }, radio, label));
  }
  const remove = button('Delete', 'Remove the selected point (Delete)');
  const undo = button('Undo', 'Take the last change back (Ctrl+Z)');
  const clear = button('Clear', 'Takes all points away');
  const reset = button('Reset', 'As the page had it');
  remove.disabled = undo.disabled = reset.disabled = true;
  const edits = make('div', { class: 'row' }, toolBox);
  const changes = make('div', { class: 'row' }, remove, undo, clear, reset);

  const back = button('Back', 'One landmark less');
  const forward = button('Next landmark', 'The witness farthest from all landmarks becomes one');
  const scale = make('output', { class: 'scale' });
  const steps = make('div', { class: 'row' }, back, forward, scale);

  const insert = button('Insert a', 'The point a becomes a landmark, or ceases to be one');
  insert.setAttribute('aria-pressed', 'false');
  const extra = make('div', { class: 'row' }, insert);

  const ranks = [rank('ν₀'), rank('ν₁'), rank('ν₂')];
  const whole = check('Only Delaunay simplices');
  const nu = make(
    'fieldset',
    { class: 'row ranks' },
    make('legend', { class: 'for-readers' }, 'How far down its list a witness may look'),
    ...ranks.map(({ label }) => label),
    whole.label,
  );

  const layerBoxes = new Map<Layer, HTMLInputElement>();
  const layers = make(
    'fieldset',
    { class: 'row layers' },
    make('legend', { class: 'for-readers' }, 'What is shown'),
  );
  for (const layer of LAYERS) {
    const { box, label } = check(LAYER_NAMES[layer]);
    layerBoxes.set(layer, box);
    layers.append(label);
  }

  const corners = make('input', {
    type: 'text',
    autocomplete: 'off',
    placeholder: '1 2',
  });
  const ask = make('button', { type: 'submit', class: 'button' }, 'Why?');
  const why = make(
    'form',
    { class: 'row' },
    make('label', { class: 'corners' }, 'Why, or why not, landmarks', corners),
    ask,
  );
  const answer = make('p', { class: 'answer', role: 'status' });

  const readout = make('p', { class: 'readout' }, 'Computing…');
  const trouble = make('p', { class: 'trouble', role: 'alert', hidden: '' });
  const spoken = make('p', { class: 'for-readers', 'aria-live': 'polite' });

  const keys = make('dl', { id: keysId });
  const keyRows = KEYS.map(([key, action, needs]) => ({
    needs,
    row: [make('dt', {}, key), make('dd', {}, action)],
  }));
  keys.append(...keyRows.flatMap(({ row }) => row));
  const help = make('details', { class: 'help' }, make('summary', {}, 'Keys on the board'), keys);
  // It scrolls, and so keys must reach it.
  const listBody = make('div', { class: 'lists', tabindex: '0', role: 'group', 'aria-label': 'Figure' });
  const lists = make('details', { class: 'help' }, make('summary', {}, 'The figure in words'), listBody);

  const box = make(
    'div',
    { class: 'sketch' },
    board.svg,
    readout,
    trouble,
    steps,
    extra,
    edits,
    changes,
    nu,
    layers,
    why,
    answer,
    spoken,
    make('div', { class: 'row more' }, help, lists),
  );
  return {
    box,
    board,
    tools,
    remove,
    undo,
    clear,
    reset,
    edits,
    keyRows,
    back,
    forward,
    scale,
    steps,
    insert,
    extra,
    ranks: ranks.map(({ input }) => input),
    whole: whole.box,
    nu,
    layerBoxes,
    layers,
    corners,
    why,
    answer,
    readout,
    trouble,
    spoken,
    help,
    lists,
    listBody,
  };
}

export type SketchParts = ReturnType<typeof createParts>;

/** What the attributes of a sketch ask for. */
export interface Arrangement {
  readonly offer: string | null;
  /** The layers that can be switched on and off; all unless given. */
  readonly layers: string | null;
  /** The core chooses the landmarks. */
  readonly farthestFirst: boolean;
}

/** Shows the controls that are offered, and those of landmarks that the core chooses; tells whether points can be edited. */
export function arrange(parts: SketchParts, { offer, layers, farthestFirst }: Arrangement): boolean {
  const words = wordsOf(offer ?? ALL_OFFERS);
  const offers = (name: Offer): boolean => words.includes(name);
  for (const name of ['edits', 'nu', 'layers', 'why', 'clear'] as const) parts[name].hidden = !offers(name);
  parts.remove.hidden = parts.undo.hidden = !offers('edits');
  parts.steps.hidden = !farthestFirst;
  const switchable = layers === null ? LAYERS : layersIn(layers);
  for (const [layer, box] of parts.layerBoxes)
    box.parentElement?.toggleAttribute(
      'hidden',
      !switchable.includes(layer) || (layer === 'cover' && !farthestFirst),
    );
  const tools: Readonly<Record<Tool, boolean>> = {
    move: true,
    landmark: offers('edits') && !farthestFirst,
    // Where nothing shows what witnesses say there are none yet.
    witness: offers('edits') && switchable.some((layer) => WITNESSED.includes(layer)),
    ask: offers('why'),
  };
  for (const [name, radio] of parts.tools) {
    radio.parentElement?.toggleAttribute('hidden', !tools[name]);
    // A tool that is out of sight is out of hand.
    if (radio.checked && !tools[name]) (parts.tools.get('move') ?? radio).checked = true;
  }
  for (const { needs, row } of parts.keyRows) {
    const there = needs === undefined || (needs in tools ? tools[needs as Tool] : offers(needs as Offer));
    for (const cell of row) cell.hidden = !there;
  }
  const editable = offers('edits');
  parts.board.svg.classList.toggle('fixed', !editable);
  parts.board.svg.classList.toggle('answers', offers('why'));
  return editable;
}
