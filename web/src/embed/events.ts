import type { ErrorCode } from '../client/plateau-error.ts';
import type { PlateauCard } from '../model/plateau-cards.ts';
import type { Torsion } from '../model/record.ts';
import { shapeInWords } from '../model/words.ts';
import type { Family, OpenedRun, ShownFamily } from '../worker/protocol.ts';

/** Event `ready`: points were opened, and their run can be watched. */
export interface ReadyDetail {
  /** The shape, or the name of the file. */
  readonly name: string;
  /** How many. */
  readonly points: number;
  /** Coordinates a point; 0 where there are only distances. */
  readonly dimension: number;
  /** Which complex is followed. */
  readonly family: Family;
  /** ν of the witness complex, an entry a dimension. */
  readonly nu: readonly number[];
  /** How many steps there will be, unless the run ends before. */
  readonly stepsPlanned: number;
  /** What the reader of a file has to say of it. */
  readonly warnings: readonly string[];
}

/** Event `step`: the playhead shows another step. While the film runs that is at most one a picture. */
export interface StepDetail {
  /** From 1 on. */
  readonly step: number;
  /** In units of the input. */
  readonly epsilon: number;
  /** Which complex is shown. */
  readonly family: ShownFamily;
  /** Betti numbers: components, loops, voids, … */
  readonly betti: readonly number[];
  /** Those over another field, where they differ: the shape has torsion. */
  readonly torsion?: Torsion;
}

/** Event `plateau`: the playhead has come to another plateau. Runs with short interruptions count as one. */
export interface PlateauDetail {
  /** 1: the longest that is worth showing. */
  readonly rank: number;
  /** The first step with these Betti numbers. */
  readonly firstStep: number;
  /** The last step with them. */
  readonly lastStep: number;
  /** A step that shows it well. */
  readonly middleStep: number;
  /** ε of the first step, units of the input: the coarsest scale. */
  readonly epsilonFirst: number;
  /** ln of the ratio of the scales between which it lasts. */
  readonly length: number;
  /** Which complex the numbers are of. */
  readonly family: ShownFamily;
  /** Betti numbers: components, loops, voids, … */
  readonly betti: readonly number[];
  /** Those over another field, where they differ: the shape has torsion. */
  readonly torsion?: Torsion;
  /** In words, such as "torus-like closed surface". */
  readonly shape: string;
}

/** Event `error`: something could not be done. What was shown stays. */
export interface ErrorDetail {
  /** What it was, for programs. */
  readonly code: ErrorCode;
  /** A sentence for people; the element shows it too. */
  readonly message: string;
}

/** The events of an element by name. They leave shadow roots, and all but `error` bubble. */
export interface PlateauViewEventMap {
  ready: CustomEvent<ReadyDetail>;
  step: CustomEvent<StepDetail>;
  plateau: CustomEvent<PlateauDetail>;
  error: CustomEvent<ErrorDetail>;
}

export function readyDetail(name: string, opened: OpenedRun): ReadyDetail {
  const { points, dimension, family, nu, stepsPlanned, warnings } = opened;
  return { name, points, dimension, family, nu, stepsPlanned, warnings };
}

export function plateauDetail(card: PlateauCard, rank: number): PlateauDetail {
  const { firstStep, lastStep, middleStep, epsilonFirst, length, family, betti, torsion } = card;
  const about = { rank, firstStep, lastStep, middleStep, epsilonFirst, length, family, betti };
  return { ...about, ...(torsion ? { torsion } : {}), shape: shapeInWords(family, betti, torsion?.betti) };
}
