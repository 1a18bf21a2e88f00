import { parseAsked, withoutLandmark } from './names.ts';
import { formatPoints, parsePoints, samePlace, type Point } from './points.ts';

/** What an address or a teacher can set. */
export const SKETCH_ATTRIBUTES: readonly string[] = [
  ...['landmarks', 'witnesses', 'nu', 'step', 'extra', 'inserted', 'complex', 'ask'],
  ...['show', 'layers', 'offer'],
];

export type PointKind = 'landmark' | 'witness';

/** A point of the board by its kind and place in the list, from 0. */
export interface PointName {
  readonly kind: PointKind;
  readonly index: number;
}

/** All that a reader can change; it goes through undo and into links as a whole. */
export interface SketchState {
  readonly landmarks: readonly Point[];
  readonly witnesses: readonly Point[];
  readonly nu: readonly number[];
  /** The landmarks are the first so many witnesses, farthest first; 0: they are those of the list. */
  readonly step: number;
  /** Whether the landmark beside the others, a, is in. */
  readonly withExtra: boolean;
  /** The landmarks that the question why is about, by their names. */
  readonly asked: readonly string[];
}

export const PLAIN_NU: readonly number[] = [1, 2, 3];
const LARGEST_NU = 12;
/** A board is for looking at every point. */
const MOST_POINTS = 400;

export function parseNu(text: string): number[] {
  const entries = text.split(/[\s,;_]+/).filter((entry) => entry !== '');
  const numbers = entries.map(Number);
  if (entries.length === 0 || numbers.some((n) => !Number.isInteger(n) || n < 0 || n > LARGEST_NU))
    throw new Error(`nu="${text}" was not understood: whole numbers from 0 to ${LARGEST_NU}, as 1,2,3.`);
  return numbers;
}

export function parseStep(text: string): number {
  const step = Number(text);
  if (!Number.isInteger(step) || step < 1)
    throw new Error(`step="${text}" was not understood: a number from 1 on.`);
  return step;
}

export const pointsOf = (state: SketchState, kind: PointKind): readonly Point[] =>
  kind === 'landmark' ? state.landmarks : state.witnesses;

export function pointAt(state: SketchState, { kind, index }: PointName): Point | undefined {
  return pointsOf(state, kind)[index];
}

function withPoints(state: SketchState, kind: PointKind, points: readonly Point[]): SketchState {
  return kind === 'landmark' ? { ...state, landmarks: points } : { ...state, witnesses: points };
}

/** Two of one kind at one place would be one: the core takes no landmark twice. */
export function taken(state: SketchState, kind: PointKind, place: Point, but = -1): boolean {
  return pointsOf(state, kind).some((point, i) => i !== but && samePlace(point, place));
}

export function added(state: SketchState, kind: PointKind, place: Point): SketchState | undefined {
  const points = pointsOf(state, kind);
  if (points.length >= MOST_POINTS || taken(state, kind, place)) return undefined;
  return withPoints(state, kind, [...points, place]);
}

const replaced = (points: readonly Point[], index: number, place: Point): Point[] =>
  points.map((point, i) => (i === index ? place : point));

/** The witness that a landmark is as well; it goes where the landmark goes. */
export function ownWitness(state: SketchState, name: PointName): number | undefined {
  const place = name.kind === 'landmark' ? pointAt(state, name) : undefined;
  const own = place ? state.witnesses.findIndex((witness) => samePlace(witness, place)) : -1;
  return own < 0 ? undefined : own;
}

/** `own` is known from the beginning of the way: a witness that only lies on it is not taken along. */
export function moved(
  state: SketchState,
  { kind, index }: PointName,
  place: Point,
  own: number | undefined,
): SketchState | undefined {
  if (!pointsOf(state, kind)[index] || taken(state, kind, place, index)) return undefined;
  const next = withPoints(state, kind, replaced(pointsOf(state, kind), index, place));
  // Where another witness is, its own one waits, and follows as soon as there is room.
  return own === undefined || taken(state, 'witness', place, own)
    ? next
    : { ...next, witnesses: replaced(state.witnesses, own, place) };
}

export function removed(state: SketchState, { kind, index }: PointName): SketchState {
  const left = pointsOf(state, kind).filter((_, i) => i !== index);
  const asked = kind === 'landmark' ? withoutLandmark(state.asked, index) : state.asked;
  return { ...withPoints(state, kind, left), asked };
}

/** Landmarks first, then witnesses, around; farthest first, the landmarks are witnesses. */
export function nextPoint(
  { landmarks, witnesses, step }: SketchState,
  from: PointName | undefined,
  forward: boolean,
): PointName | undefined {
  const names: PointName[] = [
    ...(step > 0 ? [] : landmarks).map((_, index): PointName => ({ kind: 'landmark', index })),
    ...witnesses.map((_, index): PointName => ({ kind: 'witness', index })),
  ];
  const at = names.findIndex(({ kind, index }) => kind === from?.kind && index === from.index);
  const next = at < 0 ? (forward ? 0 : -1) : at + (forward ? 1 : -1);
  return names.at(next % Math.max(1, names.length));
}

/** The attributes that say a state: what a link holds, and what a teacher writes. */
export function attributesOf(state: SketchState): Record<string, string | null> {
  return {
    landmarks: state.step > 0 ? null : formatPoints(state.landmarks) || null,
    witnesses: formatPoints(state.witnesses) || null,
    nu: state.nu.join() === PLAIN_NU.join() ? null : state.nu.join(),
    step: state.step > 0 ? String(state.step) : null,
    inserted: state.withExtra ? '' : null,
    ask: state.asked.length > 0 ? state.asked.join(' ') : null,
  };
}

/** Reads the attributes; a part that makes no sense is an error with a sentence. */
export function stateFrom(read: (name: string) => string | null): SketchState {
  const nu = read('nu');
  const step = read('step');
  return {
    landmarks: parsePoints(read('landmarks') ?? ''),
    witnesses: parsePoints(read('witnesses') ?? ''),
    nu: nu === null ? PLAIN_NU : parseNu(nu),
    step: step === null ? 0 : parseStep(step),
    withExtra: read('inserted') !== null,
    asked: parseAsked(read('ask') ?? ''),
  };
}
