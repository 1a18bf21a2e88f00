import { BOARD, onBoard, type Point } from './points.ts';
import { pointInWords } from './sketch-words.ts';
import type { Naming } from './names.ts';
import * as states from './sketch-state.ts';
import type { PointKind, PointName, SketchState } from './sketch-state.ts';

/** Whose state is edited. */
export interface EditorHost {
  /** Another state; while a drag lasts it is not one to keep. */
  changed(lasting: boolean): void;
  /** Another point is selected, or the cross has moved. */
  redraw(): void;
  say(sentence: string): void;
  /** Farthest first: the witnesses in the order in which they become landmarks. */
  order(): readonly number[] | undefined;
  /** The nearest landmarks of a witness. */
  list(witness: number): readonly number[] | undefined;
  readonly landmarkName: Naming;
}

/** What a reader does to the points of a sketch: selects, moves, adds, removes, and takes it back. */
export class SketchEditor {
  state: SketchState = states.stateFrom(() => null);
  /** Otherwise points can be selected, and nothing else. */
  editable = true;
  selected: PointName | undefined;
  /** Where the keyboard would put a point. */
  pen: Point = { x: BOARD.width / 2, y: BOARD.height / 2 };
  /** The witness that goes with the selected landmark. */
  private own: number | undefined;
  private past: SketchState[] = [];
  private dragFrom: SketchState | undefined;

  constructor(private readonly host: EditorHost) {}

  get canUndo(): boolean {
    return this.past.length > 0;
  }

  /** A state from elsewhere: nothing before it can be come back to. */
  open(state: SketchState): void {
    this.state = state;
    this.past = [];
    this.dragFrom = undefined;
    this.select(undefined);
  }

  /** Another state, which can be undone. */
  commit(next: SketchState): void {
    this.past.push(this.state);
    this.state = next;
    this.host.changed(true);
  }

  /** Another question about the same points: nothing to compute, and nothing to undo. */
  ask(asked: readonly string[]): void {
    this.state = { ...this.state, asked };
  }

  select(chosen: PointName | undefined): void {
    const name = this.witnessOf(chosen);
    const left = this.selected && states.pointAt(this.state, this.selected);
    if (left) this.pen = left;
    this.selected = name;
    this.own = name && states.ownWitness(this.state, name);
    if (name) this.host.say(this.selectedInWords());
    this.host.redraw();
  }

  step(forward: boolean): void {
    this.select(states.nextPoint(this.state, this.selected, forward));
  }

  nudge(dx: number, dy: number): void {
    if (!this.editable) return;
    const place = this.selected && states.pointAt(this.state, this.selected);
    if (!this.selected || !place) {
      this.pen = onBoard(this.pen.x + dx, this.pen.y + dy);
      this.host.redraw();
    } else {
      const next = states.moved(this.state, this.selected, onBoard(place.x + dx, place.y + dy), this.own);
      if (next) this.commit(next);
    }
    this.host.say(this.selectedInWords());
  }

  drag(place: Point): void {
    if (!this.editable || !this.selected) return;
    const next = states.moved(this.state, this.selected, place, this.own);
    if (!next) return;
    this.dragFrom ??= this.state;
    this.state = next;
    this.host.changed(false);
  }

  /** What a drag did counts as one change. */
  drop(): void {
    if (!this.dragFrom) return;
    this.past.push(this.dragFrom);
    this.dragFrom = undefined;
    this.host.changed(true);
  }

  add(kind: PointKind, place = this.pen): void {
    if (!this.editable) return;
    if (kind === 'landmark' && this.state.step > 0) {
      this.host.say('Landmarks are chosen farthest first here: take the next one instead.');
      return;
    }
    const next = states.added(this.state, kind, place);
    if (!next) {
      this.host.say(`There is no room for another ${kind} at ${place.x}, ${place.y}.`);
      return;
    }
    this.commit(next);
    this.select({ kind, index: states.pointsOf(next, kind).length - 1 });
  }

  remove(): void {
    if (!this.editable || !this.selected) return;
    const next = states.removed(this.state, this.selected);
    const said = this.selectedInWords();
    this.select(undefined);
    this.commit(next);
    this.host.say(`Removed: ${said}`);
  }

  /** An empty board, to begin afresh. */
  clear(): void {
    this.select(undefined);
    this.commit({ ...this.state, landmarks: [], witnesses: [], asked: [] });
  }

  undo(): void {
    const before = this.editable ? this.past.pop() : undefined;
    if (!before) return;
    // The question stays, to be answered before and after; unless its landmarks have other names then.
    const { landmarks, asked } = this.state;
    this.state = before.landmarks.length === landmarks.length ? { ...before, asked } : before;
    this.select(undefined);
    this.host.changed(true);
  }

  selectedInWords(): string {
    const { selected, state, pen } = this;
    const place = selected && states.pointAt(state, selected);
    if (!selected || !place) return `Cross at ${pen.x}, ${pen.y}`;
    return pointInWords(selected, place, this.host.landmarkName, this.host.list(selected.index));
  }

  /** Farthest first, a landmark is one of the witnesses. */
  private witnessOf(name: PointName | undefined): PointName | undefined {
    if (name?.kind !== 'landmark' || this.state.step === 0) return name;
    const index = this.host.order()?.[name.index];
    return index === undefined ? undefined : { kind: 'witness', index };
  }
}
