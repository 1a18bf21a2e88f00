import { counted, readable } from '../model/numbers.ts';
import { bettiInWords } from '../model/words.ts';
import { namesOf, witnessName } from '../sketch/names.ts';
import type { PlaneSketchElement } from '../sketch/plane-sketch-element.ts';
import type { PlanePicture } from '../sketch/plane.ts';
import { samePlace, type Point } from '../sketch/points.ts';
import { PLAIN_NU } from '../sketch/sketch-state.ts';
import { reasonInWords, simplexName } from '../sketch/sketch-words.ts';
import { sketchOf } from './figures.ts';
import { marked, numberIn, numbersIn, same, undecided, type Mark, type Marker } from './marking.ts';

type Ask = (answer: string, sketch: PlaneSketchElement, picture: PlanePicture) => Promise<Mark> | Mark;

/** Of a sketch once the core has said all about it. */
function ofSketch(ask: Ask): Marker {
  return async (answer, figure) => {
    const sketch = sketchOf(figure);
    await sketch.settled();
    const { picture } = sketch;
    return picture ? ask(answer, sketch, picture) : undecided('The figure shows nothing.');
  };
}

const hasEdge = (edges: readonly (readonly number[])[], edge: readonly number[]): boolean =>
  edges.some((other) => same(other, edge));
const edgesOf = (picture: PlanePicture): number[][] => picture.edges.map(({ vertices }) => [...vertices]);
const ascending = (numbers: readonly number[]): number[] => [...numbers].sort((a, b) => a - b);
/** "p1 p3" of a picture. */
const edgeName = ({ question }: PlanePicture, edge: readonly number[]): string =>
  edge.map(namesOf(question)).join(' ');

/** What the figure would be without the landmark a, and with it. */
async function bothWays(sketch: PlaneSketchElement): Promise<[PlanePicture, PlanePicture]> {
  return Promise.all([
    sketch.ask(sketch.question({ withExtra: false })),
    sketch.ask(sketch.question({ withExtra: true })),
  ]);
}

const diagonal: Ask = async (answer, sketch, { delaunayEdges, question }) => {
  const asked = answer.split(' ').map(Number);
  const right = hasEdge(delaunayEdges, asked);
  const other = asked[0] === 0 ? [1, 3] : [0, 2];
  if (!right && !hasEdge(delaunayEdges, other)) return marked(false, 'Neither is one now.');
  // Whoever is right is shown it.
  if (right) sketch.showLayer('delaunay');
  const out = right ? other : asked;
  // Where every landmark is a witness only the triangulation is in question.
  const reason = await sketch.why(out, { ...question, witnesses: question.landmarks });
  return marked(right, reasonInWords(out, reason, namesOf(question)));
};

const trianglesAfter: Ask = async (answer, sketch) => {
  const [without, within] = await bothWays(sketch);
  const [before, after] = [without.delaunayTriangles.length, within.delaunayTriangles.length];
  const n = within.question.landmarks.length;
  const rim = 2 * n - 2 - after;
  return marked(
    numberIn(answer) === after,
    `With a there are ${n} landmarks, ${rim} of them on the rim: 2 · ${n} − 2 − ${rim} = ${after} triangles, after ${before}.`,
  );
};

const witnessedEdge: Ask = (answer, _, { lists, question }) => {
  const list = lists[1] ?? [];
  if (list.length < 2) return undecided('The figure has no w2, or fewer than two landmarks.');
  const nearest = list.slice(0, 2).map((index) => index + 1);
  return marked(
    same(ascending(numbersIn(answer)), ascending(nearest)),
    `The nearest landmarks of w2 are ${list.map(namesOf(question)).join(', ')}, in this order.`,
  );
};

const withoutFirst: Ask = async (answer, sketch, now) => {
  const { witnesses } = sketch.state;
  if (witnesses.length === 0) return undecided('The figure has no witness.');
  const kept = edgesOf(await sketch.ask(sketch.question({ witnesses: witnesses.slice(1) })));
  const gone = edgesOf(now).filter((edge) => !hasEdge(kept, edge));
  const names = gone.map((edge) => simplexName(edge, namesOf(now.question)));
  const because = gone.length > 0 ? `, for ${names.join(' and ')} would go with its only witness` : '';
  return marked(
    numberIn(answer) === kept.length,
    `Without w1 there would be ${counted(kept.length, 'edge')} instead of ${now.edges.length}${because}.`,
  );
};

