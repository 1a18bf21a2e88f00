import { beforeAll, describe, expect, test } from 'vitest';
import type { PlateauModule } from 'plateau-module';
import type { RunOptions } from '../../web/src/worker/protocol.ts';
import { frameOf } from '../../web/src/worker/frame.ts';
import { RunRecord } from '../../web/src/model/record.ts';
import { openedWith } from '../web/model/fixtures.ts';
import { allDeltas, expected, file, finishedRun, loadModule, opened, sample } from './module.ts';

let module: PlateauModule;
beforeAll(async () => {
  module = await loadModule();
});

/** What the module says instead of opening. */
function refusal(source: ReturnType<typeof file>, options: object): string {
  const run = new module.Run(source, options);
  for (;;) {
    const answer = run.open(5);
    if (answer.kind === 'reading') continue;
    run.delete();
    return answer.kind === 'failed' ? answer.failure.message : '';
  }
}

describe('distances instead of points', () => {
  const matrix = file('m.csv', '0,1,2,2\n1,0,2,2\n2,2,0,1\n2,2,1,0\n');

  test('open without coordinates and run to the end', () => {
    const run = new module.Run(matrix, { metric: 'matrix' });
    const answer = opened(run);
    expect(answer).toMatchObject({
      points: 4,
      dimension: 0,
      bettiCount: 3,
      metric: 'matrix',
      family: 'witness',
      nu: [1, 2, 3, 4],
    });
    expect(answer.coordinates).toHaveLength(0);
    expect(answer.stepsAffordable).toBe(4);
    const { projection } = answer;
    if (!projection) throw new Error('nothing to draw');
    expect(projection.shares).toHaveLength(projection.axes);
    expect(frameOf(answer.points, projection)).toMatchObject({ count: 4, axes: projection.axes });
    run.delete();

    const finished = finishedRun(module, matrix, { metric: 'matrix' });
    const [delta] = allDeltas(finished, 1e6);
    expect([...(delta?.landmark ?? [])]).toEqual([0, 2, 1, 3]);
    expect([...(delta?.epsilon ?? [])]).toEqual([2, 1, 1, 0]);
    expect(delta?.betti).toHaveLength(12);
    const mesh = finished.exportFile('mesh-ply', undefined);
    expect('failure' in mesh && mesh.failure.message).toMatch(/no mesh of this run/);
    expect(expected(finished.exportFile('betti-csv', undefined)).bytes.length).toBeGreaterThan(0);
    finished.delete();
  });

  test('that cannot be are sentences', () => {
    const asymmetric = file('m.csv', '0,1\n2,0\n');
    expect(refusal(asymmetric, { metric: 'matrix' })).toMatch(/not symmetric/);
    expect(refusal(matrix, { metric: 'matrix', family: 'delaunay' })).toMatch(/Only family witness/);
    const memoryLimit = 40;
    expect(refusal(matrix, { metric: 'matrix', memoryLimit })).toMatch(/only 1 MB may be used/);
  });

  test('tell a failing triangle inequality', () => {
    const run = new module.Run(file('m.csv', '1\n1 5\n'), { metric: 'matrix' });
    expect(opened(run).warnings).toEqual([expect.stringMatching(/^The triangle inequality fails in 1 of 1/)]);
    run.delete();
  });
});

describe('options of a run', () => {
  test('reach it', () => {
    const of = (options: RunOptions) => finishedRun(module, sample('sphere', 60), options).hash();
    const hashes = [
      of({ family: 'witness' }),
      of({ metric: 'l1' }),
      of({ metric: 'geodesic', knn: 5 }),
      of({ metric: 'geodesic', knn: 9 }),
      of({ metric: 'periodic', box: [1.1] }),
      of({ metric: 'periodic', box: [1.1, 0, 2] }),
      of({ family: 'witness', maxDimension: 1 }),
    ];
    expect(new Set(hashes).size).toBe(hashes.length);
  });

  test('show torsion where another field counts otherwise', () => {
    // As lines through its center the points of a sphere are the projective plane.
    const options: RunOptions = { metric: 'projective', nu: [1, 4, 5, 5], maxSteps: 60 };
    const run = new module.Run(sample('sphere', 1500), options);
    expect(opened(run)).toMatchObject({ field: 2, otherField: 3 });
    expected(run.run(Infinity, 60));
    const { betti, torsion } = expected(run.plateaus());
    const shown = Array.from({ length: betti.length / 3 }, (_, i) =>
      [betti, torsion].map((numbers) => numbers.subarray(3 * i, 3 * i + 3).join()).join(' | '),
    );
    expect(shown).toContain('1,1,1 | 1,0,0');
    expect(shown).toContain('1,0,0 | 0,0,0');
    const record = new RunRecord(openedWith({ bettiCount: 3, otherField: 3, family: 'witness' }));
    for (const delta of allDeltas(run, 1e6)) record.append(delta);
    const steps = Array.from({ length: record.stepCount }, (_, i) => record.summary(i + 1));
    const turned = steps.find((step) => step.betti.join() === '1,1,1');
    expect(turned?.torsion).toEqual({ field: 3, betti: [1, 0, 0] });
    expect(steps[0]?.torsion).toBeUndefined();
    run.delete();
  });

  test('may leave no triangles', () => {
    const run = finishedRun(module, sample('sphere', 40), { family: 'witness', maxDimension: 0 });
    const [delta] = allDeltas(run, 1e6);
    expect(delta?.betti).toHaveLength(40);
    expect(delta?.triangles).toHaveLength(0);
    expect(delta?.edges.length).toBeGreaterThan(0);
    run.delete();
  });

  test.each([
    [{ metric: 'l3' }, /no metric "l3"/],
    [{ metric: 'geodesic', knn: -1 }, /nearest neighbors must be a whole number/],
    [{ metric: 'periodic', box: [1, 1, 1] }, /one for each/],
    [{ family: 'witness', maxDimension: 7 }, /beta6 at most/],
    [{ family: 'witness', maxDimension: 0.5 }, /whole number/],
    [{ family: 'witness', field: 6 }, /must be a prime/],
  ])('that make no sense are sentences: %j', (options, message) => {
    expect(refusal(file('p.txt', '0 0\n1 0\n0 1\n3 4\n'), options)).toMatch(message);
  });

  test('a graph in pieces stops the run before its first step', () => {
    const run = new module.Run(file('p.txt', '0 0\n0 1\n9 9\n9 8\n'), { metric: 'geodesic', knn: 1 });
    opened(run);
    const progress = expected(run.run(Infinity, 1));
    expect(progress).toMatchObject({ state: 'stopped', stepsDone: 0 });
    expect(progress.stopped?.message).toMatch(/falls into 2 pieces/);
    const delta = expected(run.delta(100));
    expect(delta).toMatchObject({ state: 'stopped', stepCount: 0 });
    run.delete();
  });

  test('a wide table is taken as a whole where any dimension will do', () => {
    const source = file('p.txt', '0 0 0 0\n1 0 0 2\n0 1 0 3\n3 4 4 4\n');
    expect(refusal(source, {})).toMatch(/choose the coordinates/);
    const run = new module.Run({ ...source, anyDimension: true } as never, {});
    const answer = opened(run);
    expect(answer).toMatchObject({ points: 4, dimension: 4, bettiCount: 4, family: 'dilated' });
    const { projection } = answer;
    if (!projection) throw new Error('nothing to draw');
    // Four points span three dimensions.
    expect(frameOf(answer.points, projection)).toMatchObject({ count: 4, axes: 3 });
    expect(projection.shares.reduce((sum, share) => sum + share, 0)).toBeCloseTo(1);
    run.delete();
  });
});
