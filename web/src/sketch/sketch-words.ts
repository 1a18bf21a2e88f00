import { counted } from '../model/numbers.ts';
import { bettiInWords } from '../model/words.ts';
import type { Layer } from './layers.ts';
import { namesOf, witnessName, type Naming } from './names.ts';
import type { PlanePicture, Reason } from './plane.ts';
import { drawn, type Point } from './points.ts';
import type { PointName } from './sketch-state.ts';

export function listed(names: readonly string[], last = 'and'): string {
  if (names.length < 2) return names.join('');
  return `${names.slice(0, -1).join(', ')} ${last} ${names.at(-1) ?? ''}`;
}

const KINDS = ['landmark', 'edge', 'triangle', 'tetrahedron'];

/** "edge p1 p4". */
export function simplexName(vertices: readonly number[], name: Naming): string {
  const kind = KINDS[vertices.length - 1] ?? `simplex of ${vertices.length} landmarks`;
  return `${kind} ${vertices.map(name).join(' ')}`;
}

function ordinal(rank: number): string {
  const ending = rank % 100 >= 11 && rank % 100 <= 13 ? 'th' : (['th', 'st', 'nd', 'rd'][rank % 10] ?? 'th');
  return `${rank}${ending}`;
}

/** A point, where it is and, of a witness, whom it has near. */
export function pointInWords(
  { kind, index }: PointName,
  { x, y }: Point,
  name: Naming,
  list: readonly number[] = [],
): string {
  if (kind === 'landmark') return `Landmark ${name(index)} at ${x}, ${y}`;
  const nearest = list.length > 0 ? `; nearest landmarks ${list.map(name).join(', ')}` : '';
  return `Witness ${witnessName(index)} at ${x}, ${y}${nearest}`;
}

/** What stands under a board, of the layers that are on, and what is spoken when it changes. */
export function summary(picture: PlanePicture, layers: ReadonlySet<Layer>): string {
  const { question, edges, triangles, delaunayEdges, delaunayTriangles, pairCells, betti } = picture;
  const { landmarks, witnesses } = question;
  if (landmarks.length + witnesses.length === 0)
    return 'The board is empty: put landmarks and witnesses on it.';
  const complex = layers.has('complex');
  const points = counted(landmarks.length, 'landmark');
  const all =
    complex || witnesses.length > 0
      ? `${points}, ${counted(witnesses.length, 'witness', 'witnesses')}`
      : points;
  const more: string[] = [];
  if (layers.has('delaunay'))
    more.push(
      counted(delaunayEdges.length, 'Delaunay edge'),
      counted(delaunayTriangles.length, complex ? 'Delaunay triangle' : 'triangle'),
    );
  if (layers.has('pairs'))
    more.push(counted(pairCells.filter(drawn).length, 'cell of order two', 'cells of order two'));
  if (complex && witnesses.length === 0) more.push('no complex without witnesses');
  const shown = more.length > 0 ? `${all}: ${more.join(', ')}.` : `${all}.`;
  if (!complex || witnesses.length === 0) return shown;
  const parts = `${counted(edges.length, 'edge')} and ${counted(triangles.length, 'triangle')}`;
  return `${shown} The complex has ${parts}: ${bettiInWords(betti)}.`;
}

/** More of them would be a recital. */
const MOST_SPOKEN = 6;

/** Which edges have come and gone, of those that are shown; '' where none has, or where landmarks have other names. */
export function changeInWords(before: PlanePicture, now: PlanePicture, layers: ReadonlySet<Layer>): string {
  if (before.question.landmarks.length !== now.question.landmarks.length) return '';
  const edges = ({ edges, delaunayEdges, question }: PlanePicture): string[] => {
    const shown = layers.has('complex')
      ? edges.map(({ vertices }) => vertices)
      : layers.has('delaunay')
        ? delaunayEdges
        : [];
    return shown.map((vertices) => vertices.map(namesOf(question)).join(' '));
  };
  const [old, young] = [edges(before), edges(now)];
  const gone = old.filter((edge) => !young.includes(edge));
  const come = young.filter((edge) => !old.includes(edge));
  if (Math.max(gone.length, come.length) > MOST_SPOKEN) return '';
  if (gone.length === 0) return come.length === 0 ? '' : `New: ${listed(come)}.`;
  return come.length === 0 ? `Gone: ${listed(gone)}.` : `Now ${listed(come)} instead of ${listed(gone)}.`;
}

const SHOWN_WITNESSES = 12;

function witnessesInWords(witnesses: readonly number[], count: number): string {
  const names = witnesses.slice(0, SHOWN_WITNESSES).map(witnessName);
  return count > names.length
    ? `${names.join(', ')} and ${counted(count - names.length, 'other')}`
    : listed(names);
}

/** One or two sentences that a student can check with a ruler. */
export function reasonInWords(vertices: readonly number[], reason: Reason, landmark: Naming): string {
  const name = simplexName(vertices, landmark);
  switch (reason.kind) {
    case 'present': {
      const who = `${counted(reason.count, 'witness', 'witnesses')}: ${witnessesInWords(reason.witnesses, reason.count)}`;
      return `The ${name} is in the complex. It has ${who}.`;
    }
    case 'missing-face': {
      const because = reason.because ? ` ${reasonInWords(reason.face, reason.because, landmark)}` : '';
      return `The ${name} is not in the complex, because one of its faces is not: ${simplexName(reason.face, landmark)}.${because}`;
    }
    case 'not-delaunay': {
      const inside = listed(reason.inside.map(landmark), 'or');
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
