import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { beforeAll, describe, expect, test } from 'vitest';
import type { ModuleRun, PlateauModule } from 'plateau-module';
import type { ExportFormat } from '../../web/src/worker/protocol.ts';
import { expected, file, loadModule, opened, runThrough } from '../wasm/module.ts';
import { cases, plateau, title, type Case } from './cases.ts';

let module: PlateauModule;
beforeAll(async () => {
  module = await loadModule();
});

/** How the command is asked for what the module calls by the name. */
const asked: readonly (readonly [ExportFormat, string, string])[] = [
  ['mesh-ply', '--mesh', 'mesh.ply'],
  ['mesh-off', '--mesh', 'mesh.off'],
  ['mesh-glb', '--mesh', 'mesh.glb'],
  ['complex-vtk', '--complex', 'complex.vtk'],
  ['surface-report', '--report', 'report.json'],
  ['session', '--session', 'run.plateau'],
  ['betti-csv', '--betti', 'betti.csv'],
  ['plateaus-json', '--plateaus', 'plateaus.json'],
];

/** What the command says for the format: the bytes, or why there are none. */
function commandAnswer(one: Case, option: string, name: string, step?: number): Buffer | string {
  const folder = mkdtempSync(join(tmpdir(), 'plateau-'));
  const input = join(folder, one.fileName);
  writeFileSync(input, one.text);
  const at = step === undefined ? [] : ['--at', String(step)];
  const words = ['run', input, '--family', one.family, ...(one.words ?? []), option, join(folder, name)];
  try {
    plateau([...words, ...(option === '--betti' || option === '--plateaus' ? [] : at)]);
  } catch (error) {
    return String((error as { stderr: unknown }).stderr).replace(/^plateau: |\n$/g, '');
  }
  return readFileSync(join(folder, name));
}

function moduleAnswer(run: ModuleRun, format: ExportFormat, step?: number): Buffer | string {
  const answer = run.exportFile(format, step);
  return answer.kind === 'failed' ? answer.failure.message : Buffer.from(answer.bytes);
}

/** One of each kind: surfaces, curves, the plane, grids, every metric, more coordinates, distances alone. */
const some = cases().filter(
  ({ name, family, words }) =>
    (['torus', 'helix'].includes(name) && family === 'auto') ||
    (['double-torus'].includes(name) && family === 'surface') ||
    (['circle-noise', 'scan.csv', 'grid of tenths in space'].includes(name) && family === 'delaunay') ||
    (name === 'line in space' && family === 'auto') ||
    words !== undefined,
);

describe('the module exports what the command writes', () => {
  test.each(some.map((one) => ({ ...one, title: title(one) })))('$title', (one) => {
    const points = { ...file(one.fileName, one.text), ...(one.anyDimension && { anyDimension: true }) };
    const run = new module.Run(points, { family: one.family, ...one.options });
    const { stepsPlanned } = opened(run);
    runThrough(run, Infinity);
    const done = expected(run.run(0, 1)).stepsDone;
    expect(done).toBeLessThanOrEqual(stepsPlanned);
    for (const step of [undefined, Math.ceil(done / 3)]) {
      for (const [format, option, name] of asked) {
        const [here, there] = [moduleAnswer(run, format, step), commandAnswer(one, option, name, step)];
        expect(typeof here, `${format} at ${step}: ${String(here).slice(0, 99)}`).toBe(typeof there);
        if (typeof here === 'string') expect(here).toBe(there);
        else expect(here.equals(there as Buffer), `${format} at ${step}`).toBe(true);
      }
    }
    run.delete();
  });
});

test('places of many distances are scaled in one order of sums, whatever the processor', () => {
  const at = Array.from({ length: 450 }, (_, i) => [
    (i * Math.SQRT2) % 3,
    (i * Math.sqrt(3)) % 2,
    (i % 7) / 9,
  ]);
  const between = (a: number[], b: number[]): number =>
    Math.sqrt(a.reduce((sum, x, axis) => sum + (x - (b[axis] ?? NaN)) ** 2, 0));
  const text = at.slice(1).map((a, i) =>
    at
      .slice(0, i + 1)
      .map((b) => between(a, b))
      .join(),
  );
  const one = { name: 'many', family: 'witness', fileName: 'm.csv', text: text.join('\n') } as const;
  const run = new module.Run(file(one.fileName, one.text), {
    metric: 'matrix',
    maxSteps: 60,
    maxDimension: 1,
  });
  opened(run);
  runThrough(run, Infinity);
  const words = ['--metric', 'matrix', '--steps', '60', '--max-dim', '1'];
  const there = commandAnswer({ ...one, words }, '--complex', 'complex.vtk', 60);
  expect(moduleAnswer(run, 'complex-vtk', 60)).toEqual(there);
  run.delete();
});

test('each opens the session of the other as its own run', () => {
  const folder = mkdtempSync(join(tmpdir(), 'plateau-'));
  const one = some.find(({ name }) => name === 'torus');
  if (!one) throw new Error('the torus is a case');
  const run = new module.Run(file(one.fileName, one.text), {
    family: 'delaunay',
    nu: [1, 2, 3, 4],
    maxSteps: 90,
  });
  opened(run);
  runThrough(run, Infinity);
  const path = join(folder, 'a.plateau');
  writeFileSync(path, expected(run.exportFile('session', 33, '{"zoom":2}')).bytes);
  const other = join(folder, 'b.plateau');
  expect(plateau(['run', path, '--hash', '--session', other])).toBe(`hash ${run.hash()}\n`);
  expect(readFileSync(other).equals(readFileSync(path))).toBe(true);
  const again = new module.Run(file('b.plateau', readFileSync(other)), {});
  expect(opened(again).session).toMatchObject({ step: 33, view: '{"zoom":2}', hash: run.hash() });
  run.delete();
  again.delete();
});
