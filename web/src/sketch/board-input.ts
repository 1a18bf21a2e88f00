import type { Board, Target } from './board.ts';
import { onBoard, type Point } from './points.ts';
import type { PointKind, PointName } from './sketch-state.ts';

/** What a press on the board does. */
export type Tool = 'move' | 'landmark' | 'witness' | 'ask';

/** What the board's hands can do; each says itself what came of it. */
export interface BoardActions {
  readonly tool: () => Tool;
  /** Otherwise a press selects, and keys and fingers that would change something are left to the page. */
  readonly editable: () => boolean;
  select(name: PointName | undefined): void;
  /** The next point, or the one before. */
  step(forward: boolean): void;
  /** By so much, the selected point or the pen. */
  nudge(dx: number, dy: number): void;
  /** The selected point is there now. */
  drag(place: Point): void;
  /** A drag ends: what it did counts as one change. */
  drop(): void;
  /** Without a place: at the pen. */
  add(kind: PointKind, place?: Point): void;
  remove(): void;
  pick(target: Target): void;
  pickSelected(): void;
  undo(): void;
  /** The focus came, and the pen may be shown. */
  focus(on: boolean): void;
}

const LARGE_STEP = 5;
/** In units of the board: a press that moves less is a press. */
const STILL = 0.7;

/** Mouse, pen and finger. */
export function listenToPointers(board: Board, actions: BoardActions): void {
  const { svg } = board;
  let held: { readonly from: Point; moved: boolean } | undefined;

  svg.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    const place = board.placeOf(event);
    const target = board.targetOf(event);
    if (!place) return;
    const tool = actions.tool();
    if (target && target.kind !== 'simplex' && tool !== 'ask') {
      board.hold(event.target);
      actions.select(target);
      held = { from: place, moved: false };
      svg.setPointerCapture(event.pointerId);
      return;
    }
    if (target && (tool === 'ask' || tool === 'move')) {
      actions.pick(target);
      return;
    }
    if (tool === 'landmark' || tool === 'witness') actions.add(tool, onBoard(place.x, place.y));
    else actions.select(undefined);
  });
  svg.addEventListener('pointermove', (event) => {
    const place = held && board.placeOf(event);
    if (!held || !place) return;
    held.moved ||= Math.hypot(place.x - held.from.x, place.y - held.from.y) > STILL;
    if (held.moved) actions.drag(onBoard(place.x, place.y));
  });
  // A finger on a point that can be moved moves it; anywhere else it scrolls the page.
  svg.addEventListener(
    'touchstart',
    (event) => {
      if (!actions.editable() || actions.tool() === 'ask') return;
      const target = board.targetOf(event);
      if (target && target.kind !== 'simplex') event.preventDefault();
    },
    { passive: false },
  );
  const release = (): void => {
    board.hold(null);
    if (held?.moved) actions.drop();
    held = undefined;
  };
  svg.addEventListener('pointerup', release);
  svg.addEventListener('pointercancel', release);
}

/** Keys while the board has the focus; all else is left to the page. */
export function listenToBoardKeys(board: Board, actions: BoardActions): void {
  const { svg } = board;
  const arrows: Readonly<Record<string, readonly [number, number]>> = {
    ArrowLeft: [-1, 0],
    ArrowRight: [1, 0],
    ArrowUp: [0, 1],
    ArrowDown: [0, -1],
  };
  const edits: Readonly<Record<string, () => void>> = {
    l: () => actions.add('landmark'),
    w: () => actions.add('witness'),
    delete: () => actions.remove(),
    backspace: () => actions.remove(),
  };
  const keys: Readonly<Record<string, () => void>> = {
    n: () => actions.step(true),
    p: () => actions.step(false),
    ' ': () => actions.pickSelected(),
    enter: () => actions.pickSelected(),
    escape: () => actions.select(undefined),
  };
  svg.addEventListener('keydown', (event) => {
    if (event.altKey) return;
    if (event.ctrlKey || event.metaKey) {
      if (event.key.toLowerCase() !== 'z' || !actions.editable()) return;
      event.preventDefault();
      actions.undo();
      return;
    }
    const name = event.key.toLowerCase();
    const arrow = actions.editable() ? arrows[event.key] : undefined;
    const key = keys[name] ?? (actions.editable() ? edits[name] : undefined);
    if (!arrow && !key) return;
    event.preventDefault();
    const size = event.shiftKey ? LARGE_STEP : 1;
    if (arrow) actions.nudge(size * arrow[0], size * arrow[1]);
    else key?.();
  });
  svg.addEventListener('focus', () => actions.focus(true));
  svg.addEventListener('blur', () => actions.focus(false));
}
