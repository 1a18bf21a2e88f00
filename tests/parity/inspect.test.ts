import { mkdtempSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { beforeAll, expect, test } from 'vitest';
import type { PlateauModule } from 'plateau-module';
import { expected, file, loadModule, opened, runThrough } from '../wasm/module.ts';
import { cases, plateau, title } from './cases.ts';

let module: PlateauModule;
beforeAll(async () => {
  module = await loadModule();
});

/** Curves, surfaces, the plane, a grid, every metric, more coordinates, distances alone. */
const some = cases().filter(
  ({ name, family, words }) =>
    (['torus', 'helix', 'circle-noise'].includes(name) && family === 'delaunay') ||
    (name === 'torus' && family === 'auto') ||
    (name === 'grid of tenths in space' && family === 'witness') ||
    words !== undefined,
);

/** Questions say where to stop. */
function withoutEnd(words: readonly string[] = []): readonly string[] {
  const at = words.indexOf('--steps');
  return at < 0 ? words : [...words.slice(0, at), ...words.slice(at + 2)];
}

test('there are questions about every family', () => {
  const families = new Set(some.map(({ family }) => family));
  expect([...families].sort()).toEqual(['auto', 'delaunay', 'dilated', 'witness']);
});

test.each(some.map((one) => [title(one), one] as const))(
  'the command and the module give the same answers: %s',
  (_, one) => {
    const input = join(mkdtempSync(join(tmpdir(), 'plateau-')), one.fileName);
    writeFileSync(input, one.text);
    const step = 12;
    const { family, options, anyDimension } = one;
    const points = file(one.fileName, one.text);
    const source = anyDimension === undefined ? points : { ...points, anyDimension };
    const run = new module.Run(source, { ...options, family, maxSteps: step });
    opened(run);
    runThrough(run, Infinity);
    for (const simplex of [[12], [1, 12], [2, 3], [4, 9, 11], [1, 2, 3, 4], [3, 14]]) {
      const words = ['--step', String(step), '--simplex', simplex.join(',')];
      const printed = plateau(['inspect', input, '--family', family, ...withoutEnd(one.words), ...words]);
      expect(`${expected(run.inspect(step, simplex)).inspection.text}\n`).toBe(printed);
    }
    run.delete();
  },
);
