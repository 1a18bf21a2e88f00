export interface KeyActions {
  togglePlay(): void;
  /** Forwards or, if negative, back. */
  move(steps: number): void;
  toStart(): void;
  toEnd(): void;
  undo(): void;
  redo(): void;
  /** What a single letter, digit or sign does; these can be switched off. */
  readonly single: Readonly<Record<string, () => void>>;
  singleKeysOn(): boolean;
}

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
    // An open sheet keeps its keys.
    if (event.defaultPrevented || event.altKey || document.querySelector('dialog[open]')) return;
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
    const byKey: Readonly<Record<string, () => void>> = {
      ' ': () => actions.togglePlay(),
      arrowright: () => actions.move(stride),
      arrowup: () => actions.move(stride),
      arrowleft: () => actions.move(-stride),
      arrowdown: () => actions.move(-stride),
      home: () => actions.toStart(),
      end: () => actions.toEnd(),
    };
    const action = byKey[key] ?? (actions.singleKeysOn() ? actions.single[key] : undefined);
    if (!action) return;
    event.preventDefault();
    action();
  });
}
