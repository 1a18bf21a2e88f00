// How dense a sample the theory's dilation, 0.0368, asks for: tori in space, weights 0, the first 400 landmarks.
// node tests/bench/theory.mjs [SIZES [SEEDS]]      both between commas
// Each cell: length of the longest plateau (1, 2, 1) / of the longest other one / of the longest other one that begins
// at a step after 3: fewer landmarks span no tetrahedron, and say nothing about a surface.
import { row, runOf, sample } from './dilated-runs.mjs';

const DILATION = '0.036756427623585226';
const STEPS = 400;
const numbers = (text) => text.split(',').map(Number);
const sizes = numbers(
  process.argv[2] ?? '2000,5000,8000,10000,11000,12000,15000,20000,35000,60000,120000,240000,250000,300000',
);
const seeds = numbers(process.argv[3] ?? '1,2,3');

const isRight = ({ betti }) => betti.join() === '1,2,1';
const longest = (plateaus) => plateaus.reduce((most, { length }) => Math.max(most, length), 0);

console.log(row(['Points', ...seeds.map((seed) => `seed ${seed}`)]));
console.log(row(['---', ...seeds.map(() => '---')]));
for (const size of sizes) {
  const cells = seeds.map((seed) => {
    const { plateaus } = runOf(sample('torus', size, seed), STEPS, ['--dilation', DILATION]);
    const others = plateaus.filter((plateau) => !isRight(plateau));
    const later = others.filter((plateau) => plateau.first_step > 3);
    return [plateaus.filter(isRight), others, later].map((some) => longest(some).toFixed(3)).join(' / ');
  });
  console.log(row([size.toLocaleString('en-US'), ...cells]));
}