/** What a page asks for holds for its plain complex alone: a larger ν would make it trivial. */
function notPlain(sketch: PlaneSketchElement): Mark | undefined {
  if (!same(sketch.state.nu, PLAIN_NU)) return marked(false, `With ν = (${PLAIN_NU.join(', ')}), please.`);
  return sketch.getAttribute('complex') === 'whole'
    ? marked(false, 'With only Delaunay simplices, please.')
    : undefined;
}

const CORNERS: readonly number[] = [0, 1, 2];

/** The triangle of the first three landmarks; how many witnesses that took, and how many it takes. */
const namedTriangle: Ask = async (_, sketch, { question, triangles }) => {
  const refused = notPlain(sketch);
  if (refused) return refused;
  const { landmarks, witnesses } = sketch.state;
  if (landmarks.length < CORNERS.length) return undecided('The figure has no p3.');
  sketch.inspect(CORNERS);
  const reason = reasonInWords(CORNERS, await sketch.why(CORNERS), namesOf(question));
  if (!triangles.some(({ vertices }) => same(vertices, CORNERS))) return marked(false, reason);
  const isLandmark = (place: Point): boolean => landmarks.some((other) => samePlace(other, place));
  const own = witnesses.filter(isLandmark);
  if (own.length < landmarks.length) return marked(true, reason);
  // Each landmark bears witness for itself; a witness more has two nearest landmarks, and so serves one edge.
  const before = await sketch.ask(sketch.question({ witnesses: own }));
  const missing = 3 - edgesOf(before).filter((edge) => edge.every((end) => CORNERS.includes(end))).length;
  const added = witnesses.length - own.length;
  const few = added > missing ? `${missing} would have been enough` : 'no fewer would do';
  return marked(true, `${reason} You added ${counted(added, 'witness', 'witnesses')}; ${few}.`);
};

/** Any triangle, with the plain complex. */
const someTriangle: Ask = async (_, sketch, { question, triangles, delaunayTriangles }) => {
  const refused = notPlain(sketch);
  if (refused) return refused;
  const asked = triangles[0]?.vertices ?? delaunayTriangles[0];
  if (!asked)
    return marked(false, 'There is no Delaunay triangle: three landmarks that are not on a line are needed.');
  sketch.inspect(asked);
  return marked(triangles.length > 0, reasonInWords(asked, await sketch.why(asked), namesOf(question)));
};

/** Of four places the two pairs that lie opposite each other, whichever order they come in. */
function pairsAcross(places: readonly Point[]): number[][] {
  const [x, y] = [places.reduce((sum, p) => sum + p.x, 0) / 4, places.reduce((sum, p) => sum + p.y, 0) / 4];
  const turn = ({ x: px, y: py }: Point): number => Math.atan2(py - y, px - x);
  const around = places.map((place, index) => ({ index, at: turn(place) })).sort((a, b) => a.at - b.at);
  const [a, b, c, d] = around.map(({ index }) => index);
  return a === undefined || b === undefined || c === undefined || d === undefined
    ? []
    : [ascending([a, c]), ascending([b, d])];
}

const leastNu: Ask = async (answer, sketch) => {
  const { nu, landmarks } = sketch.state;
  if (landmarks.length !== 4)
    return undecided('Opposite are two of four landmarks: the figure has another number.');
  const across = pairsAcross(landmarks);
  for (let rank = 2; rank <= landmarks.length; ++rank) {
    const picture = await sketch.ask(sketch.question({ nu: [nu[0] ?? 1, rank, nu[2] ?? 3] }));
    const edge = picture.edges.find(({ vertices }) => hasEdge(across, vertices));
    if (!edge) continue;
    const name = simplexName(edge.vertices, namesOf(picture.question));
    const [first = 0] = edge.witnesses;
    return marked(
      numberIn(answer) === rank,
      `With ν₁ = ${rank} the ${name} has ${counted(edge.witnesses.length, 'witness', 'witnesses')}, ${witnessName(first)} among them; with less no edge across has one.`,
    );
  }
  return undecided('No number is large enough: there is no Delaunay edge across, or no witness.');
};

