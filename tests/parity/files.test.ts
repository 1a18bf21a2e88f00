import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { beforeAll, describe, expect, test } from 'vitest';
import type { ModuleRun, PlateauModule } from 'plateau-module';
import type { ExportFormat } from '../../web/src/worker/protocol.ts';
import { expected, file, loadModule, opened, runThrough } from '../wasm/module.ts';
import { cases, full, plateau, title, type Case } from './cases.ts';

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

type Answers = Map<ExportFormat, Buffer | string>;

/** What one run of the command writes for the formats: the bytes, or for all of them why there are none. */
function commandAnswers(one: Case, formats: readonly ExportFormat[], step?: number): Answers {
  const folder = mkdtempSync(join(tmpdir(), 'plateau-'));
  const input = join(folder, one.fileName);
  writeFileSync(input, one.text);
  const outputs = asked.filter(([format]) => formats.includes(format));
  const words = outputs.flatMap(([, option, name]) => [option, join(folder, name)]);
  const at = step === undefined ? [] : ['--at', String(step)];
  try {
    plateau(['run', input, '--family', one.family, ...(one.words ?? []), ...words, ...at]);
  } catch (error) {
    const why = String((error as { stderr: unknown }).stderr).replace(/^plateau: |\n$/g, '');
    return new Map(formats.map((format) => [format, why]));
  }
  return new Map(outputs.map(([format, , name]) => [format, readFileSync(join(folder, name))]));
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
  test.each(some.map((one) => ({ ...one, title: title(one) })))(
    '$title',
    (one) => {
      const points = { ...file(one.fileName, one.text), ...(one.anyDimension && { anyDimension: true }) };
      const run = new module.Run(points, { family: one.family, ...one.options });
      const { stepsPlanned } = opened(run);
      runThrough(run, Infinity);
      const done = expected(run.run(0, 1)).stepsDone;
      expect(done).toBeLessThanOrEqual(stepsPlanned);
      for (const step of [undefined, Math.ceil(done / 3)]) {
        const here = new Map(asked.map(([format]) => [format, moduleAnswer(run, format, step)]));
        // One mesh a run; what is refused is asked for alone.
        const meshes = (['mesh-off', 'mesh-glb'] as const).filter(
          (format) => here.get(format) instanceof Buffer,
        );
        const alone = asked
          .map(([format]) => format)
          .filter((format) => typeof here.get(format) === 'string');
        const rest = asked
          .map(([format]) => format)
          .filter((format) => here.get(format) instanceof Buffer && !meshes.some((mesh) => mesh === format));
        const there: Answers = new Map([
          ...commandAnswers(one, rest, step),
          ...[...meshes, ...alone].flatMap((format) => [...commandAnswers(one, [format], step)]),
        ]);
        for (const [format, expectedAnswer] of there) {
          const answer = here.get(format);
          if (typeof answer === 'string' || answer === undefined) expect(answer, format).toBe(expectedAnswer);
          else expect(answer.equals(expectedAnswer as Buffer), `${format} at ${step}`).toBe(true);
        }
        expect(there.size).toBe(asked.length);
      }
      run.delete();
    },
    full ? 600_000 : 60_000,
  );
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
  const there = commandAnswers({ ...one, words }, ['complex-vtk'], 60).get('complex-vtk');
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
