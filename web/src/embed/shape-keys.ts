/** What keys do while the shape has the focus. */
export interface ShapeKeys {
  /** By parts of a full turn. */
  turn(across: number, upright: number): void;
  /** Nearer by a factor above 1. */
  zoom(factor: number): void;
  togglePlay(): void;
}

/** By how much one key turns the shape, in full turns, and brings it nearer. */
const TURN = 1 / 48;
const ZOOM = 1.1;

/** Listens on the shape alone: what an element is part of keeps its own keys. */
export function listenToShapeKeys(shape: HTMLElement, keys: ShapeKeys): void {
  const byKey: Readonly<Record<string, () => void>> = {
    ArrowRight: () => keys.turn(TURN, 0),
    ArrowLeft: () => keys.turn(-TURN, 0),
    ArrowUp: () => keys.turn(0, TURN),
    ArrowDown: () => keys.turn(0, -TURN),
    '+': () => keys.zoom(ZOOM),
    '=': () => keys.zoom(ZOOM),
    '-': () => keys.zoom(1 / ZOOM),
    ' ': () => keys.togglePlay(),
  };
  shape.addEventListener('keydown', (event) => {
    const action = byKey[event.key];
    if (!action || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    action();
  });
}