const relaxedTriangles: Ask = async (answer, sketch) => {
  const picture = await sketch.ask({ ...sketch.question({ nu: [1, 3, 3] }), delaunay: true });
  const names = picture.triangles.map(({ vertices }) => simplexName(vertices, namesOf(picture.question)));
  const which = names.length > 0 ? `: ${names.join(' and ')}` : '';
  return marked(
    numberIn(answer) === names.length,
    `With ν = (1, 3, 3) the complex has ${counted(names.length, 'triangle')}${which}.`,
  );
};

/** By its number, as 5 or w5, or by where it is, as 33,17. */
const nextLandmark: Ask = (answer, { scale, state }) => {
  const next = scale?.order[state.step];
  const place = next === undefined ? undefined : state.witnesses[next];
  if (!scale || next === undefined || !place) return undecided('There is none left: go back a few steps.');
  const numbers = numbersIn(answer);
  return marked(
    same(numbers, [next + 1]) || same(numbers, [place.x, place.y]),
    `${witnessName(next)} is farthest from all landmarks, at the distance ε = ${readable(scale.epsilon[state.step - 1] ?? 0)}.`,
  );
};

const SCALE = 15;

const stepsToScale: Ask = (answer, { scale }) => {
  const epsilon = scale?.epsilon ?? [];
  const steps = epsilon.findIndex((value) => value <= SCALE) + 1;
  const [before = 0, after = 0] = [epsilon[steps - 2], epsilon[steps - 1]];
  return marked(
    steps > 0 && numberIn(answer) === steps,
    `After ${counted(steps - 1, 'landmark')} ε is ${readable(before)}, after ${steps} it is ${readable(after)}.`,
  );
};

const isLoop = ({ betti }: PlanePicture): boolean => same(betti, [1, 1]);

/** The last step of the first stretch of steps with one piece and one loop. */
const oneLoop: Ask = async (_, sketch, picture) => {
  const { step } = sketch.state;
  if (!sketch.scale) return undecided('The figure has no steps.');
  const now = `At step ${step} the complex has ${bettiInWords(picture.betti)}`;
  if (!isLoop(picture)) return marked(false, `${now}.`);
  const next = await sketch.ask(sketch.question({ step: step + 1 }));
  if (isLoop(next)) return marked(false, `${now}, and so it has at the next one.`);
  return marked(true, `${now}; at step ${step + 1} it has ${bettiInWords(next.betti)}.`);
};

/** With all witnesses as landmarks there are only edges to nearest neighbors: the longest side of a triangle is none. */
const nearestNeighbors: Ask = async (answer, sketch) => {
  const picture = await sketch.ask(sketch.question({ step: sketch.state.witnesses.length }));
  const can = picture.triangles.length > 0;
  return marked(
    answer === (can ? 'yes' : 'no'),
    `Every witness has one edge, to its nearest neighbor, and the longest side of three points is nobody's shortest way. Here there are ${counted(picture.edges.length, 'edge')} and ${counted(picture.triangles.length, 'triangle')}.`,
  );
};

const fake: Ask = async (answer, sketch) => {
  const [without, within] = await bothWays(sketch);
  const [before, after] = [edgesOf(without), edgesOf(within)];
  const gone = before.filter((edge) => !hasEdge(after, edge));
  const born = after.filter((edge) => !hasEdge(before, edge));
  const names = (picture: PlanePicture, edges: number[][]): string =>
    edges.map((edge) => edgeName(picture, edge)).join(', ') || 'none';
  return marked(
    numberIn(answer) === gone.length,
    `Gone: ${names(without, gone)}. Born: ${names(within, born)}. Betti numbers ${without.betti.join(', ')} before and ${within.betti.join(', ')} after.`,
  );
};

const ASKED: Readonly<Record<string, Ask>> = {
  diagonal,
  'triangles-after': trianglesAfter,
  'witnessed-edge': witnessedEdge,
  'without-w1': withoutFirst,
  'some-triangle': namedTriangle,
  'open-diagonal': someTriangle,
  'least-nu': leastNu,
  'relaxed-triangles': relaxedTriangles,
  'next-landmark': nextLandmark,
  'steps-to-scale': stepsToScale,
  'one-loop': oneLoop,
  pieces: nearestNeighbors,
  fake,
};

/** By the names that the pages have for their tasks. */
export const PLANE_MARKERS: Readonly<Record<string, Marker>> = Object.fromEntries(
  Object.entries(ASKED).map(([name, ask]) => [name, ofSketch(ask)]),
);
