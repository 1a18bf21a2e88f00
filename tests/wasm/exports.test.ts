import { validateBytes } from 'gltf-validator';
import { Mesh, LineSegments, Points, Vector3, type BufferGeometry, type Object3D } from 'three';
import { GLTFLoader } from 'three/examples/jsm/loaders/GLTFLoader.js';
import { PLYLoader } from 'three/examples/jsm/loaders/PLYLoader.js';
import { beforeAll, describe, expect, test } from 'vitest';
import type { PlateauModule } from 'plateau-module';
import { Told, bytesOf, cases, eachStep, turned, type Check, type ExportCase } from './exported-shapes.ts';
import { file, loadModule, opened, runThrough, sample } from './module.ts';
import { readVtk } from './vtk-file.ts';

let module: PlateauModule;
beforeAll(async () => {
  module = await loadModule();
});

/** Finishes a run of the case and looks at its steps. */
const each = (one: ExportCase, check: Check): Promise<void> => eachStep(module, one, check);

/** Vertices of a file are told by where they lie; no two landmarks of the cases above lie at one place. */
function stepsByPlace(told: Told, rounded: (place: number[]) => string): Map<string, number> {
  const found = new Map<string, number>();
  for (let step = 1; step <= told.steps; ++step) found.set(rounded(told.position(step)), step);
  expect(found.size).toBe(told.steps);
  return found;
}

const inOrder = (simplices: number[][]): string[] =>
  simplices.map((simplex) => simplex.sort((a, b) => a - b).join()).sort();

/** Vertices, edges and triangles that a file holds, by step, are those of the run. */
function expectShape(
  told: Told,
  step: number,
  vertices: readonly number[],
  edges: readonly number[][],
  triangles: readonly number[][],
): void {
  const shown = told.at(step);
  const named = (simplex: readonly number[]): number[] => simplex.map((vertex) => vertices[vertex] ?? NaN);
  if (shown.family === 2) {
    expect(edges).toEqual([]);
    expect(triangles.map((triangle) => turned(named(triangle))).sort()).toEqual(shown.surface);
    // Closed: every side is met as often in one direction as in the other.
    const sides = triangles.flatMap(([a, b, c]) => [`${a} ${b}`, `${b} ${c}`, `${c} ${a}`]).sort();
    const back = triangles.flatMap(([a, b, c]) => [`${b} ${a}`, `${c} ${b}`, `${a} ${c}`]).sort();
    expect(sides).toEqual(back);
    // What was met twice is there twice.
    const euler = vertices.length - (3 * triangles.length) / 2 + triangles.length;
    const [components = 0, loops = 0, voids = 0] = shown.betti;
    expect(euler).toBe(components - loops + voids);
  } else {
    expect(vertices).toEqual(Array.from({ length: step }, (_, i) => i + 1));
    expect(inOrder(edges.map(named))).toEqual(shown.edges);
    expect(inOrder(triangles.map(named))).toEqual(shown.triangles);
  }
}

const rowsOf = (values: ArrayLike<number>, width: number): number[][] =>
  Array.from({ length: values.length / width }, (_, i) =>
    Array.from({ length: width }, (_, k) => values[width * i + k] ?? NaN),
  );

describe('PLY, read by three.js and by its words', () => {
  test.each(cases)('$name', (one) =>
    each(one, (run, told, step) => {
      const bytes = bytesOf(run, 'mesh-ply', step);
      const [header = '', body = ''] = new TextDecoder().decode(bytes).split('end_header\n');
      const count = (element: string): number =>
        Number(new RegExp(`element ${element} (\\d+)`).exec(header)?.[1] ?? 0);
      const lines = body.split('\n').map((line) => line.split(' ').map(Number));
      const places = lines.slice(0, count('vertex'));
      const edges = lines.slice(places.length, places.length + count('edge'));
      const faces = lines.slice(places.length + edges.length, -1).map(([, ...corners]) => corners);
      expect(faces.length).toBe(count('face'));
      const steps = stepsByPlace(told, (place) => place.join());
      const vertices = places.map((place) => steps.get(place.join()) ?? NaN);
      expectShape(told, step, vertices, edges, faces);

      const geometry = new PLYLoader().parse(bytes.buffer);
      expect(rowsOf(geometry.getAttribute('position')?.array ?? [], 3)).toEqual(places);
      expect(rowsOf(geometry.index?.array ?? [], 3)).toEqual(faces);
    }),
  );
});

describe('OFF, by its words', () => {
  test.each(cases)('$name', (one) =>
    each(one, (run, told, step) => {
      const text = new TextDecoder().decode(bytesOf(run, 'mesh-off', step));
      const lines = text.split('\n').filter((line) => line !== '' && !line.startsWith('#'));
      expect(lines.shift()).toBe('OFF');
      const rows = lines.map((line) => line.split(' ').map(Number));
      const [[points = NaN, faces = NaN] = []] = rows;
      expect(rows.length).toBe(1 + points + faces);
      const steps = stepsByPlace(told, (place) => place.join());
      const vertices = rows.slice(1, 1 + points).map((place) => steps.get(place.join()) ?? NaN);
      const polygons = rows.slice(1 + points);
      for (const [corners, ...polygon] of polygons) expect(polygon.length).toBe(corners);
      const ofSize = (size: number): number[][] =>
        polygons.filter(([corners]) => corners === size).map(([, ...polygon]) => polygon);
      expect(ofSize(2).length + ofSize(3).length).toBe(faces);
      expectShape(told, step, vertices, ofSize(2), ofSize(3));
    }),
  );
});

