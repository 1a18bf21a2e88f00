// Runs of family dilated by the command, for the measurements behind docs/dilated.md.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const command = fileURLToPath(new URL('../../build/native/bin/plateau', import.meta.url));
const plateau = (words, input) =>
  execFileSync(command, words, { input, maxBuffer: 2 ** 30, stdio: ['pipe', 'pipe', 'ignore'] });

/** Points of a built-in shape as text. */
export const sample = (shape, n, seed) =>
  plateau(['sample', shape, '--n', String(n), '--seed', String(seed)]);

/** Rows of numbers as text. */
export const asText = (rows) => rows.map((row) => row.join(' ')).join('\n') + '\n';

const words = (steps, extra) => ['run', '-', '--family', 'dilated', '--steps', String(steps), ...extra];

function rowsOf(csv) {
  const [names, ...rows] = csv
    .trim()
    .split('\n')
    .map((line) => line.split(','));
  return rows.map((row) => Object.fromEntries(row.map((text, k) => [names[k], text])));
}

/** A run of the first landmarks: its Betti numbers at each step, joined by commas; its plateaus; its pumps if it has any. */
export function runOf(cloud, steps, extra) {
  const folder = mkdtempSync(join(tmpdir(), 'plateau-'));
  const file = (name) => join(folder, name);
  const isPumped = extra.includes('--pump');
  const outputs = ['--betti', file('betti'), '--plateaus', file('plateaus')];
  if (isPumped) outputs.push('--pumps', file('pumps'));
  try {
    plateau([...words(steps, extra), ...outputs], cloud);
    const read = (name) => readFileSync(file(name), 'utf8');
    return {
      betti: rowsOf(read('betti')).map((row) => Object.values(row).slice(4).join()),
      plateaus: JSON.parse(read('plateaus')).plateaus,
      pumps: isPumped ? rowsOf(read('pumps')) : [],
    };
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** Processor seconds of a run of the first landmarks, reading included: on a busy machine the clock says little. */
export function secondsOf(cloud, steps, extra) {
  const script = '"$@" > /dev/null 2>&1; times';
  const report = execFileSync('sh', ['-c', script, 'sh', command, ...words(steps, extra)], { input: cloud });
  // The second line is about the children: user and system time as minutes and seconds.
  const [, children] = report.toString().trim().split('\n');
  return [...children.matchAll(/(\d+)m([\d.]+)s/g)].reduce(
    (sum, [, m, s]) => sum + 60 * Number(m) + Number(s),
    0,
  );
}

/** Numbers from 0 to 1, the same ones for a seed on every machine (mulberry32). */
export function randomOf(seed) {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let mixed = Math.imul(state ^ (state >>> 15), state | 1);
    mixed ^= mixed + Math.imul(mixed ^ (mixed >>> 7), mixed | 61);
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32;
  };
}

/** A row of a table in Markdown. */
export const row = (cells) => `| ${cells.join(' | ')} |`;
