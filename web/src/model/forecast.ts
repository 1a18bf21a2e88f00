import { grouped, readable } from './numbers.ts';
import type { RunRecord } from './record.ts';

/** Below this many steps nothing is foretold. */
const LEAST_STEPS = 100;
/** The rate is that of the last so many milliseconds. */
const RATE_OVER_MS = 8_000;
/** A cloud of this many points is a scan: it ends at its noise unless asked otherwise, and says what it takes. */
export const SCAN_POINTS = 20_000;
/** What takes this much says so, however few its points: distances grow with the square of them. */
const MUCH_MEMORY = 50 * 2 ** 20;
const SAID_OF_DISTANCES = 10 * 2 ** 20;

/** ln ε falls with ln step as over the last half of the steps; per unit of ln step. */
function fall(record: RunRecord): number | undefined {
  const count = record.stepCount;
  if (count < LEAST_STEPS || record.epsilon(count) === 0) return undefined;
  const half = count >>> 1;
  const slope = Math.log(record.epsilon(half) / record.epsilon(count)) / Math.log(count / half);
  return slope > 0 ? slope : undefined;
}

/** ε at a step that is not computed yet. */
export function expectedEpsilon(record: RunRecord, step: number): number | undefined {
  const slope = fall(record);
  if (slope === undefined) return undefined;
  return record.epsilon(record.stepCount) * (record.stepCount / step) ** slope;
}

/** The step at which the run will end: all landmarks, the memory, or the noise, whichever comes first. */
export function expectedEnd(record: RunRecord): number {
  const most = Math.max(record.stepCount, Math.min(record.stepsPlanned, record.stepsAffordable));
  const slope = fall(record);
  if (record.noise === 0 || slope === undefined) return most;
  const atNoise = record.stepCount * (record.epsilon(record.stepCount) / record.noise) ** (1 / slope);
  return Math.min(most, Math.ceil(atNoise));
}

/** Steps a second, from when they came. */
export class StepRate {
  private readonly seen: { at: number; steps: number }[] = [];

  see(at: number, steps: number): void {
    if (steps !== this.seen.at(-1)?.steps) this.seen.push({ at, steps });
    while (this.seen.length > 2 && at - (this.seen[1]?.at ?? at) > RATE_OVER_MS) this.seen.shift();
  }

  /** Undefined until there is something to measure. */
  get perSecond(): number | undefined {
    const [first, last] = [this.seen[0], this.seen.at(-1)];
    if (!first || !last || last.at - first.at < 500) return undefined;
    return (1000 * (last.steps - first.steps)) / (last.at - first.at);
  }
}

/** "about 40 s", "about 3 min", "about 2 h 10 min"; as exact as a guess deserves. */
export function durationInWords(seconds: number): string {
  if (seconds < 3) return 'a moment';
  if (seconds < 60) return `about ${Math.ceil(seconds / 5) * 5} s`;
  const minutes = Math.ceil(seconds / 60);
  if (minutes < 60) return `about ${minutes} min`;
  const rest = minutes % 60;
  return `about ${Math.floor(minutes / 60)} h${rest === 0 ? '' : ` ${rest} min`}`;
}

/** "312 MB", "1.2 GB". */
export function memoryInWords(bytes: number): string {
  const megabytes = bytes / 2 ** 20;
  return megabytes < 1000
    ? `${Math.max(1, Math.round(megabytes))}\u00a0MB`
    : `${(megabytes / 1024).toFixed(1)}\u00a0GB`;
}

/** What a run holds, or will. */
function memoryOf(record: RunRecord): number {
  const { ended, memoryBytes, estimatedBytes, memoryLimitBytes } = record;
  return ended ? memoryBytes : Math.max(memoryBytes, Math.min(estimatedBytes, memoryLimitBytes));
}

/** What a second run may take: both live in one memory. `replaced`: one that is closed as soon as the second is open. */
export function memoryBeside(first: RunRecord, replaced?: RunRecord): number {
  return Math.max(0, first.memoryLimitBytes - memoryOf(first) - (replaced ? memoryOf(replaced) : 0));
}

/** "computed 1,234 of 100,000", and for a scan what memory and time it takes. */
export function progressInWords(record: RunRecord, rate: number | undefined): string {
  const parts = [`computed ${grouped(record.stepCount)} of ${grouped(record.stepsPlanned)}`];
  if (record.frame.count < SCAN_POINTS && record.estimatedBytes < MUCH_MEMORY) return parts.join('');
  const needed = memoryInWords(Math.min(record.estimatedBytes, record.memoryLimitBytes));
  parts.push(
    record.memoryBytes > 0
      ? `${memoryInWords(record.memoryBytes)} in use of about ${needed}`
      : `about ${needed} needed`,
  );
  // The first landmarks change the lists of all points and say nothing of the pace of later ones.
  if (rate !== undefined && rate > 0 && record.stepCount >= record.frame.count / 100) {
    const most = record.minLength > 0 ? 'at most ' : '';
    parts.push(`${most}${durationInWords((expectedEnd(record) - record.stepCount) / rate)} left`);
  }
  return parts.join(' · ');
}

/** What a table of so many columns takes if it is one of distances, all pairs in double precision. */
export function distancesInWords(columns: number): string {
  const bytes = (columns * (columns - 1) * 8) / 2;
  if (bytes < SAID_OF_DISTANCES) return '';
  return `As distances of ${grouped(columns)} points they would take up to ${memoryInWords(bytes)}.`;
}

/** Rounded to two digits: 268,123 as "270,000". */
function roughly(count: number): string {
  return grouped(Number(count.toPrecision(2)));
}

/** What a scan will take, and where a run ends before its last point by itself: memory, noise, a plateau; '' otherwise. */
export function scanInWords(record: RunRecord, readMs: number): string {
  const { stepsAffordable, stepsPlanned, noise, endedAtNoise, minLength } = record;
  const sentences: string[] = [];
  const computing = !record.ended;
  if (stepsAffordable < stepsPlanned && computing) {
    const epsilon = expectedEpsilon(record, stepsAffordable);
    const downTo = epsilon === undefined ? '' : `, down to ε ≈ ${readable(Number(epsilon.toPrecision(2)))}`;
    sentences.push(
      `${grouped(record.frame.count)} points, read in ${(readMs / 1000).toFixed(1)} s. ` +
        `The memory of this page (${memoryInWords(record.memoryLimitBytes)}) is enough for about ` +
        `${roughly(stepsAffordable)} landmarks${downTo}.`,
    );
  }
  if (endedAtNoise) sentences.push(`Stopped at the noise, ε = ${readable(noise)}.`);
  else if (noise > 0 && computing) sentences.push(`Stops at the noise, ε = ${readable(noise)}.`);
  if (record.endedAtPlateau) sentences.push(`Stopped at a plateau of length ${readable(minLength)}.`);
  else if (minLength > 0 && computing) sentences.push(`Stops at a plateau of length ${readable(minLength)}.`);
  if (record.agreesWithSession === false) {
    sentences.push('These steps are not those of the saved session: another version computed them.');
  }
  return sentences.join(' ');
}
