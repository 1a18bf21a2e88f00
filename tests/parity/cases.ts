import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { COMPUTED_SAMPLES } from '../../web/src/app/samples.ts';
import type { Family, RunOptions } from '../../web/src/worker/protocol.ts';
import { asText, bunnyPoints } from '../acceptance/bunny-cloud.mjs';

/** A run that native, Node and Chromium must agree on. */
export interface Case {
  readonly name: string;
  readonly family: Family;
  /** The points as a file; its ending says how to read it. */
  readonly fileName: string;
  readonly text: string;
  /** What else is asked for, of the command and of the module. */
  readonly words?: readonly string[];
  readonly options?: RunOptions;
  /** A table of more than three columns is taken as a whole, as the command does. */
  readonly anyDimension?: boolean;
  /** The same points as the module makes them itself. */
  readonly sample?: { readonly shape: string; readonly size: number };
}

/** `npm run test:full` takes the shapes at the sizes that the page opens them with. */
export const full = process.env['PLATEAU_FULL'] === '1';
const quickSize = 260;
const bunnySize = 20_000;
/** Family `witness` reduces a matrix at every step. */
const largestWitness = 1_500;

const command = fileURLToPath(new URL('../../build/native/bin/plateau', import.meta.url));
const data = new URL('../core/data/', import.meta.url);

/** What the command prints. */
export function plateau(words: readonly string[]): string {
  return execFileSync(command, words, { encoding: 'utf8', maxBuffer: 1 << 28, stdio: 'pipe' });
}

/** The hash that the command gives the case. */
export function commandHash({ fileName, text, family, words = [] }: Case): string {
  const file = join(mkdtempSync(join(tmpdir(), 'plateau-')), fileName);
  writeFileSync(file, text);
  const printed = plateau(['run', file, '--family', family, ...words, '--hash']);
  const hash = /^hash ([0-9a-f]{16})\n$/m.exec(printed)?.[1];
  if (hash === undefined) throw new Error(`The command printed no hash: ${printed}`);
  return hash;
}

export const title = ({ name, family }: Case): string => `${name}, ${family}`;

const inThePlane: readonly Family[] = ['delaunay', 'witness'];
const inSpace: readonly Family[] = ['auto', 'surface', 'delaunay', 'witness'];
const shapesOfThePlane = ['circle-noise', 'nested-circles', 'corner-curve'];
const sizeFor = (family: Family, size: number): number =>
  full ? Math.min(size, family === 'witness' ? largestWitness : Infinity) : quickSize;

/** Those with options of their own are manifolds that have cases of their own. */
function ofShapes(): Case[] {
  return COMPUTED_SAMPLES.filter(({ options }) => !options).flatMap(({ shape, size: usual }) =>
    (shapesOfThePlane.includes(shape) ? inThePlane : inSpace).map((family): Case => {
      const size = sizeFor(family, usual);
      const text = plateau(['sample', shape, '--n', String(size)]);
      return { name: shape, family, fileName: `${shape}.xyz`, text, sample: { shape, size } };
    }),
  );
}

function ofFiles(): Case[] {
  return readdirSync(data).flatMap((fileName) => {
    const text = readFileSync(new URL(fileName, data), 'utf8');
    return inSpace.map((family): Case => ({ name: fileName, family, fileName, text }));
  });
}

function ofBunny(): Case[] {
  return inSpace.map((family): Case => {
    const text = asText(bunnyPoints(sizeFor(family, bunnySize)));
    return { name: 'bunny', family, fileName: 'bunny.xyz', text };
  });
}

function grid(counts: readonly number[], spacing: number): string {
  const rows: string[] = [];
  const total = counts.reduce((a, b) => a * b, 1);
  for (let i = 0; i < total; ++i) {
    let rest = i;
    const row = counts.map((count) => {
      const at = rest % count;
      rest = Math.floor(rest / count);
      return String(at * spacing);
    });
    rows.push(row.join(' '));
  }
  return rows.join('\n') + '\n';
}

/** Clouds full of ties and of degenerate beginnings. */
function ofGrids(): Case[] {
  const grids: readonly (readonly [string, readonly number[], number])[] = [
    ['grid of tenths in the plane', [9, 8], 0.1],
    ['grid of tenths in space', [5, 4, 4], 0.1],
    ['plane in space', [6, 7, 1], 0.25],
    ['line in space', [12, 1, 1], 1e-9],
  ];
  return grids.flatMap(([name, counts, spacing]) =>
    (counts.length === 2 ? inThePlane : inSpace).map((family): Case => ({
      name,
      family,
      fileName: 'grid.xyz',
      text: grid(counts, spacing),
    })),
  );
}

