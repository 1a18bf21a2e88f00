import { counted, readable } from '../model/numbers.ts';
import { bettiInWords } from '../model/words.ts';
import type { PlanePicture } from '../sketch/plane.ts';
import { landmarkName, reasonInWords, simplexName, witnessName } from '../sketch/sketch-words.ts';
import { sketchOf } from './figures.ts';
import { numberIn, numbersIn, same, type Mark, type Marker } from './marking.ts';

const hasEdge = (edges: readonly (readonly number[])[], edge: readonly number[]): boolean =>
  edges.some((other) => same(other, edge));
const edgesOf = (picture: PlanePicture): number[][] => picture.edges.map(({ vertices }) => [...vertices]);

async function diagonal(answer: string, figure: string): Promise<Mark> {
  const sketch = sketchOf(figure);
  await sketch.settled();
  const { picture } = sketch;
  const asked = answer.split(' ').map(Number);
  if (!picture || asked.length !== 2) return { right: false, reason: 'Choose one of the two.' };
  sketch.showLayer('delaunay');
  const right = hasEdge(picture.delaunayEdges, asked);
  const other = asked[0] === 0 ? [1, 3] : [0, 2];
  const out = right ? other : asked;
  const reason = await sketch.why(out);
  const both = !right && !hasEdge(picture.delaunayEdges, other);
  return { right, reason: both ? 'Neither is one now.' : reasonInWords(out, reason) };
}

async function trianglesAfter(answer: string, figure: string): Promise<Mark> {
  const sketch = sketchOf(figure);
  await sketch.settled();
  const [without, within] = await Promise.all([
    sketch.ask(sketch.question({ withExtra: false })),
    sketch.ask(sketch.question({ withExtra: true })),
  ]);
  const [before, after] = [without.delaunayTriangles.length, within.delaunayTriangles.length];
  const n = within.question.landmarks.length;
  const rim = 2 * n - 2 - after;
  const reason = `With a there are ${n} landmarks, ${rim} of them on the rim: 2 · ${n} − 2 − ${rim} = ${after} triangles, after ${before}.`;
  return { right: numberIn(answer) === after, reason };
}

async function witnessedEdge(answer: string, figure: string): Promise<Mark> {
  const sketch = sketchOf(figure);
  await sketch.settled();
  const list = sketch.picture?.lists[1] ?? [];
  if (list.length < 2) return { right: false, reason: 'The figure has no w2, or fewer than two landmarks.' };
  const right = same(
    numbersIn(answer).sort((a, b) => a - b),
    list
      .slice(0, 2)
      .map((index) => index + 1)
      .sort((a, b) => a - b),
  );
  return {
    right,
    reason: `The nearest landmarks of w2 are ${list.map(landmarkName).join(', ')}, in this order.`,
  };
}

async function withoutFirst(answer: string, figure: string): Promise<Mark> {
  const sketch = sketchOf(figure);
  await sketch.settled();
  const { witnesses } = sketch.state;
  const now = sketch.picture;
  if (!now || witnesses.length === 0) return { right: false, reason: 'The figure has no witness.' };
  const then = await sketch.ask(sketch.question({ witnesses: witnesses.slice(1) }));
  const kept = edgesOf(then);
  const gone = edgesOf(now).filter((edge) => !hasEdge(kept, edge));
  const because =
    gone.length > 0 ? `, for ${gone.map(simplexName).join(' and ')} would go with its only witness` : '';
  return {
    right: numberIn(answer) === kept.length,
    reason: `Without w1 there would be ${counted(kept.length, 'edge')} instead of ${now.edges.length}${because}.`,
  };
}

async function someTriangle(_: string, figure: string): Promise<Mark> {
  const sketch = sketchOf(figure);
  await sketch.settled();
  const triangle = sketch.picture?.delaunayTriangles[0];
  if (!sketch.picture || !triangle)
    return {
      right: false,
      reason: 'There is no Delaunay triangle: three landmarks that are not on a line are needed.',
    };
  const found = sketch.picture.triangles[0]?.vertices;
  const asked = found ?? triangle;
  sketch.inspect(asked);
  return { right: found !== undefined, reason: reasonInWords(asked, await sketch.why(asked)) };
}

/** Pairs that lie opposite each other, in the order of the landmarks around the figure. */
const ACROSS: readonly (readonly number[])[] = [
  [0, 2],
  [1, 3],
];
const MOST_RANKS = 12;

async function leastNu(answer: string, figure: string): Promise<Mark> {
  const sketch = sketchOf(figure);
  await sketch.settled();
  const { nu, landmarks } = sketch.state;
  for (let rank = 2; rank <= Math.min(MOST_RANKS, landmarks.length); ++rank) {
    const picture = await sketch.ask(sketch.question({ nu: [nu[0] ?? 1, rank, nu[2] ?? 3] }));
    const edge = picture.edges.find(({ vertices }) => ACROSS.some((pair) => same(pair, vertices)));
    if (!edge) continue;
    const [first = 0] = edge.witnesses;
    const reason = `With ν₁ = ${rank} the ${simplexName(edge.vertices)} has ${counted(edge.witnesses.length, 'witness', 'witnesses')}, ${witnessName(first)} among them; with less no edge across has one.`;
    return { right: numberIn(answer) === rank, reason };
  }
  return {
    right: false,
    reason: 'No number is large enough: there is no Delaunay edge across, or no witness.',
  };
}

