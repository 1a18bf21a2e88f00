import { expect, test } from 'vitest';
import { bunnyText } from '../../../web/src/model/bunny-points.ts';

function points(text: string): number[][] {
  return text
    .trimEnd()
    .split('\n')
    .map((line) => line.split(' ').map(Number));
}

test('the same points for the same seed, upright', () => {
  expect(bunnyText(50, 0)).toBe(bunnyText(50, 0));
  expect(bunnyText(50, 0, 2)).not.toBe(bunnyText(50, 0));
  const heights = points(bunnyText(2000, 0)).map(([, , z = NaN]) => z);
  expect(heights).toHaveLength(2000);
  // The mesh stands on about 0 and its ears reach beyond 9.
  expect(Math.min(...heights)).toBeGreaterThan(-1);
  expect(Math.max(...heights)).toBeGreaterThan(9);
});

test('noise moves each point by no more than its radius, and only then', () => {
  const clean = points(bunnyText(300, 0));
  const moved = points(bunnyText(300, 0.1)).map((point, i) =>
    Math.hypot(...point.map((x, axis) => x - (clean[i]?.[axis] ?? NaN))),
  );
  expect(Math.max(...moved)).toBeLessThanOrEqual(0.1 + 1e-12);
  expect(Math.max(...moved)).toBeGreaterThan(0.05);
});
