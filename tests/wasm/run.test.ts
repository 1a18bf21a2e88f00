import { beforeAll, describe, expect, test } from 'vitest';
import type { PlateauModule } from 'plateau-module';
import { COMPUTED_SAMPLES } from '../../web/src/app/samples.ts';
import { allDeltas, expected, file, finishedRun, loadModule, opened, runThrough, sample } from './module.ts';

let module: PlateauModule;
beforeAll(async () => {
  module = await loadModule();
});

describe('a run', () => {
  test('goes through a torus and tells its plateaus', () => {
    const run = finishedRun(module, sample('torus', 300));
    const plateaus = expected(run.plateaus());
    const count = plateaus.firstStep.length;
    const shapes = Array.from({ length: count }, (_, i) =>
      [...plateaus.betti.subarray(3 * i, 3 * i + 3)].join(),
    );
    expect(shapes).toContain('1,2,1');
    expect([...plateaus.ranked].sort((a, b) => a - b)).toEqual(Array.from({ length: count }, (_, i) => i));
    const ratios = [...plateaus.ranked].map((i) => plateaus.ratio[i] ?? 0);
    expect(ratios).toEqual([...ratios].sort((a, b) => b - a));
    run.delete();
  });

  test.each(['auto', 'surface', 'delaunay', 'witness'] as const)(
    'computes the same for any budget: %s',
    (family) => {
      const hashes = [1, 7, Infinity].map((budget) => {
        const run = new module.Run(sample('torus', 150), { family });
        opened(run);
        runThrough(run, budget);
        const hash = run.hash();
        run.delete();
        return hash;
      });
      expect(hashes[0]).toMatch(/^[0-9a-f]{16}$/);
      expect(new Set(hashes).size).toBe(1);
    },
  );

  test('keeps to a budget of steps', () => {
    const run = new module.Run(sample('torus', 200), {});
    opened(run);
    expected(run.run(Infinity, 1));
    let done = 0;
    for (let calls = 0; done === 0 && calls < 1000; ++calls) done = expected(run.run(Infinity, 10)).stepsDone;
    expect(done).toBeGreaterThan(0);
    expect(done).toBeLessThan(200);
    run.delete();
  });

  test('opens a file with its warnings, its columns and its defaults', () => {
    const text = '0 0 0 9 9\n1 0 0 9 9\n0 1 0 9 9\n0 0 1 9 9\n';
    const run = new module.Run({ ...file('p.xyz', text), columns: [3, 1] } as never, {});
    const answer = opened(run);
    expect(answer.dimension).toBe(2);
    expect([...answer.coordinates]).toEqual([0, 0, 0, 1, 0, 0, 1, 0]);
    expect(answer.family).toBe('delaunay');
    expect(answer.nu).toEqual([1, 2, 3]);
    expect(answer.stepsPlanned).toBe(4);
    expect(answer.estimatedBytes).toBeGreaterThan(0);
    expect(answer.memoryLimitBytes).toBeGreaterThan(answer.estimatedBytes);
    run.delete();
  });

  test('stops where it was asked to', () => {
    const run = finishedRun(module, sample('sphere', 200), { maxSteps: 20, first: 7 });
    const [delta] = allDeltas(run, 1e6);
    expect(delta?.stepCount).toBe(20);
    expect(delta?.landmark[0]).toBe(7);
    run.delete();
  });
});

