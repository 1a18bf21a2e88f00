import type { RunRecord } from './record.ts';
import { lastStepWhere } from './scale-axis.ts';

/**
 * The steps of two runs in one order, from coarse to fine: along it one film shows both. It reaches as far as both are
 * computed, so that no step comes in between later; a run that has ended holds nothing up.
 */
export class MergedScales {
  constructor(
    private readonly first: RunRecord,
    private readonly second: RunRecord,
  ) {}

  get ended(): boolean {
    return this.first.ended && this.second.ended;
  }

  get stepCount(): number {
    const [first, second] = this.counts;
    return first + second;
  }

  /** The ε of a step, from 1 on. */
  epsilon(step: number): number {
    const [count, countSecond] = this.counts;
    const { first, second } = this;
    // Of the `step` coarsest, the fewest of the first run such that the rest is of the second.
    let low = Math.max(0, step - countSecond);
    let high = Math.min(step, count);
    while (low < high) {
      const middle = (low + high) >>> 1;
      if (second.epsilon(step - middle) >= first.epsilon(middle + 1)) high = middle;
      else low = middle + 1;
    }
    const ofFirst = low > 0 ? first.epsilon(low) : Infinity;
    return Math.min(ofFirst, step > low ? second.epsilon(step - low) : Infinity);
  }

  /** How many steps of each are coarse enough to be complete. */
  private get counts(): readonly [number, number] {
    const { first, second } = this;
    const reached = Math.max(reachedBy(first), reachedBy(second));
    const within = (run: RunRecord): number => lastStepWhere(run, (step) => run.epsilon(step) >= reached);
    return [within(first), within(second)];
  }
}

/** The ε down to which a run is computed: 0 if no more will come. */
function reachedBy(run: RunRecord): number {
  if (run.ended) return 0;
  return run.stepCount > 0 ? run.epsilon(run.stepCount) : Infinity;
}