/** Distances between the points of a grid, below the diagonal: full of ties, and roots that round. */
function gridMatrix(side: number): string {
  const at = (i: number): [number, number] => [Math.floor(i / side), i % side];
  const distance = (i: number, j: number): number => {
    const [[a, b], [c, d]] = [at(i), at(j)];
    return Math.sqrt((a - c) ** 2 + (b - d) ** 2);
  };
  const rows = Array.from({ length: side * side - 1 }, (_, i) =>
    Array.from({ length: i + 1 }, (_, j) => distance(i + 1, j)).join(),
  );
  return rows.join('\n') + '\n';
}

/** Every metric, and points of four coordinates with Betti numbers over Z/3. */
function ofMetrics(): Case[] {
  const sphere = plateau(['sample', 'sphere', '--n', '150']);
  const metrics: readonly RunOptions[] = [
    { metric: 'l1' },
    { metric: 'linf' },
    { metric: 'angular' },
    { metric: 'projective', field: 3 },
    { metric: 'periodic', box: [1.5, 2, 0] },
    { metric: 'geodesic', knn: 6 },
  ];
  const torus = plateau(['sample', 'torus', '--n', '120']).trimEnd().split('\n');
  const four = torus.map((line, i) => `${line} ${(i * i) % 17}`).join('\n');
  const asked = [
    ...metrics.map((options) => ({ fileName: 'sphere.xyz', text: sphere, options })),
    { fileName: 'grid.csv', text: gridMatrix(9), options: { metric: 'matrix' } as const },
    { fileName: 'four.txt', text: four, options: { maxDimension: 3, field: 3 }, anyDimension: true },
  ];
  return asked.map((one) => ({ ...one, ...worded(one.options), family: 'witness' }));
}

/** Options as the command takes them, and a name for them. */
function worded(options: RunOptions): { name: string; words: string[] } {
  const { metric, box, knn, maxDimension, field, maxSteps } = options;
  const { dilation, pump, omegaBar, zeta2, sliver } = options;
  const words = [
    ...(metric === undefined ? [] : ['--metric', metric]),
    ...(box === undefined ? [] : ['--box', box.join()]),
    ...(knn === undefined ? [] : ['--knn', String(knn)]),
    ...(maxDimension === undefined ? [] : ['--max-dim', String(maxDimension)]),
    ...(field === undefined ? [] : ['--field', String(field)]),
    ...(dilation === undefined ? [] : ['--dilation', String(dilation)]),
    ...(pump === true ? ['--pump'] : []),
    ...(omegaBar === undefined ? [] : ['--omega-bar', String(omegaBar)]),
    ...(zeta2 === undefined ? [] : ['--zeta2', String(zeta2)]),
    ...(sliver === undefined ? [] : ['--sliver', sliver]),
    ...(maxSteps === undefined ? [] : ['--steps', String(maxSteps)]),
  ];
  return { name: words.join(' '), words };
}

/** Family `dilated`: manifolds in more dimensions, a border, and ties that only the smallest weights break. */
function ofDilated(): Case[] {
  const shapes: readonly (readonly [string, RunOptions])[] = [
    ['clifford', {}],
    ['klein', { field: 3 }],
    ['s2xs1', { dilation: 0.4 }],
    ['mobius', {}],
    ['torus', { dilation: 0.3, pump: true }],
    ['s3', { maxSteps: 30, pump: true, omegaBar: 0.4, zeta2: 0.5, sliver: 'normalized' }],
  ];
  const sized = full ? 5_000 : 400;
  const sampled = shapes.map(([shape, options]) => ({
    shape,
    options: { maxSteps: full ? 200 : 90, ...options },
    text: plateau(['sample', shape, '--n', String(sized)]),
  }));
  const grids = [grid([9, 8], 0.1), grid([4, 4, 3], 0.1), grid([3, 3, 2, 2], 0.25)].map((text, i) => ({
    shape: `grid in R^${i + 2}`,
    options: { dilation: 0.5 },
    text,
  }));
  return [...sampled, ...grids].map(({ shape, options, text }): Case => {
    const { name, words } = worded(options);
    return {
      name: `${shape} ${name}`.trim(),
      family: 'dilated',
      fileName: 'points.txt',
      text,
      words,
      options,
      anyDimension: true,
    };
  });
}

/** Every shape and data file, the bunny, and grids, each with all families of its dimension; every metric; `dilated`. */
export function cases(): Case[] {
  return [...ofShapes(), ...ofFiles(), ...ofBunny(), ...ofGrids(), ...ofMetrics(), ...ofDilated()];
}