describe('what a run appends', () => {
  test('is the same in one delta and in many', () => {
    const whole = finishedRun(module, sample('torus', 250));
    const parts = finishedRun(module, sample('torus', 250));
    const [one] = allDeltas(whole, 1e9);
    const many = allDeltas(parts, 100);
    expect(many.length).toBeGreaterThan(10);
    const joined = (key: 'landmark' | 'edges' | 'triangles' | 'rowVertices' | 'betti') =>
      many.flatMap((delta) => [...delta[key]]);
    for (const key of ['landmark', 'edges', 'triangles', 'rowVertices', 'betti'] as const) {
      expect(joined(key)).toEqual([...(one?.[key] ?? [])]);
    }
    // Deaths told later, put where they belong, give the deaths told at once.
    const death = [0, 1].map((track) => many.flatMap((delta) => [...(delta.edgeDeath[track] ?? [])]));
    const rowTo = many.flatMap((delta) => [...delta.rowTo]);
    for (const delta of many) {
      for (let i = 0; i < delta.deaths.length; i += 4) {
        const [dimension = 0, track = 0, index = 0, step = 0] = delta.deaths.subarray(i, i + 4);
        if (dimension === 1) (death[track] ?? [])[index] = step;
      }
      for (let i = 0; i < delta.endedRows.length; i += 2) {
        rowTo[delta.endedRows[i] ?? 0] = delta.endedRows[i + 1] ?? 0;
      }
    }
    expect(death).toEqual([[...(one?.edgeDeath[0] ?? [])], [...(one?.edgeDeath[1] ?? [])]]);
    expect(rowTo).toEqual([...(one?.rowTo ?? [])]);
    whole.delete();
    parts.delete();
  });

  test('tells what pumping came to, of each landmark once', () => {
    const options = { family: 'dilated', pump: true, maxSteps: 60 } as const;
    const whole = finishedRun(module, sample('torus', 2000), options);
    const parts = finishedRun(module, sample('torus', 2000), options);
    const [one] = allDeltas(whole, 1e9);
    const pumps = [...(one?.pumps ?? [])];
    expect(pumps).toHaveLength(5 * 60);
    expect(allDeltas(parts, 50).flatMap((delta) => [...delta.pumps])).toEqual(pumps);
    const numbers = (place: number): number[] => pumps.filter((_, i) => i % 5 === place);
    const [weights, before, after, amplitude] = [numbers(0), numbers(1), numbers(2), numbers(3)];
    expect(weights.filter((weight) => weight > 0).length).toBeGreaterThan(0);
    after.forEach((measure, i) => {
      expect(measure).toBeGreaterThanOrEqual(before[i] ?? NaN);
      expect(measure > (before[i] ?? NaN)).toBe((weights[i] ?? NaN) > 0);
    });
    expect(Math.max(...amplitude)).toBeGreaterThan(0);
    // A weight is chosen where a simplex enters or leaves.
    numbers(4).forEach((thresholds, i) => {
      expect(Number.isInteger(thresholds)).toBe(true);
      if ((weights[i] ?? NaN) > 0) expect(thresholds).toBeGreaterThan(0);
    });
    whole.delete();
    parts.delete();
    const plain = finishedRun(module, sample('torus', 100), { family: 'dilated', maxSteps: 9 });
    expect(allDeltas(plain, 1e9)[0]?.pumps).toHaveLength(0);
    plain.delete();
  });

  test('is copied: later growth of the memory does not change it', () => {
    const run = finishedRun(module, sample('torus', 200));
    const delta = expected(run.delta(1e6));
    const before = [...delta.edges];
    expect(delta.edges.buffer.byteLength).toBe(delta.edges.byteLength);
    const large = new module.Run(sample('sphere', 150_000), {});
    opened(large);
    expected(large.run(50, 0xffffffff));
    large.delete();
    expect([...delta.edges]).toEqual(before);
    run.delete();
  });
});

describe('files', () => {
  test('come in the formats of the command', () => {
    const run = finishedRun(module, sample('torus', 200));
    const text = (format: 'betti-csv' | 'plateaus-json' | 'mesh-ply', step?: number) =>
      new TextDecoder().decode(expected(run.exportFile(format, step)).bytes);
    const lines = text('betti-csv').trimEnd().split('\n');
    expect(lines[0]).toBe('step,landmark,epsilon,family,beta0,beta1,beta2');
    expect(lines).toHaveLength(201);
    expect(JSON.parse(text('plateaus-json'))).toHaveProperty('plateaus');
    expect(text('mesh-ply', 50)).toMatch(/^ply\nformat ascii 1\.0\n/);
    expect(run.exportFile('mesh-ply', 201)).toHaveProperty('failure.code', 8);
    run.delete();
  });
});

describe('failures are values', () => {
  test.each([
    ['no file at all', file('a.xyz', ''), {}, /./],
    ['a number that is none', file('a.xyz', '0 0 0\n1 nan 0\n0 1 1\n'), {}, /[Ll]ine 2/],
    ['rows of different length', file('a.xyz', '0 0 0\n1 2\n'), {}, /[Ll]ine 2/],
    ['one point', file('a.xyz', '1 2 3\n'), {}, /./],
    ['a picture', file('a.xyz', Uint8Array.of(0x89, 0x50, 0x4e, 0x47, 13, 10, 26, 10)), {}, /PNG/],
    ['a shape that is none', sample('cube', 10), {}, /torus/],
    ['no points', sample('torus', 0), {}, /./],
    ['half a point', sample('torus', 1.5), {}, /whole number/],
    ['a first landmark beyond the cloud', sample('torus', 10), { first: 10 }, /./],
    ['a family that is none', sample('torus', 10), { family: 'alpha' as never }, /family/],
    ['a surface in the plane', sample('circle-noise', 10), { family: 'surface' as const }, /./],
  ])('%s', (_, source, options, words) => {
    const run = new module.Run(source, options);
    let answer = run.open(5);
    while (answer.kind === 'reading') answer = run.open(5);
    if (answer.kind !== 'failed') throw new Error('it opened');
    expect(answer.failure.code).toBeGreaterThanOrEqual(1);
    expect(answer.failure.code).toBeLessThanOrEqual(12);
    expect(answer.failure.message).toMatch(words);
    run.delete();
  });

  test('before a run is open', () => {
    const run = new module.Run(sample('torus', 10), {});
    expect(run.run(1, 1)).toHaveProperty('kind', 'failed');
    expect(run.delta(1)).toHaveProperty('kind', 'failed');
    expect(run.plateaus()).toHaveProperty('kind', 'failed');
    expect(run.exportFile('betti-csv', undefined)).toHaveProperty('kind', 'failed');
    run.delete();
  });
});

test('the page offers the shapes that the module has, in their usual sizes', () => {
  const known = new Map(module.sampleShapes().map(({ name, defaultSize }) => [name, defaultSize]));
  expect(COMPUTED_SAMPLES.length).toBeGreaterThan(0);
  for (const { shape, size } of COMPUTED_SAMPLES) expect(known.get(shape), shape).toBe(size);
});
