// What pumping changes: Betti numbers at every step and longest plateaus, without weights and pumped.
// node tests/bench/pumping.mjs [SEEDS [CLOUD]]      how many (20); of those whose name holds the word (all)
import { asText, randomOf, row, runOf, sample } from './dilated-runs.mjs';

const SEEDS = Number(process.argv[2] ?? 20);
const JITTER = 1e-3;
const point = (radius, angle) => [radius * Math.cos(angle), radius * Math.sin(angle)];

/** Rectangles of a grid on S x S: four landmarks of each lie on a circle, but for the jitter. */
function clifford(seed) {
  const random = randomOf(seed);
  const angle = (k, count) => (2 * Math.PI * (k + JITTER * random())) / count;
  const side = 60;
  return asText(
    Array.from({ length: side * side }, (_, k) => [
      ...point(1, angle(k % side, side)),
      ...point(1, angle(Math.floor(k / side), side)),
    ]),
  );
}

/** A grid on the tori that fill the 3-sphere: simplices with three dimensions, of landmarks near one plane. */
function sphere(seed) {
  const random = randomOf(seed);
  const jittered = (k) => k + JITTER * random();
  const [layers, side] = [12, 24];
  const rows = [];
  for (let layer = 0; layer < layers; ++layer) {
    for (let k = 0; k < side * side; ++k) {
      const height = (Math.PI / 2) * ((jittered(layer) + 0.5) / layers);
      const [a, b] = [k % side, Math.floor(k / side)].map((at) => (2 * Math.PI * jittered(at)) / side);
      rows.push([...point(Math.cos(height), a), ...point(Math.sin(height), b)]);
    }
  }
  return asText(rows);
}

const clouds = [
  {
    name: 'Klein bottle, 6,000 points',
    of: (seed) => sample('klein', 6000, seed),
    steps: 150,
    right: '1,2,1,0',
  },
  { name: 'Clifford torus, jittered grid of 3,600', of: clifford, steps: 150, right: '1,2,1,0' },
  { name: '3-sphere, 5,000 points', of: (seed) => sample('s3', 5000, seed), steps: 70, right: '1,0,0,1' },
  { name: '3-sphere, jittered grid of 6,912', of: sphere, steps: 70, right: '1,0,0,1' },
];

/** Of the plateaus but for the first three landmarks, which span no shape. */
function isLongestRight(plateaus, right) {
  const later = plateaus.filter(({ first_step }) => first_step > 3).sort((a, b) => b.length - a.length);
  return later[0]?.betti.join() === right;
}

const columns = [
  'Cloud',
  'landmarks pumped',
  'steps right without weights',
  'became right',
  'became wrong',
  'of steps',
  'clouds with the right longest plateau, without weights',
  'pumped',
  'right only when pumped',
];
console.log(row(columns));
console.log(row(columns.map(() => '---')));
for (const { name, of, steps, right } of clouds) {
  if (!name.includes(process.argv[3] ?? '')) continue;
  const sums = { pumped: 0, right: 0, gained: 0, lost: 0, plain: 0, weighted: 0, saved: 0 };
  for (let seed = 1; seed <= SEEDS; ++seed) {
    const cloud = of(seed);
    const [without, pumped] = [[], ['--pump']].map((extra) =>
      runOf(cloud, steps, ['--columns', '1,2,3,4', ...extra]),
    );
    const [before, after] = [without, pumped].map(({ betti }) => betti.map((numbers) => numbers === right));
    const [plain, weighted] = [without, pumped].map(({ plateaus }) => isLongestRight(plateaus, right));
    sums.pumped += pumped.pumps.filter(({ omega }) => Number(omega) > 0).length;
    sums.right += before.filter(Boolean).length;
    sums.gained += after.filter((is, k) => is && !before[k]).length;
    sums.lost += after.filter((is, k) => !is && before[k]).length;
    sums.plain += plain;
    sums.weighted += weighted;
    sums.saved += weighted && !plain;
  }
  const { pumped, right: atFirst, gained, lost, plain, weighted, saved } = sums;
  const cells = [pumped, atFirst, gained, lost, steps * SEEDS, plain, weighted, saved];
  console.log(row([name, ...cells.map((cell) => cell.toLocaleString('en-US'))]));
}
