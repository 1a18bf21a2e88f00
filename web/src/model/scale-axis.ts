import type { RunRecord } from './record.ts';

/** The ε of steps, from 1 on: they never grow. A record has them, and what is made of several. */
export interface Scales {
  readonly stepCount: number;
  epsilon(step: number): number;
}

/**
 * Steps laid out along ln(1/ε): where a step begins on the axis, and which step is shown at a place. Where ε is 0
 * (all points are landmarks, or only duplicates are left) the last positive ε counts, a little further right.
 */
export interface ScaleAxis {
  readonly low: number;
  /** End of what is computed. */
  readonly computed: number;
  /** End of the axis: beyond `computed` while the run goes on. */
  readonly high: number;
}

/** How the diagram spreads scales out: evenly in ln(1/ε), or in 1/ε itself. */
export type AxisKind = 'log' | 'linear';

/** Where on an evenly divided ruler a scale lies. */
export function spread(kind: AxisKind, scale: number): number {
  return kind === 'log' ? scale : Math.exp(scale);
}

/** The scale at a place of the ruler. */
export function scaleAtPlace(kind: AxisKind, place: number): number {
  return kind === 'log' ? place : Math.log(Math.max(place, Number.MIN_VALUE));
}

/** The room for the last step, and for steps with ε = 0. */
const TAIL = 0.12;

export function scaleOf(record: Scales, step: number): number {
  const epsilon = record.epsilon(step);
  if (epsilon > 0) return -Math.log(epsilon);
  const last = lastPositiveStep(record);
  return (last === 0 ? 0 : -Math.log(record.epsilon(last))) + TAIL / 2;
}

/** The last computed step with ε > 0, 0 if there is none. ε never grows. */
export function lastPositiveStep(record: Scales): number {
  return lastStepWhere(record, (step) => record.epsilon(step) > 0);
}

/** The last step for which the condition holds; it must hold up to some step and not after. 0: for none. */
export function lastStepWhere(record: Scales, holds: (step: number) => boolean): number {
  let low = 0;
  let high = record.stepCount;
  while (low < high) {
    const middle = low + Math.ceil((high - low) / 2);
    if (holds(middle)) low = middle;
    else high = middle - 1;
  }
  return low;
}

/** The last step that begins at the place or before; at least 1. */
export function stepAt(record: Scales, scale: number): number {
  return Math.max(
    1,
    lastStepWhere(record, (step) => scaleOf(record, step) <= scale),
  );
}

/** The last step that begins before the place; 0 if there is none. */
export function stepBefore(record: Scales, scale: number): number {
  return lastStepWhere(record, (step) => scaleOf(record, step) < scale);
}

/**
 * How far the scale will reach: the growth of the last half of the steps goes on. Rounded up to quarters, so that the
 * axis grows in a few jumps and does not creep.
 */
export function axisOf(record: RunRecord): ScaleAxis {
  const count = record.stepCount;
  if (count === 0) return { low: 0, computed: 0, high: 1 };
  const low = scaleOf(record, 1);
  const computed = scaleOf(record, count) + TAIL;
  if (record.ended || count >= record.stepsPlanned)
    return { low, computed, high: Math.max(computed, low + TAIL) };
  const half = Math.max(1, count >>> 1);
  const slope = count > half ? (scaleOf(record, count) - scaleOf(record, half)) / Math.log(count / half) : 1;
  const expected = computed + slope * Math.log(record.stepsPlanned / count);
  const high = low + Math.ceil((Math.max(expected, computed) - low) * 4) / 4;
  return { low, computed, high: Math.max(high, low + 1) };
}

/** The part of ln(1/ε) that a diagram shows. */
export type ScaleRange = Pick<ScaleAxis, 'low' | 'high'>;

/** One axis on which several runs can be laid out. */
export function jointRange(records: readonly RunRecord[]): ScaleRange {
  const axes = records.filter(({ stepCount }) => stepCount > 0).map(axisOf);
  if (axes.length === 0) return { low: 0, high: 1 };
  return { low: Math.min(...axes.map(({ low }) => low)), high: Math.max(...axes.map(({ high }) => high)) };
}
