import type { LifespanStore } from './chunks.ts';
import type { RunRecord } from './record.ts';

/** Where a point of the input is in the picture: x, y, and how far from the eye; undefined: nowhere. */
export type Place = readonly [x: number, y: number, depth: number];
export type PlaceOf = (index: number) => Place | undefined;

/** How far a pointer may miss, in pixels. */
const NEAR_LANDMARK = 9;
const NEAR_EDGE = 5;
/** What lies in a triangle is seen, also where rounding puts it behind: a part of the distance to the eye. */
const DEPTH_SLACK = 0.01;

/** Calls use(vertices) with the places of each element that lives at the step. */
function forEachLiving(
  store: LifespanStore,
  step: number,
  track: number,
  placeOf: PlaceOf,
  use: (places: readonly Place[], indices: readonly number[]) => void,
): void {
  const { stride, vertices: width, deaths } = store;
  for (const { words, bornBy } of store.chunks.map((chunk) => ({
    words: chunk.words,
    bornBy: chunk.bornBy(step),
  }))) {
    for (let word = 0; word < bornBy * stride; word += stride) {
      if (deaths > 0 && (words[word + width + 1 + track] ?? 0) <= step) continue;
      const indices = [...words.subarray(word, word + width)];
      const places = indices.map(placeOf).filter((place) => place !== undefined);
      if (places.length === width) use(places, indices);
    }
  }
}

/** How deep a triangle is under the pointer, if it is there. */
function depthInside(x: number, y: number, [a, b, c]: readonly Place[]): number | undefined {
  if (!a || !b || !c) return undefined;
  const area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  if (area === 0) return undefined;
  const v = ((x - a[0]) * (c[1] - a[1]) - (y - a[1]) * (c[0] - a[0])) / area;
  const w = ((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])) / area;
  if (v < 0 || w < 0 || v + w > 1) return undefined;
  // In perspective it is one by the depth that runs evenly over the picture.
  return 1 / ((1 - v - w) / a[2] + v / b[2] + w / c[2]);
}

/** How far the pointer is from an edge, and how deep that is there. */
function missOf(x: number, y: number, [a, b]: readonly Place[]): readonly [miss: number, depth: number] {
  if (!a || !b) return [Infinity, 0];
  const along = [b[0] - a[0], b[1] - a[1]] as const;
  const squared = along[0] ** 2 + along[1] ** 2;
  const share = squared > 0 ? ((x - a[0]) * along[0] + (y - a[1]) * along[1]) / squared : 0;
  const t = Math.min(1, Math.max(0, share));
  return [Math.hypot(a[0] + t * along[0] - x, a[1] + t * along[1] - y), 1 / ((1 - t) / a[2] + t / b[2])];
}

/**
 * What is under the pointer, as input indices of landmarks: a landmark, the ends of an edge, the corners of a triangle,
 * in this order as long as no triangle hides it; nothing where there is nothing.
 */
export function picked(
  record: RunRecord,
  step: number,
  x: number,
  y: number,
  placeOf: PlaceOf,
): readonly number[] {
  const { family, track } = record.summary(step);
  const triangles = family === 'surface' ? record.rows : record.triangles;
  const of = family === 'surface' ? 0 : track;
  let face: { readonly depth: number; readonly indices: readonly number[] } | undefined;
  let edge: { readonly depth: number; readonly indices: readonly number[] } | undefined;
  const seeEdge = (places: readonly Place[], indices: readonly number[]): void => {
    const [miss, depth] = missOf(x, y, places);
    if (miss <= NEAR_EDGE && depth < (edge?.depth ?? Infinity)) edge = { depth, indices };
  };
  forEachLiving(triangles, step, of, placeOf, (places, indices) => {
    const depth = depthInside(x, y, places);
    if (depth !== undefined && depth < (face?.depth ?? Infinity)) face = { depth, indices };
    if (family !== 'surface') return;
    for (const [i, j] of [
      [0, 1],
      [0, 2],
      [1, 2],
    ] as const) {
      const [a, b, p, q] = [places[i], places[j], indices[i], indices[j]];
      if (a && b && p !== undefined && q !== undefined) seeEdge([a, b], [p, q]);
    }
  });
  if (family !== 'surface') forEachLiving(record.edges, step, track, placeOf, seeEdge);
  const wall = (face?.depth ?? Infinity) * (1 + DEPTH_SLACK);
  let landmark: { readonly miss: number; readonly index: number } | undefined;
  for (let s = 1; s <= step; ++s) {
    const index = record.landmark(s);
    const place = placeOf(index);
    if (!place || place[2] > wall) continue;
    const miss = Math.hypot(place[0] - x, place[1] - y);
    if (miss <= NEAR_LANDMARK && miss < (landmark?.miss ?? Infinity)) landmark = { miss, index };
  }
  if (landmark) return [landmark.index];
  if (edge && edge.depth <= wall) return edge.indices;
  return face?.indices ?? [];
}

/** The steps of landmarks given by input index, ascending. */
export function stepsOf(record: RunRecord, indices: readonly number[]): readonly number[] {
  const steps: number[] = [];
  for (let step = 1; step <= record.stepCount && steps.length < indices.length; ++step) {
    if (indices.includes(record.landmark(step))) steps.push(step);
  }
  return steps;
}
