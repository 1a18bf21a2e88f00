import type { Reason } from './plane.ts';

/** What an answer points at on the board. */
export interface Answer {
  /** Its witnesses, or the one that came closest. */
  readonly lit: readonly number[];
  /** The face that is missing. */
  readonly face: readonly number[];
  /** Landmarks that are too near for a Delaunay simplex, and the triangle in whose disc they are. */
  readonly blockers: readonly number[];
  readonly disc: readonly number[];
}

export const NO_ANSWER: Answer = { lit: [], face: [], blockers: [], disc: [] };

export function answerOf(vertices: readonly number[], reason: Reason): Answer {
  switch (reason.kind) {
    case 'present':
      return { ...NO_ANSWER, lit: reason.witnesses };
    case 'no-witness':
      return { ...NO_ANSWER, lit: reason.closest === undefined ? [] : [reason.closest] };
    case 'not-delaunay':
      return { ...NO_ANSWER, blockers: reason.inside, disc: vertices.length === 3 ? vertices : [] };
    case 'missing-face':
      return { ...(reason.because ? answerOf(reason.face, reason.because) : NO_ANSWER), face: reason.face };
    case 'untold':
      return NO_ANSWER;
  }
}
