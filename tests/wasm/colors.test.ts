import { beforeAll, expect, test } from 'vitest';
import type { PlateauModule } from 'plateau-module';
import { SAMPLES } from '../../web/src/app/samples.ts';
import { colorDistances, strongColors } from '../../web/src/model/color-distances.ts';
import { expected, file, loadModule, opened } from './module.ts';

let module: PlateauModule;
beforeAll(async () => {
  module = await loadModule();
});

test('strong colors by their looks alone are a circle: the hues', async () => {
  const sample = SAMPLES.find(({ shape }) => shape === 'colors');
  if (!sample?.options) throw new Error('there is no such sample');
  expect(strongColors(Infinity)).toHaveLength(sample.size);
  const run = new module.Run(file('colors.csv', await colorDistances(sample.size)), sample.options);
  const { points, dimension, warnings } = opened(run);
  expect([points, dimension]).toEqual([652, 0]);
  // Differences of colors are no metric, and the reader says so.
  expect(warnings.join()).toContain('The triangle inequality fails');
  expected(run.run(Infinity, 200));
  const { firstStep, lastStep, epsilonFirst, epsilonLast, betti, ratio, ranked } = expected(run.plateaus());
  // Of the plateaus after the first few landmarks, from which anything looks like one piece.
  const longest = [...ranked].find((i) => (firstStep[i] ?? 0) >= 12);
  if (longest === undefined) throw new Error('no plateau');
  expect([...betti.subarray(3 * longest, 3 * longest + 3)]).toEqual([1, 1, 0]);
  expect([firstStep[longest], lastStep[longest]]).toEqual([21, 97]);
  expect(epsilonFirst[longest]).toBeCloseTo(18.1, 1);
  expect(epsilonLast[longest]).toBeCloseTo(7.75, 1);
  expect(Math.log(ratio[longest] ?? 1)).toBeGreaterThan(0.8);
  run.delete();
});

test('the table is what lies below its diagonal', async () => {
  const [first = '', second = ''] = (await colorDistances(2)).trimEnd().split('\n');
  expect(first).toBe('0');
  expect(second).toMatch(/^\d+\.\d{4},0$/);
});
