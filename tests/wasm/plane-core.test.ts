// What a sketch is told, through client and worker, against the definitions; of small scenes, many of them with ties.
import { readFileSync } from 'node:fs';
import { beforeAll, expect, test } from 'vitest';
import { PlateauClient } from '../../web/src/client/plateau-client.ts';
import { InProcessWorker } from '../../web/src/package/in-process.ts';
import { ClientPlaneCore } from '../../web/src/sketch/client-plane-core.ts';
import type { PlaneQuestion } from '../../web/src/sketch/plane.ts';
import { samePlace, type Point } from '../../web/src/sketch/points.ts';

let core: ClientPlaneCore;
beforeAll(() => {
  const wasm = readFileSync(new URL('../../build/wasm/bin/plateau.wasm', import.meta.url));
  core = new ClientPlaneCore(new PlateauClient({ spawn: () => new InProcessWorker(wasm, setImmediate) }));
});

/** Whole numbers from a fixed sequence; few of them, so that distances are often equal. */
function scene(seed: number, largest: number): { landmarks: Point[]; witnesses: Point[] } {
  let state = seed;
  const next = (): number => {
    state = (state * 1103515245 + 12345) % 2147483648;
    return Math.floor((state / 2147483648) * (largest + 1));
  };
  const points = (count: number): Point[] => {
    const found: Point[] = [];
    while (found.length < count) {
      const point = { x: next(), y: next() };
      if (!found.some((other) => samePlace(other, point))) found.push(point);
    }
    return found;
  };
  return { landmarks: points(6), witnesses: points(14) };
}

const squared = (a: Point, b: Point): number => (a.x - b.x) ** 2 + (a.y - b.y) ** 2;

/** The nearest landmarks of a witness, the earlier one first where distances are equal. */
function nearest({ landmarks }: PlaneQuestion, witness: Point): number[] {
  return landmarks
    .map((landmark, index) => ({ index, far: squared(landmark, witness) }))
    .sort((a, b) => a.far - b.far || a.index - b.index)
    .map(({ index }) => index);
}

function witnessesOf(question: PlaneQuestion, simplex: readonly number[]): number[] {
  const allowed = question.nu[simplex.length - 1] ?? 0;
  return question.witnesses.flatMap((witness, w) => {
    const first = nearest(question, witness).slice(0, allowed);
    return simplex.every((vertex) => first.includes(vertex)) ? [w] : [];
  });
}

const faces = (simplex: readonly number[]): number[][] =>
  simplex.length === 1 ? [] : simplex.map((_, i) => simplex.filter((__, k) => k !== i));

function inWhole(question: PlaneQuestion, simplex: readonly number[]): boolean {
  return witnessesOf(question, simplex).length > 0 && faces(simplex).every((face) => inWhole(question, face));
}

const SIMPLICES: number[][] = [];
for (let a = 0; a < 6; ++a) {
  SIMPLICES.push([a]);
  for (let b = a + 1; b < 6; ++b) {
    SIMPLICES.push([a, b]);
    for (let c = b + 1; c < 6; ++c) SIMPLICES.push([a, b, c]);
  }
}

test.each([
  [[1, 2, 3], 80],
  [[1, 2, 3], 5],
  [[1, 3, 3], 7],
  [[1, 4, 5], 40],
])('lists, complex, witnesses and reasons: ν = %o on a board of %i', async (nu, largest) => {
  for (let seed = 1; seed <= 8; ++seed) {
    const whole: PlaneQuestion = { ...scene(seed, largest), nu, delaunay: false };
    for (const question of [whole, { ...whole, delaunay: true }]) {
      const picture = await core.picture(question);
      expect(picture.lists).toEqual(
        question.witnesses.map((witness) => nearest(question, witness).slice(0, Math.max(3, ...nu))),
      );
      const triangulation = [...picture.delaunayEdges, ...picture.delaunayTriangles].map(String);
      const known = [...picture.vertices, ...picture.edges, ...picture.triangles];
      const expected = SIMPLICES.filter(
        (simplex) =>
          inWhole(question, simplex) &&
          (!question.delaunay || simplex.length === 1 || triangulation.includes(String(simplex))),
      );
      expect(known.map(({ vertices }) => String(vertices)).sort()).toEqual(expected.map(String).sort());
      for (const { vertices, witnesses } of known)
        expect(witnesses, String(vertices)).toEqual(witnessesOf(question, vertices));

      const names = new Set(expected.map(String));
      for (const simplex of SIMPLICES.filter((_, i) => i % 3 === seed % 3)) {
        const reason = await core.why(question, simplex);
        expect(reason.kind === 'present', String(simplex)).toBe(names.has(String(simplex)));
        if (reason.kind === 'present') expect(reason.witnesses).toEqual(witnessesOf(question, simplex));
        if (reason.kind === 'missing-face') expect(names.has(String(reason.face))).toBe(false);
        if (reason.kind === 'not-delaunay') expect(reason.inside.length).toBeGreaterThan(0);
        if (reason.kind === 'no-witness' && reason.closest !== undefined) {
          const list = nearest(question, question.witnesses[reason.closest] ?? { x: 0, y: 0 });
          expect(Math.max(...simplex.map((vertex) => list.indexOf(vertex) + 1))).toBe(reason.rank);
          expect(reason.rank).toBeGreaterThan(reason.needed);
        }
      }
    }
  }
});

test('cells cover the board, each of order two between the ends of its edge', async () => {
  const area = (corners: readonly Point[]): number =>
    corners.reduce((sum, a, i) => {
      const b = corners[(i + 1) % corners.length] ?? a;
      return sum + (a.x * b.y - b.x * a.y) / 2;
    }, 0);
  const question: PlaneQuestion = { ...scene(3, 80), nu: [1, 2, 3], delaunay: true };
  const { cells, pairCells, delaunayEdges } = await core.picture(question);
  expect(pairCells.map(({ of }) => of)).toEqual(delaunayEdges);
  for (const parts of [cells, pairCells])
    expect(parts.reduce((sum, { corners }) => sum + area(corners), 0)).toBeCloseTo(140 * 100, 6);
  for (const { of, corners } of pairCells.filter((cell) => area(cell.corners) > 1)) {
    const middle = {
      x: corners.reduce((sum, { x }) => sum + x, 0) / corners.length,
      y: corners.reduce((sum, { y }) => sum + y, 0) / corners.length,
    };
    expect(nearest(question, middle).slice(0, 2).sort()).toEqual(of);
  }
});

test('the order is farthest first, and ε how far the loneliest witness is', async () => {
  const { witnesses } = scene(5, 60);
  const { order, epsilon } = await core.farthest(witnesses);
  expect([...order].sort((a, b) => a - b)).toEqual(witnesses.map((_, i) => i));
  const distance = (w: Point, taken: readonly number[]): number =>
    Math.min(...taken.map((i) => squared(w, witnesses[i] ?? w)));
  order.forEach((chosen, i) => {
    if (i === 0) return;
    const far = witnesses.map((witness) => distance(witness, order.slice(0, i)));
    expect(far.indexOf(Math.max(...far))).toBe(chosen);
    expect(epsilon[i - 1]).toBeCloseTo(Math.sqrt(Math.max(...far)), 12);
  });
});
