// What the benchmark writes: judged by numbers that are made up here, and the docs by their own file of results.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { growthChart } from '../bench/chart.mjs';
import { groupsOf, rebuildsOf } from '../bench/plan.mjs';
import { report, withReport } from '../bench/report.mjs';
import { fromCsv, rowOf, toCsv } from '../bench/results.mjs';

const docs = (name) => readFileSync(new URL(`../../docs/${name}`, import.meta.url), 'utf8');
const sizes = [1_000, 10_000, 100_000, 1_000_000];

/** Every row of the plan: T_D takes a microsecond a point, the rest `factor` times that. */
function madeUp(factor) {
  const rows = groupsOf(sizes)
    .flat()
    .map((row) => ({
      ...row,
      seconds: (row.points / 1e6) * (row.what === 'T_D' ? 1 : factor),
      megabytes: row.points / 1000,
      rounds: 3,
      share: 0.99,
      remark: '',
    }));
  for (const row of rebuildsOf(sizes)) {
    const common = { ...row, megabytes: undefined, rounds: 1, share: undefined, remark: '' };
    rows.push({ ...common, seconds: 4_000 }, { ...common, runner: 'beside rebuild', seconds: factor });
  }
  return { machine: 'a machine', rows };
}

test('results come back from their file as they were', () => {
  const results = madeUp(1.25);
  const given = rowOf(results.rows, 'native', 'torus', 1_000_000, 'witness');
  Object.assign(given, { seconds: undefined, megabytes: undefined, rounds: 0, remark: 'over 900 s' });
  assert.deepEqual(fromCsv(toCsv(results)), results);
});

test('what reaches everything misses nothing', () => {
  const text = report(madeUp(1.25));
  assert.match(text, /What misses its reach, and why\n\nNothing of what was measured\.$/);
  assert.match(
    text,
    /torus \| 10,000 +\| whole run, delaunay +\| 12\.5 ms +\| 1\.25 +\| 10 MB +\| ≤ 1\.8 T_D, then 1\.3 T_D +\| yes, both/,
  );
  assert.match(text, /torus witness +\| 10,000 +\| 4,000 s +\| 1\.25 s +\| 3,200 ×/);
});

test('a miss is named with its number, its limit and its reason, a row without a number with its remark', () => {
  const results = madeUp(2);
  Object.assign(rowOf(results.rows, 'native', 'torus', 1_000_000, 'witness'), {
    seconds: undefined,
    megabytes: undefined,
    remark: 'over 900 s',
  });
  const text = report(results);
  assert.match(
    text,
    /^D\(L\) with its plain mirror.*\n\n- torus delaunay, 10,000 points: 2 T_D instead of ≤ 1\.8 T_D$/m,
  );
  assert.match(text, /^- rebuild, torus witness: 2,000 × instead of ≥ 3,000 ×$/m);
  assert.match(text, /^- torus witness, 1,000,000 points, ≤ 60 s \(over 900 s\)$/m);
  // The cube has more room.
  assert.doesNotMatch(text, /cube delaunay.* instead/);
});

test('a busy machine is called one', () => {
  const results = madeUp(1.25);
  assert.match(report(results), /at least 99 % of the time/);
  results.rows[7].share = 0.51;
  assert.match(report(results), /The machine was busy:.* only 51 %/);
  for (const row of results.rows) row.share = undefined;
  assert.match(report(results), /was not counted/);
});

test('growth is told where both sizes were measured', () => {
  const results = madeUp(1.25);
  rowOf(results.rows, 'native', 'cube', 100_000, 'auto').seconds *= 2;
  const text = report(results);
  assert.match(text, /\| cube auto +\| 1\.25 +\| 2\.5 +\| 2 +\| ≤ 1\.05 \| \*\*no\*\*/);
  const few = { ...results, rows: results.rows.filter(({ points }) => points <= 10_000) };
  assert.doesNotMatch(report(few), /Growth of/);
});

test('the chart has a point for every measured size and none for one that was given up', () => {
  const results = madeUp(2);
  const diamonds = () => growthChart(results).match(/<path d="M[^"]*z"/g).length;
  // One in the legend; a panel each for time, ratio and memory.
  assert.equal(diamonds(), 1 + 3 * sizes.length);
  Object.assign(rowOf(results.rows, 'native', 'torus', 1_000_000, 'witness'), {
    seconds: undefined,
    megabytes: undefined,
  });
  assert.equal(diamonds(), 1 + 3 * (sizes.length - 1));
  assert.doesNotMatch(growthChart(results), /NaN|undefined|Infinity/);
});

test('the page about speed and its picture are what their file of results says', () => {
  const results = fromCsv(docs('growth.csv'));
  assert.equal(docs('speed.md'), withReport(docs('speed.md'), report(results)));
  assert.equal(docs('growth.svg'), growthChart(results));
  assert.throws(() => withReport('no markers', 'text'), /markers/);
});
