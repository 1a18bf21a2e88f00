import type { Plateaus, ShownFamily } from '../worker/protocol.ts';
import { counted } from './numbers.ts';
import { bettiInWords, scaleInWords, shapeInWords, torsionInNumbers } from './words.ts';
import { shownFamilyName, type Torsion } from './record.ts';

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
  readonly torsion?: Torsion;
  /** 1, or the number of runs that were joined. */
  readonly runs: number;
}

interface Run {
  readonly card: PlateauCard;
  /** In ln 1/ε, from the beginning of the first plateau on. */
  readonly start: number;
  readonly end: number;
}

/** A run on the stack, and where the one like it below it lies: -1 for none. */
interface Stacked {
  readonly run: Run;
  readonly key: string;
  readonly alikeBelow: number;
}

/** What there is to know of the numbers themselves. */
export interface BettiKind {
  /** Betti numbers a step. */
  readonly bettiCount: number;
  /** The prime of those that tell torsion; 0: there is none. */
  readonly otherField: number;
}

function runAt(plateaus: Plateaus, i: number, kind: BettiKind, before: Run | undefined): Run {
  const ofPlateau = (numbers: Uint32Array): number[] => [
    ...numbers.subarray(i * kind.bettiCount, (i + 1) * kind.bettiCount),
  ];
  const other = ofPlateau(plateaus.torsion);
  const epsilonFirst = plateaus.epsilonFirst[i] ?? 0;
  const length = Math.log(plateaus.ratio[i] ?? 1);
  const start = epsilonFirst > 0 ? -Math.log(epsilonFirst) : (before?.end ?? 0);
  const card: PlateauCard = {
    firstStep: plateaus.firstStep[i] ?? 0,
    lastStep: plateaus.lastStep[i] ?? 0,
    middleStep: plateaus.middleStep[i] ?? 0,
    epsilonFirst,
    length,
    family: shownFamilyName(plateaus.family[i] ?? 1),
    betti: ofPlateau(plateaus.betti),
    ...(other[0] ? { torsion: { field: kind.otherField, betti: other } } : {}),
    runs: 1,
  };
  return { card, start, end: start + length };
}

/** The middle of the joint run if a member shows it there, else the middle of the longer member. */
function joined(a: Run, b: Run): Run {
  const longer = b.card.length > a.card.length ? b.card : a.card;
  const card: PlateauCard = {
    ...longer,
    firstStep: a.card.firstStep,
    epsilonFirst: a.card.epsilonFirst,
    lastStep: b.card.lastStep,
    length: b.end - a.start,
    runs: a.card.runs + b.card.runs,
  };
  return { card, start: a.start, end: b.end };
}

/**
 * The plateaus of a growing run as cards. The bunny flickers: many short interruptions of one shape are one answer.
 * Only what is new is looked at: a scan has tens of thousands of plateaus, and most last a step.
 */
export class CardStack {
  private readonly stack: Stacked[] = [];
  /** The topmost run of each shape. */
  private readonly topmost = new Map<string, number>();
  /** Plateaus that no later step can lengthen. */
  private settled = 0;
  private before: Run | undefined;

  constructor(private readonly kind: BettiKind) {}

  /** In the order of steps. `plateaus`: all so far; those before the last are as they were at the last call. */
  joined(plateaus: Plateaus): PlateauCard[] {
    const count = plateaus.firstStep.length;
    for (; this.settled + 1 < count; ++this.settled) {
      const run = runAt(plateaus, this.settled, this.kind, this.before);
      this.before = run;
      const { under, top } = this.joinedWith(run);
      this.cutTo(under);
      this.push(top);
    }
    if (count === 0) return [];
    const { under, top } = this.joinedWith(runAt(plateaus, count - 1, this.kind, this.before));
    return [...this.stack.slice(0, under).map(({ run }) => run.card), top.card];
  }

  /** The cards to show: the longest first, those of few landmarks last, those too short to mean anything left out. */
  ranked(plateaus: Plateaus): PlateauCard[] {
    return this.joined(plateaus)
      .filter((card) => card.length >= SHORTEST)
      .sort(
        (a, b) =>
          Number(fewLandmarks(a)) - Number(fewLandmarks(b)) ||
          b.length - a.length ||
          a.firstStep - b.firstStep,
      )
      .slice(0, MOST_CARDS);
  }

  /** What the run becomes on top of the stack, and how much of the stack stays under it. */
  private joinedWith(run: Run): { under: number; top: Run } {
    let [under, top] = [this.stack.length, run];
    let below = this.topmost.get(keyOf(run.card)) ?? -1;
    while (below >= 0) {
      const earlier = this.stack[below];
      if (!earlier) break;
      if (top.start - earlier.run.end > JOIN_GAP * (top.end - earlier.run.start)) break;
      [under, top] = [below, joined(earlier.run, top)];
      below = earlier.alikeBelow;
    }
    return { under, top };
  }

  private cutTo(length: number): void {
    while (this.stack.length > length) {
      const gone = this.stack.pop();
      if (gone) this.topmost.set(gone.key, gone.alikeBelow);
    }
  }

  private push(run: Run): void {
    const key = keyOf(run.card);
    this.stack.push({ run, key, alikeBelow: this.topmost.get(key) ?? -1 });
    this.topmost.set(key, this.stack.length - 1);
  }
}

function keyOf({ family, betti }: PlateauCard): string {
  return `${family} ${betti.join()}`;
}

/** The landmarks of one piece, at the most. */
function landmarksPerPiece({ lastStep, betti }: PlateauCard): number {
  return Math.floor(lastStep / Math.max(1, betti[0] ?? 1));
}

function fewLandmarks(card: PlateauCard): boolean {
  return landmarksPerPiece(card) < FEW_LANDMARKS;
}

/** What a card is known by while its plateau grows at the end. */
export function cardName({ family, betti, firstStep }: PlateauCard): string {
  return `${firstStep} ${family} ${betti.join()}`;
}

export interface CardWords {
  readonly shape: string;
  readonly counts: string;
  readonly scale: string;
  /** "surface", or "surface · 3 runs joined". */
  readonly family: string;
  /** "torsion: 1, 0, 0 over Z/3". */
  readonly torsion?: string;
  /** Where the plateau means little, it says so. */
  readonly note?: string;
}

export function cardWords(card: PlateauCard): CardWords {
  const each = (card.betti[0] ?? 1) > 1 ? ' a piece' : '';
  return {
    shape: shapeInWords(card.family, card.betti, card.torsion?.betti),
    counts: bettiInWords(card.betti),
    // Where it ends is where the next shape begins, as its band in the diagram.
    scale: scaleInWords(card.epsilonFirst, card.epsilonFirst * Math.exp(-card.length)),
    family: card.runs === 1 ? card.family : `${card.family} · ${card.runs} runs joined`,
    ...(card.torsion ? { torsion: torsionInNumbers(card.torsion) } : {}),
    ...(fewLandmarks(card)
      ? { note: `at most ${counted(landmarksPerPiece(card), 'landmark')}${each}: too few to trust` }
      : {}),
  };
}
