import { beforeAll, describe, expect, test } from 'vitest';
import type { ModuleRun, PlateauModule } from 'plateau-module';
import { bytesOf, cases, eachStep } from './exported-shapes.ts';
import { file, loadModule, opened, runThrough, sample } from './module.ts';

let module: PlateauModule;
beforeAll(async () => {
  module = await loadModule();
});

interface Report {
  readonly step: number;
  readonly epsilon: number | null;
  readonly components: number;
  readonly genus: number;
  readonly euler_characteristic: number;
  readonly vertices: number;
  readonly triangles: number;
  readonly volume: number;
  readonly parts: readonly { readonly genus: number; readonly area: number }[];
  readonly doubled_vertices: readonly { readonly landmark: number; readonly copies: number }[];
  readonly doubled_edges: readonly { readonly landmarks: readonly number[]; readonly copies: number }[];
}

const reportOf = (run: ModuleRun, step?: number): Report =>
  JSON.parse(new TextDecoder().decode(bytesOf(run, 'surface-report', step))) as Report;

describe('the report of the surface', () => {
  test.each(cases.slice(0, 3))('$name', (one) =>
    eachStep(module, one, (run, told, step) => {
      const report = reportOf(run, step);
      const { surface, family, betti } = told.at(step);
      expect(report.step).toBe(step);
      expect(report.epsilon).toBe(told.epsilon(step));
      expect(report.triangles).toBe(surface.length);
      expect(report.parts.length).toBe(report.components);
      if (family !== 2) {
        expect(report).toMatchObject({ components: 0, genus: 0, volume: 0, parts: [], doubled_edges: [] });
        return;
      }
      expect(report.components).toBe(betti[0]);
      expect(2 * report.genus).toBe(betti[1]);
      const landmarks = new Set(surface.flatMap((triangle) => triangle.split(',')));
      const more = report.doubled_vertices.reduce((sum, { copies }) => sum + copies - 1, 0);
      expect(report.vertices).toBe(landmarks.size + more);
    }),
  );

  test('two octahedra that touch at a vertex have it twice', () => {
    const octahedron = (x: number): number[][] =>
      [0, 1, 2].flatMap((axis) =>
        [-1, 1].map((side) => [0, 1, 2].map((k) => (k === axis ? side : 0) + (k === 0 ? x : 0))),
      );
    const points = [...octahedron(0), ...octahedron(2)];
    const text = [...new Set(points.map((point) => point.join(' ')))].join('\n');
    const run = new module.Run(file('two.xyz', text), { family: 'surface' });
    opened(run);
    runThrough(run, Infinity);
    const report = reportOf(run, 11);
    const shared = text.split('\n').indexOf('1 0 0');
    expect(report.doubled_vertices).toMatchObject([{ landmark: shared, copies: 2 }]);
    expect(report).toMatchObject({ components: 2, genus: 0, euler_characteristic: 4, vertices: 12 });
    expect(report.volume).toBeCloseTo(8 / 3, 12);
    expect(report.parts[0]?.area).toBeCloseTo(4 * Math.sqrt(3), 12);
    run.delete();
  });

  test('before the first step there is no surface', () => {
    const run = new module.Run(sample('torus', 50), {});
    opened(run);
    expect(reportOf(run)).toMatchObject({ step: 0, epsilon: null, components: 0 });
    run.delete();
  });

  test('is refused where no surface is followed', () => {
    const run = new module.Run(sample('circle-noise', 30), {});
    opened(run);
    runThrough(run, Infinity);
    expect(run.exportFile('surface-report', 3)).toHaveProperty('failure.code', 8);
    run.delete();
  });
});