/** The primitives of a file as three.js understands them, with positions in input units. */
async function loaded(
  bytes: Uint8Array<ArrayBuffer>,
): Promise<Map<string, Object3D & { geometry: BufferGeometry }>> {
  const { scene } = await new GLTFLoader().parseAsync(bytes.buffer, '');
  scene.updateMatrixWorld(true);
  const found = new Map<string, Object3D & { geometry: BufferGeometry }>();
  scene.traverse((object) => {
    if (object instanceof LineSegments) found.set('lines', object);
    else if (object instanceof Points) found.set('points', object);
    else if (object instanceof Mesh) found.set('triangles', object as Mesh);
  });
  return found;
}

async function expectValid(bytes: Uint8Array): Promise<void> {
  const { issues } = await validateBytes(bytes);
  expect(issues.messages).toEqual([]);
  expect(issues.numErrors + issues.numWarnings).toBe(0);
}

describe('GLB, judged by the validator of Khronos and read by three.js', () => {
  test.each(cases)('$name', (one) =>
    each(one, async (run, told, step) => {
      const bytes = bytesOf(run, 'mesh-glb', step);
      await expectValid(bytes);
      const primitives = await loaded(bytes);
      const all = [...primitives.values()];
      const [first] = all;
      if (!first) {
        expect(told.at(step).family).toBe(2);
        expect(told.at(step).surface).toEqual([]);
        return;
      }
      const positions = rowsOf(first.geometry.getAttribute('position').array, 3).map((place) => {
        const [x, y, z] = place;
        return new Vector3(x, y, z).applyMatrix4(first.matrixWorld).toArray();
      });
      // Single precision of the size of the shape, wherever it lies: far below the distance of two landmarks.
      const shape = told.at(step);
      const vertices = positions.map((place) => {
        for (let other = 1; other <= told.steps; ++other) {
          const near = told.position(other).every((x, axis) => {
            const scale = first.getWorldScale(new Vector3()).x;
            return Math.abs(x - (place[axis] ?? NaN)) <= scale * 2 ** -24 + Math.abs(x) * 2 ** -51;
          });
          if (near) return other;
        }
        return NaN;
      });
      const indices = (name: string, width: number): number[][] =>
        rowsOf(primitives.get(name)?.geometry.index?.array ?? [], width);
      expectShape(told, step, vertices, indices('lines', 2), indices('triangles', 3));
      expect(primitives.has('points')).toBe(shape.family !== 2);

      const node = first.userData['step'] === undefined ? first.parent : first;
      expect(node?.userData).toMatchObject({
        step,
        epsilon: told.epsilon(step),
        family: ['witness', 'delaunay', 'surface'][shape.family],
        betti: shape.betti,
      });
      if (shape.family !== 2) return;
      // Outwards, as the sum over the triangles around a vertex says.
      const normals = rowsOf(first.geometry.getAttribute('normal').array, 3);
      const sums = positions.map(() => new Vector3());
      for (const corners of indices('triangles', 3)) {
        const [a, b, c] = corners.map((corner) => new Vector3(...(positions[corner] ?? [])));
        if (!a || !b || !c) throw new Error('a triangle has three corners');
        const area = b.sub(a).cross(c.sub(a));
        for (const corner of corners) sums[corner]?.add(area);
      }
      sums.forEach((sum, vertex) => {
        const normal = new Vector3(...(normals[vertex] ?? []));
        expect(normal.dot(sum.normalize())).toBeGreaterThan(0.9999);
      });
    }),
  );
});

const FOREVER = 0x7fffffff;

/** What holds of every file of a complex, whatever the points are. */
function expectComplex(bytes: Uint8Array, told: Told, step: number): ReturnType<typeof readVtk> {
  const vtk = readVtk(bytes);
  const shown = told.at(step);
  expect(vtk.title).toContain(`step ${step}, epsilon`);
  const column = (name: string): readonly number[] => vtk.cellData.get(name) ?? [];
  const [dimension, birth, death] = [column('dimension'), column('birth'), column('death')];
  const steps = Array.from({ length: step }, (_, i) => i + 1);
  expect(vtk.pointData.get('step')).toEqual(steps);
  expect(vtk.pointData.get('input_index')).toEqual(steps.map((s) => told.landmark(s)));
  expect(vtk.types).toEqual(dimension.map((dim) => [1, 3, 5, 10][dim]));
  const simplices = vtk.cells.map((cell) => cell.map((point) => point + 1).sort((a, b) => a - b));
  const deathOf = new Map(simplices.map((simplex, i) => [simplex.join(), death[i] ?? NaN]));
  expect(deathOf.size).toBe(simplices.length);
  const of = (dim: number): string[] =>
    simplices.filter((_, i) => dimension[i] === dim).map((simplex) => simplex.join());
  expect(of(0)).toEqual(steps.map(String));
  expect(of(1).sort()).toEqual(shown.edges);
  expect(of(2).sort()).toEqual(shown.triangles);
  simplices.forEach((simplex, i) => {
    expect(simplex.length).toBe((dimension[i] ?? NaN) + 1);
    expect(birth[i]).toBe(Math.max(...simplex));
    expect(death[i]).toBeGreaterThan(step);
    const known = shown.death.get(simplex.join());
    if (known !== undefined) expect(death[i]).toBe(Math.min(known, FOREVER));
    if (dimension[i] === 0) expect(death[i]).toBe(FOREVER);
    // With every simplex its faces, which outlive it.
    for (const left of simplex.length > 1 ? simplex : []) {
      const facet = simplex.filter((vertex) => vertex !== left).join();
      expect(deathOf.get(facet)).toBeGreaterThanOrEqual(death[i] ?? NaN);
    }
  });
  return vtk;
}

