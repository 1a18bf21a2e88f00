import { FIRST_AXES, keptBy, rowsOf, withAxis, type AxisChoice } from '../model/dimensions.ts';
import type { ShapeView } from '../view/shape-view.ts';
import type { CloudFrame } from '../worker/protocol.ts';
import { byId } from './dom.ts';

/** The first hidden axis takes so long to turn once around. */
const TURN_MS = 60_000;

/** Of a cloud in more than three dimensions: which of its axes are shown, and the slow turn through all of them. */
export class DimensionTools {
  private readonly selects = ['axis-right', 'axis-up', 'axis-near'].map((id) => byId(id, HTMLSelectElement));
  private readonly turning = byId('turn-dimensions', HTMLInputElement);
  private readonly note = byId('projection', HTMLElement);
  private frame: CloudFrame | undefined;
  private shape: ShapeView | undefined;
  private beside: ShapeView | undefined;
  private choice: AxisChoice = FIRST_AXES;
  private angle = 0;
  private before: number | undefined;
  private request = 0;

  constructor() {
    this.selects.forEach((select, i) => {
      select.addEventListener('input', () => {
        this.choice = withAxis(this.choice, i === 0 ? 0 : i === 1 ? 1 : 2, Number(select.value));
        this.angle = 0;
        this.apply();
      });
    });
    this.turning.addEventListener('input', () => this.wake());
  }

  attach(shape: ShapeView | undefined): void {
    this.shape = shape;
  }

  /** Another one of the same points, which is shown and turned alike. */
  attachBeside(shape: ShapeView | undefined): void {
    this.beside = shape;
    this.apply();
  }

  /** Another cloud: its first axes, which keep most. */
  show(frame: CloudFrame): void {
    this.frame = frame;
    this.choice = FIRST_AXES;
    this.angle = 0;
    const projected = frame.axes > 3;
    byId('dimensions', HTMLElement).hidden = !projected;
    if (!projected) this.turning.checked = false;
    for (const select of this.selects) {
      const options = frame.shares.map(
        (share, axis) => new Option(`axis ${axis + 1} (${percent(share)})`, String(axis)),
      );
      select.replaceChildren(...options);
    }
    this.apply();
  }

  toggleTurning(): void {
    if (this.frame && this.frame.axes > 3) this.turning.click();
  }

  private apply(): void {
    const { frame } = this;
    if (!frame) return;
    const rows = rowsOf(frame.axes, this.choice, this.angle);
    this.shape?.project(rows);
    this.beside?.project(rows);
    byId('plateau', HTMLElement).dataset['turned'] = String(this.angle);
    this.selects.forEach((select, i) => (select.value = String(this.choice[i])));
    const words = projectionInWords(frame, rows);
    this.note.hidden = words === '';
    if (this.note.textContent !== words) this.note.textContent = words;
  }

  private wake(): void {
    // Off and on again within one picture must not start a second clock.
    cancelAnimationFrame(this.request);
    this.before = undefined;
    this.request = requestAnimationFrame((now) => this.turn(now));
  }

  private turn(now: number): void {
    if (!this.turning.checked) return;
    this.angle += ((now - (this.before ?? now)) / TURN_MS) * 2 * Math.PI;
    this.before = now;
    this.apply();
    this.request = requestAnimationFrame((next) => this.turn(next));
  }
}

/** What a picture of more than three dimensions, or of distances, keeps; '' for points as they are. */
export function projectionInWords({ shares }: CloudFrame, rows: Float32Array): string {
  return shares.length === 0 ? '' : `A projection: it keeps ${percent(keptBy(rows, shares))} of the spread.`;
}

const percent = (share: number): string => `${Math.round(100 * share)} %`;
