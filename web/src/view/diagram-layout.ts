import { grouped, readable } from '../model/numbers.ts';
import type { PlateauCard } from '../model/plateau-cards.ts';
import type { RunRecord } from '../model/record.ts';
import {
  axisOf,
  scaleAtPlace,
  scaleOf,
  spread,
  stepAt,
  type AxisKind,
  type ScaleAxis,
  type ScaleRange,
} from '../model/scale-axis.ts';
import { bettiList } from '../model/words.ts';
import type { ShownFamily } from '../worker/protocol.ts';

/** The Betti diagram as places on paper: the canvas on the page and the SVG file draw the same. */
export interface DiagramLayout {
  readonly width: number;
  readonly height: number;
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;
  readonly axis: ScaleAxis;
  readonly kind: AxisKind;
  readonly bands: readonly Band[];
  /** The bands of an earlier run, for a strip of their own above the others. */
  readonly earlier: readonly Band[];
  readonly columns: readonly Tick[];
  readonly lines: readonly Tick[];
  /** β0, β1, …: corners of stepped lines, x and y in turn. */
  readonly series: readonly number[][];
  /** What is not computed yet: from here to `right`. */
  readonly computedTo: number;
}

export interface Band {
  readonly from: number;
  readonly to: number;
  readonly family: ShownFamily;
  /** "1, 2, 1". */
  readonly label: string;
}

export interface Tick {
  readonly at: number;
  readonly label: string;
}

export interface DiagramSize {
  readonly width: number;
  readonly height: number;
  /** Columns a unit in which many steps are drawn as one upright stroke. */
  readonly resolution: number;
  /** Logarithmic unless asked otherwise. */
  readonly kind?: AxisKind;
  /** Plateaus of an earlier run of the same points to compare with. */
  readonly earlier?: readonly PlateauCard[];
  /** The part of the scale to show; without it, that of the run. */
  readonly range?: ScaleRange | undefined;
}

/** Height of the strip of earlier bands, and its distance from what is below. */
export const STRIP = { height: 16, gap: 8 };

const MARGIN = { left: 48, right: 16, top: 12, bottom: 36 };
/** Equal Betti numbers are drawn side by side, this far apart. */
const SIDE_BY_SIDE = 3;
/** Room above the lines for the Betti numbers of the bands. */
const LABEL_ROOM = 18;

type Ruled = Pick<DiagramLayout, 'axis' | 'kind' | 'left' | 'right'>;

/** Units of the paper for one of the ruler. */
function density({ axis, kind, left, right }: Ruled): number {
  return (right - left) / (spread(kind, axis.high) - spread(kind, axis.low));
}

export function scaleToX(layout: Ruled, scale: number): number {
  const { kind, axis } = layout;
  return layout.left + (spread(kind, scale) - spread(kind, axis.low)) * density(layout);
}

export function xToScale(layout: Ruled, x: number): number {
  const { kind, axis } = layout;
  return scaleAtPlace(kind, spread(kind, axis.low) + (x - layout.left) / density(layout));
}

/** Betti numbers of plateaus are small, those in between can be thousands: linear up to 3, logarithmic above. */
function height(betti: number): number {
  return Math.min(betti, 3) + 0.6 * Math.log1p(Math.max(0, betti - 3));
}

const NUMBERS = [0, 1, 2, 3, 5, 10, 20, 50];

function bettiTicks(most: number): number[] {
  const ticks = NUMBERS.filter((value) => value <= most);
  for (let decade = 100; decade <= most; decade *= 10) {
    ticks.push(...[1, 2, 5].map((factor) => factor * decade).filter((value) => value <= most));
  }
  return ticks;
}

/** 1, 2, 5 in each decade of 1/ε; only the decades where the axis is long. */
function scaleTicks(axis: ScaleAxis, width: number): number[] {
  const perDecade = (width / (axis.high - axis.low)) * Math.LN10;
  const factors = perDecade > 150 ? [1, 2, 5] : perDecade > 80 ? [1, 3] : [1];
  const every = Math.max(1, Math.ceil(60 / perDecade));
  const ticks: number[] = [];
  for (let decade = Math.floor(axis.low / Math.LN10); decade <= axis.high / Math.LN10; ++decade) {
    if (decade % every !== 0) continue;
    for (const factor of factors) {
      const value = factor * 10 ** decade;
      const scale = Math.log(value);
      if (scale >= axis.low - 1e-9 && scale <= axis.high) ticks.push(value);
    }
  }
  return ticks;
}

/** Round values of 1/ε, evenly apart. */
function evenTicks(axis: ScaleAxis, width: number): number[] {
  const from = Math.exp(axis.low);
  const to = Math.exp(axis.high);
  const least = ((to - from) / width) * 70;
  const decade = 10 ** Math.floor(Math.log10(least));
  const apart = decade * ([1, 2, 5].find((factor) => factor * decade >= least) ?? 10);
  const ticks: number[] = [];
  for (let k = Math.ceil(from / apart); k * apart <= to; ++k) ticks.push(k * apart);
  return ticks;
}

