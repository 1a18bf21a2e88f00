import { describe, expect, test } from 'vitest';
import { fragmentOf, linkedIn, type Linked } from '../../../web/src/model/link.ts';
import { packed, unpacked } from '../../../web/src/model/packed-points.ts';
import { commandWords } from '../../../web/src/model/run-words.ts';
import type { RunOptions } from '../../../web/src/worker/protocol.ts';

const OPTIONS: RunOptions = {
  family: 'dilated',
  nu: [1, 6, 6, 4],
  first: 3,
  maxSteps: 400,
  untilEpsilon: 0.25,
  rho: 1.038,
  metric: 'periodic',
  knn: 9,
  box: [1, 0.5],
  maxDimension: 3,
  field: 3,
  dilation: 0.3,
  pump: true,
  omegaBar: 0.125,
  zeta2: 0.5,
  sliver: 'normalized',
  minLength: 0.75,
};

test('a link holds the recipe, all options, the step and the view', () => {
  const linked: Linked = {
    source: { kind: 'sample', shape: 'torus', size: 5000, noise: 0.01 },
    options: OPTIONS,
    step: 312,
    reached: 480,
    view: { axis: 'linear', pose: [1, -2, 3.25, 0, 0, 0.5] },
  };
  expect(linkedIn(`#${fragmentOf(linked)}`)).toEqual(linked);
  const plain: Linked = {
    source: { kind: 'points', points: '2.-3.0.0.AA-_', name: 'my, points & more' },
    options: {},
    step: 0,
    reached: 0,
    view: { axis: 'log' },
  };
  expect(linkedIn(fragmentOf(plain))).toEqual(plain);
  // Cut off, it lacks its points.
  expect(fragmentOf(plain)).toMatch(/&points=[^&]*$/);
});

test('every option has its word in the command', () => {
  const words = commandWords(OPTIONS);
  expect(words).toContain('--nu 1,6,6,4');
  expect(words).toContain('--pump --omega-bar 0.125');
  expect(words.match(/--/g)).toHaveLength(Object.keys(OPTIONS).length);
  expect(commandWords({ pump: false })).toBe('');
});

test.each([
  ['', undefined],
  ['#elsewhere', undefined],
  ['#v=2&shape=torus', /another version/],
  ['#v=1', /cut off/],
  ['#v=1&shape=torus&n=5.5', /n=5.5/],
  ['#v=1&shape=torus&n=5&step=-1', /step=-1/],
  ['#v=1&shape=torus&n=5&reached=x', /reached=x/],
  ['#v=1&shape=torus&n=5&nu=1,x', /nu=1,x/],
  ['#v=1&shape=torus&n=5&family=<b>', /family=/],
  ['#v=1&shape=torus&n=5&pump=yes', /pump=yes/],
])('what a fragment may say: %s', (fragment, fault) => {
  if (fault) expect(() => linkedIn(fragment)).toThrow(fault);
  else expect(linkedIn(fragment)).toBeUndefined();
});

function pointsIn(table: string): number[] {
  return table.trimEnd().split('\n').join(',').split(',').map(Number);
}

test.each([
  [2, 1, 0],
  [3, 1e-9, 1],
  [3, 1e9, -5e9],
  [5, 3.7, 0.1],
])(
  'points of %d dimensions, spread %d around %d, are rounded to 16 bits and no more',
  async (d, spread, at) => {
    let seed = 11;
    const unit = (): number => (seed = (seed * 16807) % 2147483647) / 2147483647;
    const points = Float64Array.from({ length: 200 * d }, () => at + spread * unit());
    const all = await packed(points, d);
    if (!all) throw new Error('not packed');
    expect(all.text).toMatch(/^[-\w.]+$/);
    const { table, dimension } = await unpacked(all.text);
    expect(dimension).toBe(d);
    const read = Float64Array.from(pointsIn(table));
    expect(read).toHaveLength(points.length);
    read.forEach((value, i) =>
      expect(Math.abs(value - (points[i] ?? NaN))).toBeLessThanOrEqual(all.unit / 2),
    );
    expect(all.unit).toBeLessThanOrEqual((2 * spread) / 65_000);
    // What is on the grid stays there: a link of what a link gave is the same.
    expect((await packed(read, d))?.text).toBe(all.text);
  },
);

test('one point, and points that no grid holds', async () => {
  const one = await packed(Float64Array.from([1.5, -2]), 2);
  expect(pointsIn((await unpacked(one?.text ?? '')).table)).toHaveLength(2);
  const far = await packed(Float64Array.from([1e20, 1, 1e20 + 2 ** 15, 2]), 2);
  expect(pointsIn((await unpacked(far?.text ?? '')).table).slice(0, 3)).toEqual([1e20, 0, 1e20 + 2 ** 15]);
  expect(await packed(Float64Array.from([0, 0, 5e-324, 0]), 2)).toBeUndefined();
});

test.each(['', 'x', '2.0.0', '2.0.0.0.%%%', '2.0.0.0.AAAA', '0.0.AA', '2.0.0.zz.AA', '1e9.0.AA'])(
  'damaged points are a sentence: %s',
  async (text) => {
    await expect(unpacked(text)).rejects.toThrow(/damaged/);
  },
);

test('what would unpack to far more than a link can mean is refused', async () => {
  const zeros = new Float64Array(3_000_000);
  const bomb = await packed(zeros, 1);
  expect(bomb?.text.length).toBeLessThan(32_768);
  await expect(unpacked(bomb?.text ?? '')).rejects.toThrow(/damaged/);
});

describe('a link to two runs', () => {
  const first = {
    source: { kind: 'sample', shape: 'torus', size: 300 },
    options: { nu: [1, 6, 6, 4] },
    step: 40,
    reached: 0,
    view: { axis: 'log', pose: [1, 2, 3, 0, 0, 0] },
  } as const;

  test.each([
    ['the same points', { source: undefined, options: { nu: [1, 2, 3, 4], first: 7 }, scale: 0.1 + 0.2 }],
    [
      'another shape, looked at from elsewhere',
      {
        source: { kind: 'sample', shape: 'sphere', size: 50, noise: 0.1 },
        options: { family: 'delaunay' },
        scale: -1.25,
        pose: [3, 2, 1, 0, 0, 0.5],
      },
    ],
    [
      'points of its own',
      { source: { kind: 'points', points: '2.x', name: 'mine & yours' }, options: {}, scale: 2 },
    ],
  ] as const)('holds both: %s', (_, beside) => {
    const fragment = fragmentOf({ ...first, beside });
    expect(linkedIn(`#${fragment}`)).toEqual({ ...first, beside });
    // The words of the second run are not taken for those of the first.
    expect(linkedIn(fragmentOf(first))).toEqual(first);
  });

  test('is refused where the second run makes no sense', () => {
    expect(() => linkedIn('#v=1&shape=torus&n=300&b.scale=1')).toThrow('cut off');
    expect(() => linkedIn('#v=1&shape=torus&n=300&b.same=1&b.nu=x')).toThrow('nu=x');
    expect(linkedIn('#v=1&shape=torus&n=300&b.same=1&b.scale=x')?.beside?.scale).toBe(0);
  });
});
