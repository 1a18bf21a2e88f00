import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, test } from 'vitest';
import type { ModuleRun, PlateauModule } from 'plateau-module';
import { PlateauClient } from '../../web/src/client/plateau-client.ts';
import { InProcessWorker } from '../../web/src/package/in-process.ts';
import type { Inspection, PlaneView } from '../../web/src/worker/inspection.ts';
import { allDeltas, expected, finishedRun, loadModule, opened, sample } from './module.ts';

const NEVER = 0xffffffff;
let module: PlateauModule;
beforeAll(async () => {
  module = await loadModule();
});

function why(run: ModuleRun, step: number, vertices: readonly number[]): Inspection {
  return expected(run.inspect(step, vertices)).inspection;
}

describe('inspect', () => {
  test('tells the lifespan that the record has, of every edge', () => {
    const run = finishedRun(module, sample('torus', 80), { family: 'delaunay' });
    const step = 50;
    const living = new Map<string, readonly [number, number]>();
    const [delta] = allDeltas(run, 1_000_000);
    if (!delta) throw new Error('no delta');
    const { edges, edgeDeath } = delta;
    edgeDeath[0].forEach((death, i) => {
      const [a = 0, b = 0] = edges.subarray(2 * i, 2 * i + 2);
      if (b <= step && death > step) living.set(`${a},${b}`, [b, death]);
    });
    let present = 0;
    for (let b = 2; b <= step; b += 3) {
      for (let a = 1; a < b; a += 2) {
        const { verdict, birth, death, witnesses, witnessCount, ranks, blockers } = why(run, step, [b, a]);
        const lifespan = living.get(`${a},${b}`);
        expect(verdict === 'present').toBe(lifespan !== undefined);
        if (verdict === 'notDelaunay') expect(blockers.length).toBeGreaterThan(0);
        if (verdict === 'notWitnessed') expect(witnessCount).toBe(0);
        if (!lifespan) continue;
        present += 1;
        expect([birth, death]).toEqual(lifespan);
        expect(witnesses).toHaveLength(witnessCount);
        expect(Math.max(...ranks)).toBeLessThanOrEqual(6);
      }
    }
    expect(present).toBeGreaterThan(10);
  });

  test('speaks of every field', () => {
    const run = finishedRun(module, sample('torus', 80), { maxSteps: 30 });
    const vertex = why(run, 30, [4]);
    expect(vertex).toMatchObject({
      ...{ step: 30, verdict: 'present', birth: 4, death: NEVER, allowed: 1, horizon: 30, flat: false },
      simplex: Uint32Array.of(4),
      about: Uint32Array.of(4),
      best: { rank: 1, distance: 0, ranks: Uint32Array.of(1) },
    });
    expect(vertex.zeta).toBeUndefined();
    expect(vertex.text).toMatch(/^Landmark 4 is in the complex at step 30\. /);
    const later = why(run, 10, [30, 4, 20]);
    expect(later).toMatchObject({
      verdict: 'notInserted',
      about: Uint32Array.of(20, 30),
      birth: 0,
      death: 0,
    });
    expect(why(run, 30, [1, 2, 3, 4, 5]).verdict).not.toBe('present');
    const dilated = finishedRun(module, sample('torus', 80), { family: 'dilated', maxSteps: 12 });
    expect(why(dilated, 12, [5])).toMatchObject({ verdict: 'present', allowed: 0, surface: 'none' });
    expect(why(dilated, 12, [5]).zeta).toBeGreaterThan(0);
  });

  test('changes nothing of what is computed', () => {
    const asked = new module.Run(sample('torus', 200), {});
    opened(asked);
    for (let i = 0; i < 200; ++i) {
      const { stepsDone } = expected(asked.run(Infinity, 1));
      if (stepsDone > 3) why(asked, stepsDone, [1, 1 + (i % 3) + 1]);
    }
    expect(asked.hash()).toBe(finishedRun(module, sample('torus', 200)).hash());
  });

  test.each([
    [99, [1], 'Step 99 is not computed: there are steps 1 to 9.'],
    [9, [], 'Name at least one landmark by the step that inserted it.'],
    [9, [1.5], 'Each landmark must be a whole number of at least 0.'],
    [-1, [1], 'The step must be a whole number of at least 0.'],
    [9, [3, 3], 'Landmark 3 is named twice.'],
  ])('refuses step %s, landmarks %s', (step, vertices, message) => {
    const run = finishedRun(module, sample('torus', 80), { maxSteps: 9 });
    expect(run.inspect(step, vertices)).toMatchObject({ kind: 'failed', failure: { code: 8, message } });
  });
});

