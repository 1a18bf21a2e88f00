// Runs of family dilated by the command, for the measurements behind docs/dilated.md.
import { execFileSync } from 'node:child_process';
import { fileURLToPath } from 'node:url';

const command = fileURLToPath(new URL('../../build/native/bin/plateau', import.meta.url));
const plateau = (words, input) =>
  execFileSync(command, words, { input, maxBuffer: 2 ** 30, stdio: ['pipe', 'pipe', 'ignore'] });

/** Points of a built-in shape as text. */
export const sample = (shape, n, seed) =>
  plateau(['sample', shape, '--n', String(n), '--seed', String(seed)]);

/** Rows of numbers as text. */
export const asText = (rows) => rows.map((row) => row.join(' ')).join('\n') + '\n';

function words(steps, extra) {
  return ['run', '-', '--family', 'dilated', '--steps', String(steps), ...extra];
}

/** The plateaus of the first landmarks, in the order of their steps. */
export function plateausOf(cloud, steps, extra) {
  return JSON.parse(plateau([...words(steps, extra), '--plateaus', '-'], cloud)).plateaus;
}

/** What is right at each step: its Betti numbers, joined by commas. */
export function bettiOf(cloud, steps, extra) {
  const lines = plateau([...words(steps, extra), '--betti', '-'], cloud).toString().trim().split('\n');
  return lines.slice(1).map((line) => line.split(',').slice(4).join());
}

/** Processor seconds of a run of the first landmarks, reading included: on a busy machine the clock says little. */
export function secondsOf(cloud, steps, extra) {
  const script = '"$@" > /dev/null 2>&1; times';
  const report = execFileSync('sh', ['-c', script, 'sh', command, ...words(steps, extra)], { input: cloud });
  // The second line is about the children: user and system time as minutes and seconds.
  const [, children] = report.toString().trim().split('\n');
  return [...children.matchAll(/(\d+)m([\d.]+)s/g)].reduce((sum, [, m, s]) => sum + 60 * Number(m) + Number(s), 0);
}

/** Weight, sliver measures and amplitude of each landmark, by the names of the columns. */
export function pumpsOf(cloud, steps, extra) {
  const lines = plateau([...words(steps, extra), '--pump', '--pumps', '-'], cloud)
    .toString()
    .trim()
    .split('\n');
  const names = lines[0].split(',');
  return lines
    .slice(1)
    .map((line) => Object.fromEntries(line.split(',').map((text, k) => [names[k], Number(text)])));
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