/** Steps that fall into one column of the paper. */
interface Column {
  readonly x: number;
  readonly firstStep: number;
  readonly lastStep: number;
}

function columnsOf(record: RunRecord, ruled: Ruled, width: number): Column[] {
  const columns: Column[] = [];
  for (let step = 1; step <= record.stepCount;) {
    const scale = scaleOf(record, step);
    const x = scaleToX(ruled, scale);
    const lastStep = Math.max(step, stepAt(record, xToScale(ruled, x + width)));
    columns.push({ x, firstStep: step, lastStep });
    step = lastStep + 1;
  }
  return columns;
}

/** The corners of one stepped line; within a column only its extremes. */
function steppedLine(
  record: RunRecord,
  k: number,
  columns: readonly Column[],
  y: (betti: number) => number,
  end: number,
): number[] {
  const corners: number[] = [];
  let before: number | undefined;
  for (const { x, firstStep, lastStep } of columns) {
    if (before !== undefined) corners.push(x, before);
    corners.push(x, y(record.betti(firstStep, k)));
    if (lastStep > firstStep) {
      const [least, most] = record.bettiExtremes(firstStep, lastStep, k);
      if (least !== most) corners.push(x, y(least), x, y(most));
    }
    before = y(record.betti(lastStep, k));
    corners.push(x, before);
  }
  if (before !== undefined) corners.push(end, before);
  return corners;
}

export function layOut(record: RunRecord, cards: readonly PlateauCard[], size: DiagramSize): DiagramLayout {
  const { width, resolution, kind = 'log', earlier = [] } = size;
  const axis = { ...axisOf(record), ...size.range };
  const frame = {
    left: MARGIN.left,
    right: width - MARGIN.right,
    top: MARGIN.top + (earlier.length > 0 ? STRIP.height + STRIP.gap : 0),
    bottom: size.height - MARGIN.bottom,
  };
  let most = 3;
  for (let k = 0; k < record.bettiCount && record.stepCount > 0; ++k) {
    most = Math.max(most, record.bettiExtremes(1, record.stepCount, k)[1]);
  }
  const room = frame.bottom - frame.top - 2 * SIDE_BY_SIDE - LABEL_ROOM;
  const y = (betti: number): number => frame.bottom - SIDE_BY_SIDE - (height(betti) / height(most)) * room;
  const ruled = { axis, kind, left: frame.left, right: frame.right };
  const x = (scale: number): number => scaleToX(ruled, scale);
  const end = x(axis.computed);
  const startOf = (step: number): number => (step > record.stepCount ? end : x(scaleOf(record, step)));

  const columns = columnsOf(record, ruled, 1 / resolution);
  const series = Array.from({ length: record.bettiCount }, (_, k) => {
    const aside = (k - (record.bettiCount - 1) / 2) * -SIDE_BY_SIDE;
    return steppedLine(record, k, columns, (betti) => y(betti) + aside, end);
  });
  const bands = cards
    .filter((card) => card.firstStep <= record.stepCount)
    .map((card) => ({
      from: startOf(card.firstStep),
      to: startOf(card.lastStep + 1),
      family: card.family,
      label: bettiList(card.betti),
    }));
  return {
    width,
    height: size.height,
    ...frame,
    axis,
    kind,
    bands,
    earlier: earlierBands(earlier, x, frame),
    columns: (kind === 'log' ? scaleTicks : evenTicks)(axis, frame.right - frame.left).map((value) => ({
      at: x(Math.log(value)),
      label: readable(value)
        .replace(/(\.\d*?)0+$/, '$1')
        .replace(/\.$/, ''),
    })),
    lines: thinned(bettiTicks(most).map((value) => ({ at: y(value), label: grouped(value) }))),
    series,
    computedTo: end,
  };
}

/** The earlier run has other steps: its plateaus lie where their ε are. */
function earlierBands(
  cards: readonly PlateauCard[],
  x: (scale: number) => number,
  { left, right }: { readonly left: number; readonly right: number },
): Band[] {
  return cards
    .filter(({ epsilonFirst }) => epsilonFirst > 0)
    .map(({ epsilonFirst, length, family, betti }) => ({
      from: Math.max(left, x(-Math.log(epsilonFirst))),
      to: Math.min(right, x(length - Math.log(epsilonFirst))),
      family,
      label: bettiList(betti),
    }))
    .filter(({ from, to }) => from < to);
}

/** Labels that do not overlap: those further up give way. */
function thinned(ticks: readonly Tick[]): Tick[] {
  const kept: Tick[] = [];
  for (const tick of ticks) {
    const below = kept.at(-1);
    if (!below || below.at - tick.at >= 13) kept.push(tick);
  }
  return kept;
}
