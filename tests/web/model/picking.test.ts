import { describe, expect, test } from 'vitest';
import { picked, stepsOf, type Place } from '../../../web/src/model/picking.ts';
import { RunRecord } from '../../../web/src/model/record.ts';
import type { Delta } from '../../../web/src/worker/protocol.ts';
import { NEVER, deltaOf, openedWith } from './fixtures.ts';

/** A triangle before everything, a point behind it, another far off, one that is not in the picture. */
const PLACES: readonly (Place | undefined)[] = [
  [0, 0, 1],
  [100, 0, 1],
  [0, 100, 1],
  [30, 30, 2],
  [300, 0, 2],
  undefined,
];
const placeOf = (index: number): Place | undefined => PLACES[index];

/** Steps 1 to 6 insert the points 5, 4, 3, 2, 1, 0. */
function record(parts: Partial<Delta>): RunRecord {
  const made = new RunRecord(openedWith());
  made.append(deltaOf(1, [6, 5, 4, 3, 2, 1], { landmark: Uint32Array.of(5, 4, 3, 2, 1, 0), ...parts }));
  return made;
}

const forever = (count: number): Uint32Array => new Uint32Array(count).fill(NEVER);

describe('what is under the pointer', () => {
  // Track 1 is shown: in track 0 nothing ever lived.
  const curve = record({
    edges: Uint32Array.of(2, 3, 4, 5, 4, 6, 5, 6),
    edgeDeath: [Uint32Array.of(3, 5, 6, 6), Uint32Array.of(6, NEVER, NEVER, NEVER)],
    triangles: Uint32Array.of(4, 5, 6),
    triangleDeath: [Uint32Array.of(6), forever(1)],
  });
  const at = (x: number, y: number, step = 6): readonly number[] => picked(curve, step, x, y, placeOf);

  test('is a landmark before an edge before a triangle', () => {
    expect(at(3, 4)).toEqual([0]);
    expect([...at(50, 3)].sort()).toEqual([0, 1]);
    expect([...at(20, 20)].sort()).toEqual([0, 1, 2]);
    expect(at(200, 200)).toEqual([]);
  });

  test('is not what a triangle hides', () => {
    expect([...at(30, 30)].sort()).toEqual([0, 1, 2]);
    expect(at(30, 30, 5)).toEqual([3]);
    expect(at(300, 1)).toEqual([4]);
  });

  test('lives at the step', () => {
    expect([...at(165, 15, 4)].sort()).toEqual([3, 4]);
    expect(at(165, 15, 6)).toEqual([]);
    expect(at(50, 3, 5)).toEqual([]);
  });

  test('of a surface is its triangles and their sides', () => {
    const surface = record({
      shownFamily: new Uint8Array(6).fill(2),
      edges: Uint32Array.of(2, 3),
      edgeDeath: [forever(1), forever(1)],
      rowVertices: Uint32Array.of(4, 5, 6),
      rowFrom: Uint32Array.of(6),
      rowTo: forever(1),
    });
    expect([...picked(surface, 6, 50, 51, placeOf)].sort()).toEqual([1, 2]);
    expect([...picked(surface, 6, 20, 20, placeOf)].sort()).toEqual([0, 1, 2]);
    expect(picked(surface, 6, 165, 15, placeOf)).toEqual([]);
  });

  test('is named by its steps', () => {
    expect(stepsOf(curve, [0, 5, 2])).toEqual([1, 4, 6]);
    expect(stepsOf(curve, [])).toEqual([]);
  });
});
