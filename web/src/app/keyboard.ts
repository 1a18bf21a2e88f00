export interface KeyActions {
  togglePlay(): void;
  /** Forwards or, if negative, back. */
  move(steps: number): void;
  toStart(): void;
  toEnd(): void;
  nextPlateau(): void;
  open(): void;
}

/** Does the element take the key itself? Text fields all, buttons space and enter. */
function takes(target: EventTarget | null, key: string): boolean {
  if (!(target instanceof HTMLElement)) return false;
  if (target instanceof HTMLInputElement)
    return target.type !== 'range' && (target.type !== 'file' || key === ' ');
  if (target instanceof HTMLSelectElement || target instanceof HTMLTextAreaElement) return true;
  return key === ' ' && (target instanceof HTMLButtonElement || target instanceof HTMLAnchorElement);
}

/** The page by keyboard: space, arrows (shift: tenfold), Home, End, P, O. */
export function listenToKeys(actions: KeyActions): void {
  document.addEventListener('keydown', (event) => {
    if (
      event.defaultPrevented ||
      event.ctrlKey ||
      event.metaKey ||
      event.altKey ||
      takes(event.target, event.key)
    )
      return;
    const stride = event.shiftKey ? 10 : 1;
    const byKey: Readonly<Record<string, () => void>> = {
      ' ': () => actions.togglePlay(),
      arrowright: () => actions.move(stride),
      arrowup: () => actions.move(stride),
      arrowleft: () => actions.move(-stride),
      arrowdown: () => actions.move(-stride),
      home: () => actions.toStart(),
      end: () => actions.toEnd(),
      p: () => actions.nextPlateau(),
      o: () => actions.open(),
    };
    const action = byKey[event.key.toLowerCase()];
    if (!action) return;
    event.preventDefault();
    action();
  });
}
