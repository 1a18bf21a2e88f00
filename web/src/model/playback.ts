import { scaleOf, stepAt, type Scales } from './scale-axis.ts';

/** The first landmarks are seen one by one. */
const SINGLE_STEPS = 20;
const SINGLE_STEP_MS = 320;
/** Afterwards time runs with ln(1/ε): seconds for one e-fold of scale. */
const MS_PER_E_FOLD = 4_000;
/** Where many steps share one ε (grids), at most this factor more landmarks a second. */
const GROWTH_PER_SECOND = 2.5;

/**
 * The film: where the playhead is after a while. It holds the fraction of a step that a frame leaves over, so the
 * pace does not depend on the frame rate.
 */
export class Playback {
  private waited = 0;
  private scale: number | undefined;
  /** Times the usual pace. */
  speed = 1;

  /** Forgets the fraction: the playhead was moved by hand. */
  restart(): void {
    this.waited = 0;
    this.scale = undefined;
  }

  /** The step to show `passedMs` after `step` was; never beyond what is computed. */
  advance(record: Scales, step: number, passedMs: number): number {
    const elapsedMs = passedMs * this.speed;
    if (step >= record.stepCount) {
      this.restart();
      return step;
    }
    if (step < SINGLE_STEPS) {
      this.waited += elapsedMs;
      if (this.waited < SINGLE_STEP_MS) return step;
      this.waited = Math.min(this.waited - SINGLE_STEP_MS, SINGLE_STEP_MS);
      return step + 1;
    }
    const from = this.scale ?? scaleOf(record, step);
    this.scale = from + elapsedMs / MS_PER_E_FOLD;
    const growth = Math.max(1, Math.floor(step * (GROWTH_PER_SECOND ** (elapsedMs / 1000) - 1)));
    const next = Math.min(stepAt(record, this.scale), step + growth, record.stepCount);
    if (next < stepAt(record, this.scale)) this.scale = scaleOf(record, next);
    return Math.max(step, next);
  }
}
