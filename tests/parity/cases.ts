import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { COMPUTED_SAMPLES } from '../../web/src/app/samples.ts';
import type { Family } from '../../web/src/worker/protocol.ts';
import { asText, bunnyPoints } from '../acceptance/bunny-cloud.mjs';

/** A run that native, Node and Chromium must agree on. */
export interface Case {
  readonly name: string;
  readonly family: Family;
  /** The points as a file; its ending says how to read it. */
  readonly fileName: string;
  readonly text: string;
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
export function commandHash({ fileName, text, family }: Case): string {
  const file = join(mkdtempSync(join(tmpdir(), 'plateau-')), fileName);
  writeFileSync(file, text);
  const printed = plateau(['run', file, '--family', family, '--hash']);
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

function ofShapes(): Case[] {
  return COMPUTED_SAMPLES.flatMap(({ shape, size: usual }) =>
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

/** Every shape and data file, the bunny, and grids, each with all families of its dimension. */
export function cases(): Case[] {
  return [...ofShapes(), ...ofFiles(), ...ofBunny(), ...ofGrids()];
}
