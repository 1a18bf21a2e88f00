import { beforeAll, describe, expect, test } from 'vitest';
import type { PlateauModule } from 'plateau-module';
import { COMPUTED_SAMPLES } from '../../web/src/app/samples.ts';
import type { CloudSource } from '../../web/src/worker/protocol.ts';
import { file, loadModule, opened, runThrough, sample } from '../wasm/module.ts';
import { cases, commandHash, full, title } from './cases.ts';

let module: PlateauModule;
beforeAll(async () => {
  module = await loadModule();
});

const all = cases();

test('the page offers shapes of the core, with their sizes', () => {
  const known = module.sampleShapes().map(({ name, defaultSize }) => `${name} ${defaultSize}`);
  for (const { shape, size } of COMPUTED_SAMPLES) expect(known).toContain(`${shape} ${size}`);
});

describe('the module computes what the command computes', () => {
  const timeout = full ? 600_000 : 60_000;
  test.each(all.map((one) => ({ ...one, title: title(one) })))(
    '$title',
    (one) => {
      const expected = commandHash(one);
      const points = { ...file(one.fileName, one.text), ...(one.anyDimension && { anyDimension: true }) };
      const runs: [CloudSource, number][] = [
        [points, 1],
        [points, Infinity],
      ];
      if (one.sample) runs.push([sample(one.sample.shape, one.sample.size), Infinity]);
      for (const [source, budget] of runs) {
        const run = new module.Run(source, { family: one.family, ...one.options });
        opened(run);
        runThrough(run, budget);
        expect(run.hash(), `${source.kind}, budget ${budget} ms`).toBe(expected);
        run.delete();
      }
    },
    timeout,
  );
});

describe('the command prints the points that the module makes, bit for bit', () => {
  const shapes = all.filter(({ family, sample: made }) => made && family === 'delaunay');
  test.each(shapes)('$name', ({ sample: made, text }) => {
    if (!made) throw new Error('only shapes are asked here');
    const run = new module.Run(sample(made.shape, made.size), {});
    const printed = text.trimEnd().split(/\s+/).map(Number);
    expect([...opened(run).coordinates]).toEqual(printed);
    run.delete();
  });
});
