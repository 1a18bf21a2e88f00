export interface KeyActions {
  togglePlay(): void;
  /** Forwards or, if negative, back. */
  move(steps: number): void;
  toStart(): void;
  toEnd(): void;
  undo(): void;
  redo(): void;
  /** Turns the shape by parts of a full turn. */
  turn(across: number, upright: number): void;
  /** Nearer by a factor above 1. */
  zoom(factor: number): void;
  /** What a single letter, digit or sign does; these can be switched off. */
  readonly single: Readonly<Record<string, () => void>>;
  singleKeysOn(): boolean;
}

/** By how much one key turns the shape, in full turns, and brings it nearer. */
const TURN = 1 / 48;
const ZOOM = 1.1;

/** Does the element take the key itself? Text fields all, buttons space and enter. */
function takes(target: EventTarget | null, key: string): boolean {
  if (!(target instanceof HTMLElement)) return false;
  if (target instanceof HTMLInputElement) {
    if (target.type === 'checkbox') return key === ' ';
    // Of the sliders only the one of the film means what the arrows mean everywhere.
    if (target.type === 'range') return target.id !== 'step' && /^(arrow|home|end)/i.test(key);
    return target.type !== 'file' || key === ' ';
  }
  if (target instanceof HTMLSelectElement || target instanceof HTMLTextAreaElement) return true;
  return key === ' ' && target.matches('button, a, summary');
}

function isText(target: EventTarget | null): boolean {
  return target instanceof HTMLInputElement && !['checkbox', 'range', 'file'].includes(target.type);
}

/** The page by keyboard: space, arrows (shift: tenfold), Home, End, undo and redo, and the single keys. */
export function listenToKeys(actions: KeyActions): void {
  document.addEventListener('keydown', (event) => {
    // A sheet over the page keeps its keys; one beside the shape does not.
    if (event.defaultPrevented || event.altKey || document.querySelector('dialog:modal')) return;
    const key = event.key.toLowerCase();
    if (event.ctrlKey || event.metaKey) {
      if (isText(event.target) || (key !== 'z' && key !== 'y')) return;
      event.preventDefault();
      if (key === 'y' || event.shiftKey) actions.redo();
      else actions.undo();
      return;
    }
    if (takes(event.target, event.key)) return;
    const stride = event.shiftKey ? 10 : 1;
    const onShape: Readonly<Record<string, () => void>> = {
      arrowright: () => actions.turn(TURN, 0),
      arrowleft: () => actions.turn(-TURN, 0),
      arrowup: () => actions.turn(0, TURN),
      arrowdown: () => actions.turn(0, -TURN),
      '+': () => actions.zoom(ZOOM),
      '=': () => actions.zoom(ZOOM),
      '-': () => actions.zoom(1 / ZOOM),
    };
    const byKey: Readonly<Record<string, () => void>> = {
      ' ': () => actions.togglePlay(),
      arrowright: () => actions.move(stride),
      arrowup: () => actions.move(stride),
      arrowleft: () => actions.move(-stride),
      arrowdown: () => actions.move(-stride),
      home: () => actions.toStart(),
      end: () => actions.toEnd(),
    };
    const atShape =
      event.target instanceof HTMLElement && event.target.id === 'shape' ? onShape[key] : undefined;
    const action = atShape ?? byKey[key] ?? (actions.singleKeysOn() ? actions.single[key] : undefined);
    if (!action) return;
    event.preventDefault();
    action();
  });
}
