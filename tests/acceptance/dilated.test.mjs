// What family dilated shows at dilation 0.2: manifolds in R^3, R^4 and R^5, surfaces with a border, two scales in one cloud.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { asText, bunnyPoints } from './bunny-cloud.mjs';

const command = fileURLToPath(new URL('../../build/native/bin/plateau', import.meta.url));
const plateau = (words, input) =>
  execFileSync(command, words, { input, maxBuffer: 1 << 30, stdio: ['pipe', 'pipe', 'ignore'] });

/** Plateaus of the first landmarks of a cloud, longest first. */
function plateausOf(cloud, steps, extra = []) {
  const words = ['run', '-', '--family', 'dilated', '--steps', String(steps), '--plateaus', '-', ...extra];
  return [...JSON.parse(plateau(words, cloud)).plateaus].sort((a, b) => b.length - a.length);
}
const sample = (shape, n) => plateau(['sample', shape, '--n', String(n)]);
const inFour = ['--columns', '1,2,3,4'];

const cases = [
  { shape: 'torus', n: 20_000, steps: 300, betti: [1, 2, 1] },
  { shape: 'disk', n: 15_000, steps: 800, betti: [1, 0, 0], over: 1 },
  { shape: 'hemisphere', n: 15_000, steps: 800, betti: [1, 0, 0], over: 1 },
  { shape: 'mobius', n: 15_000, steps: 800, betti: [1, 1, 0], over: 1 },
  { shape: 'annulus', n: 15_000, steps: 800, betti: [1, 1, 0], over: 1 },
  { shape: 'clifford', n: 20_000, steps: 300, betti: [1, 2, 1, 0], extra: inFour },
  { shape: 'klein', n: 20_000, steps: 300, betti: [1, 2, 1, 0], extra: inFour },
  { shape: 'klein', n: 20_000, steps: 300, betti: [1, 1, 0, 0], extra: [...inFour, '--field', '3'] },
  { shape: 's3', n: 20_000, steps: 160, betti: [1, 0, 0, 1], extra: inFour },
  { shape: 'rp2', n: 20_000, steps: 300, betti: [1, 1, 1, 0], extra: inFour },
  { shape: 'rp2', n: 20_000, steps: 300, betti: [1, 0, 0, 0], extra: [...inFour, '--field', '3'] },
  { shape: 's2xs1', n: 30_000, steps: 400, betti: [1, 1, 1, 1, 0], extra: ['--columns', '1,2,3,4,5'] },
];

for (const { shape, n, steps, betti, over = 0, extra = [] } of cases) {
  test(`${shape}, n = ${n}: (${betti.join(', ')}) ${extra.join(' ')}`, () => {
    const [longest] = plateausOf(sample(shape, n), steps, extra);
    assert.deepEqual(longest.betti, betti);
    assert.ok(longest.length > over, `length ${longest.length}`);
  });
}

test('two scales in R^4, n = 20,000: a circle, then a torus', () => {
  const found = plateausOf(sample('two-scales', 20_000), 700, inFour).filter(
    ({ betti }) => betti.join() !== '1,0,0,0',
  );
  const [coarse, fine] = found.slice(0, 2).sort((a, b) => a.first_step - b.first_step);
  assert.deepEqual(coarse.betti, [1, 1, 0, 0]);
  assert.deepEqual(fine.betti, [1, 2, 1, 0]);
});

test('the left half of the bunny, n = 15,000: a bowl', () => {
  const rows = asText(bunnyPoints(30_000)).trim().split('\n');
  const x = rows.map((row) => Number(row.split(' ')[0])).sort((a, b) => a - b);
  const half = rows.filter((row) => Number(row.split(' ')[0]) < x[x.length >> 1]);
  const [longest] = plateausOf(half.join('\n') + '\n', 300);
  assert.deepEqual(longest.betti, [1, 0, 0]);
});
