// Processor time of runs of family dilated, beside what they should take at most. Nothing asserts a time.
// node tests/bench/dilated-times.mjs [ROUNDS]      the median of so many runs (3)
import { row, sample, secondsOf } from './dilated-runs.mjs';

const ROUNDS = Number(process.argv[2] ?? 3);
const runs = [
  { shape: 'torus', points: 20_000, landmarks: 300, extra: [], reach: 2 },
  { shape: 'torus', points: 20_000, landmarks: 300, extra: ['--pump'], reach: 10 },
  { shape: 'torus', points: 50_000, landmarks: 2_000, extra: [], reach: 20 },
  { shape: 'clifford', points: 20_000, landmarks: 300, extra: [], reach: 8 },
  { shape: 'clifford', points: 20_000, landmarks: 300, extra: ['--pump'], reach: 40 },
];

const columns = ['Run', 'points', 'landmarks', 'processor time', 'at most'];
console.log(row(columns));
console.log(row(columns.map(() => '---')));
for (const { shape, points, landmarks, extra, reach } of runs) {
  const inFour = shape === 'clifford' ? ['--columns', '1,2,3,4'] : [];
  const cloud = sample(shape, points, 1);
  const seconds = Array.from({ length: ROUNDS }, () =>
    secondsOf(cloud, landmarks, [...inFour, ...extra]),
  ).sort((a, b) => a - b);
  const median = seconds[seconds.length >> 1].toPrecision(2);
  const name = `${shape}${extra.length > 0 ? ', pumped' : ''}`;
  const counts = [points, landmarks].map((count) => count.toLocaleString('en-US'));
  console.log(row([name, ...counts, `${median} s`, `${reach} s`]));
}
