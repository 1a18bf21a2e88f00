import { counted, grouped, readable } from './numbers.ts';
import type { RunRecord } from './record.ts';

/** As many bars as a phone has room for; the last one takes what lies beyond the others. */
const BINS = 12;
/** Which share of the measures the bars tell apart. */
const TOLD_APART = 0.9;
/** Above this relative amplitude nothing is proven of the weights. */
const LARGEST_SAFE_AMPLITUDE = 0.5;

/** Landmarks whose smallest measure lies from `from` up to the next bar's. */
export interface PumpBin {
  readonly from: number;
  readonly before: number;
  readonly after: number;
}

/** What pumping came to over the landmarks of a run. */
export interface PumpHistogram {
  readonly landmarks: number;
  readonly bins: readonly PumpBin[];
  /** Landmarks that got a weight. */
  readonly changed: number;
  readonly largestAmplitude: number;
  /** Found in all, see Pump. */
  readonly thresholds: number;
  /** The first step with an amplitude that is too large; 0: none. */
  readonly unsafeFrom: number;
}

/** The least of 1, 2, 5 times a power of ten that is no smaller. */
function roundedUp(width: number): number {
  const decade = 10 ** Math.floor(Math.log10(width));
  const factor = [1, 2, 5, 10].find((each) => each * decade >= width * (1 - 1e-12)) ?? 10;
  return Number((factor * decade).toPrecision(1));
}

function widthFor(measures: readonly number[]): number {
  const sorted = measures.filter((measure) => measure > 0 && measure < 1).sort((a, b) => a - b);
  const most = sorted[Math.floor(TOLD_APART * (sorted.length - 1))];
  return most === undefined ? 1 / BINS : roundedUp(most / (BINS - 1));
}

/** Undefined where no landmark was pumped. */
export function pumpHistogram(record: RunRecord): PumpHistogram | undefined {
  if (record.pumpCount === 0) return undefined;
  const pumps = Array.from({ length: record.pumpCount }, (_, i) => record.pump(i + 1));
  const width = widthFor(pumps.flatMap(({ before, after }) => [before, after]));
  const binOf = (measure: number): number => Math.min(BINS - 1, Math.floor(measure / width + 1e-9));
  const [before, after] = [new Array<number>(BINS).fill(0), new Array<number>(BINS).fill(0)];
  for (const pump of pumps) {
    before[binOf(pump.before)] = (before[binOf(pump.before)] ?? 0) + 1;
    after[binOf(pump.after)] = (after[binOf(pump.after)] ?? 0) + 1;
  }
  return {
    landmarks: pumps.length,
    bins: before.map((count, i) => ({
      from: Number((i * width).toPrecision(3)),
      before: count,
      after: after[i] ?? 0,
    })),
    changed: pumps.filter(({ weightSquared }) => weightSquared > 0).length,
    largestAmplitude: pumps.reduce((most, { amplitude }) => Math.max(most, amplitude), 0),
    thresholds: pumps.reduce((sum, pump) => sum + pump.thresholds, 0),
    unsafeFrom: 1 + pumps.findIndex(({ amplitude }) => amplitude > LARGEST_SAFE_AMPLITUDE),
  };
}

/** "19 of 300 landmarks got a weight; the largest is 0.73 of the distance to another landmark." */
export function pumpsInWords({ landmarks, changed, largestAmplitude }: PumpHistogram): string {
  const got = `${grouped(changed)} of ${counted(landmarks, 'landmark')} got a weight`;
  return changed === 0
    ? `${got}: nowhere would one leave out a flatter simplex.`
    : `${got}; the largest relative amplitude is ${readable(largestAmplitude)}.`;
}

/** '' where the amplitudes are as the theory wants them. */
export function amplitudeWarning({ unsafeFrom }: PumpHistogram): string {
  return unsafeFrom === 0
    ? ''
    : `From step ${grouped(unsafeFrom)} on a weight is more than half of the distance to the nearest landmark: the theory does not reach that far, and landmarks may be hidden.`;
}

/** "0.02 to 0.04", "0.22 and more". */
export function binInWords(bins: readonly PumpBin[], i: number): string {
  const [from, to] = [bins[i]?.from ?? 0, bins[i + 1]?.from];
  const text = (value: number): string => String(value);
  return to === undefined ? `${text(from)} and more` : `${text(from)} to ${text(to)}`;
}
