import { execFileSync } from 'node:child_process';
import { readFileSync, readdirSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { SAMPLES } from '../../web/src/app/samples.ts';
import type { Family } from '../../web/src/worker/protocol.ts';

const command = fileURLToPath(new URL('../../build/native/bin/plateau', import.meta.url));
const data = new URL('../core/data/', import.meta.url);

/** What the command prints. */
export function plateau(words: readonly string[], input: string | Buffer = ''): string {
  return execFileSync(command, words, { input, encoding: 'utf8', maxBuffer: 1 << 28 });
}

/** The hash that the command gives a cloud. */
export function commandHash(text: string, family: Family): string {
  const printed = plateau(['run', '-', '--family', family, '--hash'], text).trimEnd();
  const [, hash = ''] = /^hash ([0-9a-f]{16})$/m.exec(printed) ?? [];
  return hash;
}

export interface Cloud {
  readonly name: string;
  readonly text: string;
  readonly dimension: 2 | 3;
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

/** Every shape with few points, every data file, and clouds full of ties and degenerate beginnings. */
export function clouds(): Cloud[] {
  const shapes = SAMPLES.map(({ shape }): Cloud => {
    const text = plateau(['sample', shape, '--n', '260']);
    return {
      name: shape,
      text,
      dimension: (text.split('\n')[0] ?? '').trim().split(/\s+/).length === 2 ? 2 : 3,
    };
  });
  const files = readdirSync(data)
    .filter((name) => /\.(xyz|csv|txt)$/.test(name))
    .map((name): Cloud => ({ name, text: readFileSync(new URL(name, data), 'utf8'), dimension: 3 }));
  return [
    ...shapes,
    ...files,
    { name: 'grid of tenths in the plane', text: grid([9, 8], 0.1), dimension: 2 },
    { name: 'grid of tenths in space', text: grid([5, 4, 4], 0.1), dimension: 3 },
    { name: 'plane in space', text: grid([6, 7, 1], 0.25), dimension: 3 },
    { name: 'line in space', text: grid([12, 1, 1], 1e-9), dimension: 3 },
  ];
}

export function familiesFor({ dimension }: Cloud): readonly Family[] {
  return dimension === 2 ? ['delaunay', 'witness'] : ['auto', 'surface', 'delaunay', 'witness'];
}