describe('VTK, read as its specification says', () => {
  test.each(cases)('$name', (one) =>
    each(one, (run, told, step) => {
      const vtk = expectComplex(bytesOf(run, 'complex-vtk', step), told, step);
      expect([...vtk.points]).toEqual(Array.from({ length: step }, (_, i) => told.position(i + 1)).flat());
      expect(vtk.pointData.size).toBe(2);
      const shown = told.at(step);
      // Tetrahedra are told by no delta; Betti numbers of the complex, where it is shown, count them.
      if (shown.family !== 1) return;
      const counts = [0, 1, 2, 3].map(
        (dim) => vtk.types.filter((type) => type === [1, 3, 5, 10][dim]).length,
      );
      const sum = (numbers: readonly number[]): number =>
        numbers.reduce((all, n, k) => all + (-1) ** k * n, 0);
      expect(sum(counts)).toBe(sum(shown.betti));
    }),
  );

  test('more coordinates: principal axes, and all of them as data', () => {
    const parts = [Math.SQRT2, Math.sqrt(3), Math.sqrt(5), Math.sqrt(7)];
    const points = Array.from({ length: 300 }, (_, i) => parts.map((part) => (i * part) % 1));
    const text = points.map((point) => point.join(' ')).join('\n');
    const run = new module.Run({ ...file('four.txt', text), anyDimension: true } as never, {
      maxDimension: 3,
    });
    const answer = opened(run);
    runThrough(run, Infinity);
    const told = new Told(run, answer);
    const vtk = expectComplex(bytesOf(run, 'complex-vtk', 40), told, 40);
    expect(Math.max(...vtk.types)).toBe(10);
    const landmarks = Array.from({ length: 40 }, (_, i) => told.landmark(i + 1));
    expect(vtk.pointData.get('coordinates')).toEqual(landmarks.flatMap((landmark) => points[landmark] ?? []));
    const { axes = 0, coordinates = new Float32Array() } = answer.projection ?? {};
    expect(axes).toBe(4);
    expect(rowsOf(vtk.points, 3)).toEqual(
      landmarks.map((landmark) => [...coordinates.subarray(landmark * axes, landmark * axes + 3)]),
    );
    run.delete();
  });

  test('distances alone: classical scaling, which is exact for points of the plane', () => {
    const points = Array.from({ length: 30 }, (_, i) => [(i * 7) % 12, ((i * 5) % 9) + i / 40]);
    const between = (a: number[], b: number[]): number => Math.hypot(...a.map((x, k) => x - (b[k] ?? NaN)));
    const text = points.map((a) => points.map((b) => between(a, b)).join()).join('\n');
    const run = new module.Run(file('matrix.csv', text), { metric: 'matrix' });
    const answer = opened(run);
    runThrough(run, Infinity);
    const told = new Told(run, answer);
    const vtk = expectComplex(bytesOf(run, 'complex-vtk', 30), told, 30);
    const drawn = rowsOf(vtk.points, 3);
    drawn.forEach((a, i) =>
      drawn.forEach((b, j) => {
        const [from = [], to = []] = [points[told.landmark(i + 1)], points[told.landmark(j + 1)]];
        expect(between(a, b)).toBeCloseTo(between(from, to), 4);
      }),
    );
    run.delete();
  });
});

test('before the first step every file is empty and well-formed', async () => {
  const run = new module.Run(sample('torus', 50), {});
  opened(run);
  await expectValid(bytesOf(run, 'mesh-glb'));
  expect(await loaded(bytesOf(run, 'mesh-glb'))).toEqual(new Map());
  expect(readVtk(bytesOf(run, 'complex-vtk')).cells).toEqual([]);
  expect(new PLYLoader().parse(bytesOf(run, 'mesh-ply').buffer).getAttribute('position').count).toBe(0);
  for (const format of [
    'mesh-ply',
    'mesh-off',
    'mesh-glb',
    'complex-vtk',
    'surface-report',
    'session',
  ] as const)
    expect(run.exportFile(format, 1), format).toHaveProperty(
      'failure.message',
      'Step 1 is not computed yet.',
    );
  run.delete();
});
