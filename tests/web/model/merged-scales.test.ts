import { describe, expect, test } from 'vitest';
import { memoryBeside } from '../../../web/src/model/forecast.ts';
import { MergedScales } from '../../../web/src/model/merged-scales.ts';
import { RunRecord } from '../../../web/src/model/record.ts';
import { axisOf, jointRange, scaleOf, stepAt, stepBefore } from '../../../web/src/model/scale-axis.ts';
import { layOut, scaleToX } from '../../../web/src/view/diagram-layout.ts';
import { deltaOf, openedWith, recordOf } from './fixtures.ts';

/** Never growing numbers from a fixed sequence, with ties, some down to 0. */
function falling(seed: number, count: number, zeros: number): number[] {
  let state = seed;
  let epsilon = 2;
  return Array.from({ length: count }, (_, i) => {
    state = (state * 1103515245 + 12345) % 2147483648;
    if (state % 3 !== 0) epsilon *= 1 - (state % 64) / 256;
    return i >= count - zeros ? 0 : epsilon;
  });
}

const listed = (merged: MergedScales): number[] =>
  Array.from({ length: merged.stepCount }, (_, i) => merged.epsilon(i + 1));

describe('the steps of two runs in one order', () => {
  test('are all of both, from coarse to fine', () => {
    for (let seed = 1; seed <= 40; ++seed) {
      const [a, b] = [falling(seed, seed % 7 || 1, seed % 3), falling(seed + 99, (3 * seed) % 11 || 1, 0)];
      const merged = new MergedScales(recordOf(a), recordOf(b));
      expect(merged.ended).toBe(true);
      expect(listed(merged)).toEqual([...a, ...b].sort((x, y) => y - x));
    }
  });

  test('reach as far as both are computed; a run that has ended holds nothing up', () => {
    const coarse = recordOf([4, 2], 'running');
    const fine = recordOf([3, 2, 1, 0.5], 'running');
    expect(listed(new MergedScales(coarse, fine))).toEqual([4, 3, 2, 2]);
    expect(new MergedScales(coarse, fine).ended).toBe(false);
    expect(listed(new MergedScales(recordOf([4, 2]), fine))).toEqual([4, 3, 2, 2, 1, 0.5]);
    expect(listed(new MergedScales(coarse, recordOf([3, 2, 1, 0.5])))).toEqual([4, 3, 2, 2]);
    const empty = new RunRecord(openedWith());
    expect(new MergedScales(empty, fine).stepCount).toBe(0);
    // What is there stays in its place when more is computed.
    const before = listed(new MergedScales(coarse, fine));
    coarse.append(deltaOf(3, [1.5, 0.9], { state: 'running' }));
    expect(listed(new MergedScales(coarse, fine)).slice(0, before.length)).toEqual(before);
  });

  test('are walked from scale to scale, not from tie to tie', () => {
    const merged = new MergedScales(recordOf([4, 2, 1]), recordOf([4, 2, 1]));
    const places = [Math.log(1 / 4)];
    for (let scale = places[0] ?? 0; places.length < 3; places.push(scale))
      scale = scaleOf(merged, stepAt(merged, scale) + 1);
    expect(places.map((place) => Math.round(Math.exp(-place)))).toEqual([4, 2, 1]);
    expect(stepBefore(merged, places[1] ?? 0)).toBe(2);
    expect(stepBefore(merged, places[0] ?? 0)).toBe(0);
  });
});

test('two diagrams on one axis have every scale at the same place', () => {
  const [a, b] = [recordOf([4, 2, 1, 0.5]), recordOf([1, 0.25, 0.125])];
  const range = jointRange([a, b, new RunRecord(openedWith())]);
  expect(range.low).toBe(axisOf(a).low);
  expect(range.high).toBe(axisOf(b).high);
  const size = { width: 700, height: 200, resolution: 1, range };
  const [first, second] = [layOut(a, [], size), layOut(b, [], size)];
  for (const epsilon of [4, 1, 0.3, 0.125])
    expect(scaleToX(first, -Math.log(epsilon))).toBe(scaleToX(second, -Math.log(epsilon)));
  expect(first.computedTo).toBeLessThan(first.right - 50);
  expect(second.computedTo).toBeCloseTo(second.right, 6);
  expect(first.columns).toEqual(second.columns);
  expect(jointRange([])).toEqual({ low: 0, high: 1 });
});

test('a second run may take what the first leaves, now or when it ends', () => {
  const record = (memoryBytes: number, state: 'running' | 'finished'): RunRecord => {
    const opened = openedWith({ estimatedBytes: 300, memoryLimitBytes: 1000, stepsPlanned: 9 });
    const made = new RunRecord(opened);
    made.append(deltaOf(1, [1], { memoryBytes, state }));
    return made;
  };
  expect(memoryBeside(record(100, 'running'))).toBe(700);
  expect(memoryBeside(record(400, 'running'))).toBe(600);
  expect(memoryBeside(record(100, 'finished'))).toBe(900);
  expect(memoryBeside(record(100, 'finished'), record(200, 'finished'))).toBe(700);
  expect(memoryBeside(record(990, 'finished'), record(200, 'finished'))).toBe(0);
});
