import { make } from '../embed/dom.ts';
import { counted } from '../model/numbers.ts';
import { namesOf, witnessName } from './names.ts';
import type { PlanePicture } from './plane.ts';
import { simplexName } from './sketch-words.ts';

const MOST_ROWS = 60;

function items(lines: readonly string[]): HTMLUListElement {
  const shown = lines.slice(0, MOST_ROWS);
  if (lines.length > shown.length) shown.push(`and ${lines.length - shown.length} more`);
  return make('ul', {}, ...shown.map((line) => make('li', {}, line)));
}

/** All that the board shows, for who does not see it. */
export function figureInWords({
  question,
  lists,
  vertices,
  edges,
  triangles,
  delaunayEdges,
}: PlanePicture): HTMLElement {
  const name = namesOf(question);
  const landmarks = question.landmarks.map(({ x, y }, i) => `${name(i)} at ${x}, ${y}`);
  const witnesses = question.witnesses.map(
    ({ x, y }, i) => `${witnessName(i)} at ${x}, ${y}: ${(lists[i] ?? []).map(name).join(', ')}`,
  );
  const simplices = [...vertices, ...edges, ...triangles].map(
    (simplex) =>
      `${simplexName(simplex.vertices, name)}: ${counted(simplex.witnesses.length, 'witness', 'witnesses')}`,
  );
  const triangulation = delaunayEdges.map((edge) => edge.map(name).join(' '));
  return make(
    'div',
    {},
    make('p', {}, 'Landmarks'),
    items(landmarks),
    make('p', {}, 'Witnesses, each with its nearest landmarks in order'),
    items(witnesses),
    make('p', {}, 'Simplices of the complex'),
    items(simplices),
    make('p', {}, `Delaunay edges: ${triangulation.join(', ') || 'none'}`),
  );
}