async function relaxedTriangles(answer: string, figure: string): Promise<Mark> {
  const sketch = sketchOf(figure);
  await sketch.settled();
  const picture = await sketch.ask({ ...sketch.question({ nu: [1, 3, 3] }), delaunay: true });
  const names = picture.triangles.map(({ vertices }) => simplexName(vertices));
  const which = names.length > 0 ? `: ${names.join(' and ')}` : '';
  return {
    right: numberIn(answer) === names.length,
    reason: `With ν = (1, 3, 3) the complex has ${counted(names.length, 'triangle')}${which}.`,
  };
}

async function nextLandmark(answer: string, figure: string): Promise<Mark> {
  const sketch = sketchOf(figure);
  await sketch.settled();
  const { scale } = sketch;
  const { step } = sketch.state;
  const next = scale?.order[step];
  if (!scale || next === undefined)
    return { right: false, reason: 'There is none left: go back a few steps.' };
  const epsilon = scale.epsilon[step - 1] ?? 0;
  return {
    right: numberIn(answer) === next + 1,
    reason: `${witnessName(next)} is farthest from all landmarks, at the distance ε = ${readable(epsilon)}.`,
  };
}

const SCALE = 15;

async function stepsToScale(answer: string, figure: string): Promise<Mark> {
  const sketch = sketchOf(figure);
  await sketch.settled();
  const epsilon = sketch.scale?.epsilon ?? [];
  const steps = epsilon.findIndex((value) => value <= SCALE) + 1;
  const [before = 0, after = 0] = [epsilon[steps - 2], epsilon[steps - 1]];
  return {
    right: steps > 0 && numberIn(answer) === steps,
    reason: `After ${counted(steps - 1, 'landmark')} ε is ${readable(before)}, after ${steps} it is ${readable(after)}.`,
  };
}

const isLoop = ({ betti }: PlanePicture): boolean => same(betti, [1, 1]);

/** The last step of the first stretch of steps with one piece and one loop. */
async function oneLoop(_: string, figure: string): Promise<Mark> {
  const sketch = sketchOf(figure);
  await sketch.settled();
  const { state, picture, scale } = sketch;
  if (!picture || !scale) return { right: false, reason: 'The figure has no steps.' };
  const at = async (step: number): Promise<PlanePicture> => sketch.ask(sketch.question({ step }));
  const now = `At step ${state.step} the complex has ${bettiInWords(picture.betti)}`;
  if (!isLoop(picture)) return { right: false, reason: `${now}.` };
  const next = await at(state.step + 1);
  if (isLoop(next)) return { right: false, reason: `${now}, and so it has at the next one.` };
  return { right: true, reason: `${now}; at step ${state.step + 1} it has ${bettiInWords(next.betti)}.` };
}

/** With all witnesses as landmarks there are only edges to nearest neighbors: the longest side of a triangle is none. */
async function nearestNeighbors(answer: string, figure: string): Promise<Mark> {
  const sketch = sketchOf(figure);
  await sketch.settled();
  const picture = await sketch.ask(sketch.question({ step: sketch.state.witnesses.length }));
  const can = picture.triangles.length > 0;
  return {
    right: answer === (can ? 'yes' : 'no'),
    reason: `Every witness has one edge, to its nearest neighbor, and the longest side of three points is nobody's shortest way. Here there are ${counted(picture.edges.length, 'edge')} and ${counted(picture.triangles.length, 'triangle')}.`,
  };
}

async function fake(answer: string, figure: string): Promise<Mark> {
  const sketch = sketchOf(figure);
  await sketch.settled();
  const [without, within] = await Promise.all([
    sketch.ask(sketch.question({ withExtra: false })),
    sketch.ask(sketch.question({ withExtra: true })),
  ]);
  const [before, after] = [edgesOf(without), edgesOf(within)];
  const gone = before.filter((edge) => !hasEdge(after, edge));
  const born = after.filter((edge) => !hasEdge(before, edge));
  const names = (edges: number[][]): string =>
    edges.map((edge) => edge.map(landmarkName).join(' ')).join(', ') || 'none';
  const a = landmarkName(within.question.landmarks.length - 1);
  return {
    right: numberIn(answer) === gone.length,
    reason: `Gone: ${names(gone)}. Born: ${names(born)}, where ${a} is a. Betti numbers ${without.betti.join(', ')} before and ${within.betti.join(', ')} after.`,
  };
}

/** By the names that the pages have for their tasks. */
export const PLANE_MARKERS: Readonly<Record<string, Marker>> = {
  diagonal,
  'triangles-after': trianglesAfter,
  'witnessed-edge': witnessedEdge,
  'without-w1': withoutFirst,
  'some-triangle': someTriangle,
  'open-diagonal': someTriangle,
  'least-nu': leastNu,
  'relaxed-triangles': relaxedTriangles,
  'next-landmark': nextLandmark,
  'steps-to-scale': stepsToScale,
  'one-loop': oneLoop,
  pieces: nearestNeighbors,
  fake,
};