/** A square with a landmark in its middle, and witnesses near its left side and its middle. */
const SQUARE: PlaneView = {
  witnesses: [-0.2, 0.45, 0.1, 0.1, 0.3, 0.45, 0.55, 0.5, 0.1, 0.9],
  landmarks: [0, 0, 1, 0, 0, 1, 1, 1, 0.5, 0.5],
  nu: [1, 2, 3],
  box: [0, 0, 1, 1],
};

describe('planePicture', () => {
  const draw = (view: PlaneView) => expected(module.planePicture(view)).picture;

  test('draws a square', () => {
    const picture = draw(SQUARE);
    expect([...picture.delaunayEdges].join()).toBe('0,1,0,2,0,4,1,3,1,4,2,3,2,4,3,4');
    expect([...picture.delaunayTriangles].join()).toBe('0,1,4,0,2,4,1,3,4,2,3,4');
    expect(picture.listLength).toBe(3);
    expect([...picture.lists.subarray(0, 3)]).toEqual([0, 2, 4]);
    expect([...picture.vertices]).toEqual([0, 2, 4]);
    expect([...picture.edges]).toEqual([0, 2, 0, 4, 2, 4]);
    expect([...picture.edgeWitnesses.first]).toEqual([0, 1, 3, 4]);
    expect([...picture.edgeWitnesses.witnesses]).toEqual([0, 1, 2, 4]);
    expect([...picture.betti]).toEqual([1, 0]);
    const corners = (i: number): string =>
      [
        ...picture.cells.corners.subarray(
          2 * (picture.cells.first[i] ?? 0),
          2 * (picture.cells.first[i + 1] ?? 0),
        ),
      ].join();
    expect(corners(0)).toBe('0,0,0.5,0,0,0.5');
    expect(picture.cells.first).toHaveLength(6);
    expect(picture.pairCells.first).toHaveLength(9);
  });

  test('takes typed arrays, and the whole complex', () => {
    const typed = { ...SQUARE, witnesses: Float64Array.from(SQUARE.witnesses) };
    expect(draw(typed)).toEqual(draw(SQUARE));
    const whole = draw({ ...SQUARE, witnesses: [0.5, 0, 0.45, 0.1], nu: [2, 3], delaunay: false });
    expect(whole.edges.length).toBeGreaterThan(0);
  });

  test('answers why', () => {
    const { inspection } = expected(module.planeWhy(SQUARE, [3, 0]));
    expect(inspection).toMatchObject({
      verdict: 'notWitnessed',
      about: Uint32Array.of(3),
      step: 0,
      birth: 0,
    });
    const inside = expected(module.planeWhy(SQUARE, [2, 0, 4])).inspection;
    expect(inside.verdict).toBe('present');
    expect(inside.text).toBe(
      'The triangle of landmarks 1, 3 and 5 is in the complex. ' +
        '3 witnesses have all 3 of them among their 3 nearest landmarks, the best is point 0, ' +
        'for which the last of them is number 3.',
    );
    expect(module.planeWhy(SQUARE, [7])).toMatchObject({ inspection: { verdict: 'notInserted' } });
  });

  test.each([
    [{ ...SQUARE, landmarks: [0, 0, 1, 1, 0, 0] }, 'Landmarks 1 and 3 are in one place'],
    [{ ...SQUARE, witnesses: [0, NaN] }, 'A coordinate of witness 1'],
    [{ ...SQUARE, box: [1, 0, 0, 1] as const }, 'The box must have'],
  ])('refuses what is no picture', (view, message) => {
    const answer = module.planePicture(view);
    expect('failure' in answer && answer.failure.message).toContain(message);
  });
});

describe('the client', () => {
  test('asks about runs and pictures', async () => {
    const bytes = readFileSync(new URL('../../build/wasm/bin/plateau.wasm', import.meta.url));
    const client = new PlateauClient({ spawn: () => new InProcessWorker(bytes, setImmediate) });
    const run = await client.open(sample('torus', 60), { maxSteps: 20 });
    while ((await run.fetchDelta()).state !== 'finished');
    expect((await run.inspect(20, [1, 2, 3])).text).toContain('landmarks 1, 2 and 3');
    await expect(run.inspect(21, [1])).rejects.toThrow('Step 21 is not computed');
    expect((await client.planePicture(SQUARE)).edges).toHaveLength(6);
    expect((await client.planeWhy(SQUARE, [0])).verdict).toBe('present');
    await expect(client.planeWhy(SQUARE, [])).rejects.toThrow('Name at least one landmark');
    client.dispose();
  });
});
