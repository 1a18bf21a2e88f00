import { counted } from '../model/numbers.ts';
import { bettiInWords } from '../model/words.ts';
import type { PlanePicture, Reason } from './plane.ts';
import type { Point } from './points.ts';
import type { PointName } from './sketch-state.ts';

/** Names that are seen and heard: p1 is the first landmark, w1 the first witness. */
export const landmarkName = (index: number): string => `p${index + 1}`;
export const witnessName = (index: number): string => `w${index + 1}`;

export function listed(names: readonly string[], last = 'and'): string {
  if (names.length < 2) return names.join('');
  return `${names.slice(0, -1).join(', ')} ${last} ${names.at(-1) ?? ''}`;
}

const KINDS = ['landmark', 'edge', 'triangle', 'tetrahedron'];

/** "edge p1 p4". */
export function simplexName(vertices: readonly number[]): string {
  const kind = KINDS[vertices.length - 1] ?? `simplex of ${vertices.length} landmarks`;
  return `${kind} ${vertices.map(landmarkName).join(' ')}`;
}

function ordinal(rank: number): string {
  const ending = rank % 100 >= 11 && rank % 100 <= 13 ? 'th' : (['th', 'st', 'nd', 'rd'][rank % 10] ?? 'th');
  return `${rank}${ending}`;
}

/** A point, where it is and, of a witness, whom it has near. */
export function pointInWords({ kind, index }: PointName, { x, y }: Point, list?: readonly number[]): string {
  if (kind === 'landmark') return `Landmark ${landmarkName(index)} at ${x}, ${y}`;
  const nearest = list && list.length > 0 ? `; nearest landmarks ${list.map(landmarkName).join(', ')}` : '';
  return `Witness ${witnessName(index)} at ${x}, ${y}${nearest}`;
}

/** What stands under a board, and what is spoken when it changes. */
export function summary({ question, edges, triangles, betti }: PlanePicture): string {
  const points = `${counted(question.landmarks.length, 'landmark')}, ${counted(question.witnesses.length, 'witness', 'witnesses')}`;
  if (question.witnesses.length === 0) return `${points}: no complex without witnesses.`;
  const parts = `${counted(edges.length, 'edge')} and ${counted(triangles.length, 'triangle')}`;
  return `${points}. The complex has ${parts}: ${bettiInWords(betti)}.`;
}

const SHOWN_WITNESSES = 12;

function witnessesInWords(witnesses: readonly number[], count: number): string {
  const names = witnesses.slice(0, SHOWN_WITNESSES).map(witnessName);
  return count > names.length
    ? `${names.join(', ')} and ${counted(count - names.length, 'other')}`
    : listed(names);
}

/** One or two sentences that a student can check with a ruler. */
export function reasonInWords(vertices: readonly number[], reason: Reason): string {
  const name = simplexName(vertices);
  switch (reason.kind) {
    case 'present': {
      const who = `${counted(reason.count, 'witness', 'witnesses')}: ${witnessesInWords(reason.witnesses, reason.count)}`;
      return `The ${name} is in the complex. It has ${who}.`;
    }
    case 'missing-face': {
      const because = reason.because ? ` ${reasonInWords(reason.face, reason.because)}` : '';
      return `The ${name} is not in the complex, because one of its faces is not: ${simplexName(reason.face)}.${because}`;
    }
    case 'not-delaunay': {
      const inside = listed(reason.inside.map(landmarkName), 'or');
      const disc = vertices.length > 2 ? 'the disc through its corners' : 'every disc through its ends';
      const because = inside === '' ? '' : `: ${disc} holds ${inside}`;
      return `The ${name} is not in the Delaunay triangulation${because}.`;
    }
    case 'no-witness': {
      if (reason.closest === undefined) return `The ${name} has no witness: there is none at all.`;
      const closest = witnessName(reason.closest);
      return (
        `The ${name} has no witness. The closest miss is ${closest}: it has to go down to the ${ordinal(reason.rank)} ` +
        `landmark of its list to find all corners, and may go no further than the ${ordinal(reason.needed)}.`
      );
    }
    case 'untold':
      return reason.sentence;
  }
}
