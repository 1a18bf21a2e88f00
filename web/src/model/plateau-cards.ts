import type { Plateaus, ShownFamily } from '../worker/protocol.ts';
import { counted } from './numbers.ts';
import { bettiInWords, scaleInWords, shapeInWords } from './words.ts';
import { shownFamilyName } from './record.ts';

/** Equal runs that a gap of at most this share of their joint length separates are one card. */
const JOIN_GAP = 0.05;
/** Cards shorter than this (in ln 1/ε) tell more about noise than about the shape. */
const SHORTEST = 0.1;
const MOST_CARDS = 12;
/** With fewer landmarks a piece any cloud looks like a piece or a ring, or falls to dust. */
const FEW_LANDMARKS = 12;

/** A plateau as the visitor meets it: possibly several equal runs with short interruptions. */
export interface PlateauCard {
  readonly firstStep: number;
  readonly lastStep: number;
  /** Where to look at it: always a step that shows it. */
  readonly middleStep: number;
  readonly epsilonFirst: number;
  /** ln(ε⁺(first) / ε⁺(last + 1)). */
  readonly length: number;
  readonly family: ShownFamily;
  readonly betti: readonly number[];
  /** 1, or the number of runs that were joined. */
  readonly runs: number;
}

interface Run {
  readonly card: PlateauCard;
  /** In ln 1/ε, from the beginning of the first plateau on. */
  readonly start: number;
  readonly end: number;
}

function runsOf(plateaus: Plateaus, dimension: number): Run[] {
  const runs: Run[] = [];
  for (let i = 0; i < plateaus.firstStep.length; ++i) {
    const epsilonFirst = plateaus.epsilonFirst[i] ?? 0;
    const length = Math.log(plateaus.ratio[i] ?? 1);
    const start = epsilonFirst > 0 ? -Math.log(epsilonFirst) : (runs.at(-1)?.end ?? 0);
    const card: PlateauCard = {
      firstStep: plateaus.firstStep[i] ?? 0,
      lastStep: plateaus.lastStep[i] ?? 0,
      middleStep: plateaus.middleStep[i] ?? 0,
      epsilonFirst,
      length,
      family: shownFamilyName(plateaus.family[i] ?? 1),
      betti: [...plateaus.betti.subarray(i * dimension, (i + 1) * dimension)],
      runs: 1,
    };
    runs.push({ card, start, end: start + length });
  }
  return runs;
}

function alike(a: PlateauCard, b: PlateauCard): boolean {
  return a.family === b.family && a.betti.every((value, k) => value === b.betti[k]);
}

/** The middle of the joint run if a member shows it there, else the middle of the longer member. */
function joined(a: Run, b: Run): Run {
  const longer = b.card.length > a.card.length ? b.card : a.card;
  const card: PlateauCard = {
    ...a.card,
    lastStep: b.card.lastStep,
    middleStep: longer.middleStep,
    length: b.end - a.start,
    runs: a.card.runs + b.card.runs,
  };
  return { card, start: a.start, end: b.end };
}

/** Cards in the order of steps. The bunny flickers: many short interruptions of one shape are one answer. */
export function joinedPlateaus(plateaus: Plateaus, dimension: number): PlateauCard[] {
  const done: Run[] = [];
  for (const run of runsOf(plateaus, dimension)) {
    let current = run;
    for (let i = done.length - 1; i >= 0; --i) {
      const earlier = done[i];
      if (!earlier || !alike(earlier.card, current.card)) continue;
      const gap = current.start - earlier.end;
      if (gap > JOIN_GAP * (current.end - earlier.start)) break;
      current = joined(earlier, current);
      done.length = i;
    }
    done.push(current);
  }
  return done.map(({ card }) => card);
}

/** The landmarks of one piece, at the most. */
function landmarksPerPiece({ lastStep, betti }: PlateauCard): number {
  return Math.floor(lastStep / Math.max(1, betti[0] ?? 1));
}

function fewLandmarks(card: PlateauCard): boolean {
  return landmarksPerPiece(card) < FEW_LANDMARKS;
}

/** The cards to show: the longest first, those of few landmarks last, those too short to mean anything left out. */
export function rankedCards(plateaus: Plateaus, dimension: number): PlateauCard[] {
  return joinedPlateaus(plateaus, dimension)
    .filter((card) => card.length >= SHORTEST)
    .sort(
      (a, b) =>
        Number(fewLandmarks(a)) - Number(fewLandmarks(b)) || b.length - a.length || a.firstStep - b.firstStep,
    )
    .slice(0, MOST_CARDS);
}

export interface CardWords {
  readonly shape: string;
  readonly counts: string;
  readonly scale: string;
  /** "surface", or "surface · 3 runs joined". */
  readonly family: string;
  /** Where the plateau means little, it says so. */
  readonly note?: string;
}

export function cardWords(card: PlateauCard): CardWords {
  const each = (card.betti[0] ?? 1) > 1 ? ' a piece' : '';
  return {
    shape: shapeInWords(card.family, card.betti),
    counts: bettiInWords(card.betti),
    // Where it ends is where the next shape begins, as its band in the diagram.
    scale: scaleInWords(card.epsilonFirst, card.epsilonFirst * Math.exp(-card.length)),
    family: card.runs === 1 ? card.family : `${card.family} · ${card.runs} runs joined`,
    ...(fewLandmarks(card)
      ? { note: `at most ${counted(landmarksPerPiece(card), 'landmark')}${each}: too few to trust` }
      : {}),
  };
}
