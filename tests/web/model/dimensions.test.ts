import { describe, expect, it } from 'vitest';
import { FIRST_AXES, MOST_AXES, keptBy, rowsOf, withAxis } from '../../../web/src/model/dimensions.ts';

const row = (rows: Float32Array, i: number): number[] => [...rows.slice(i * MOST_AXES, (i + 1) * MOST_AXES)];
const product = (a: number[], b: number[]): number =>
  a.reduce((sum, value, i) => sum + value * (b[i] ?? 0), 0);

describe('a view of more than three dimensions', () => {
  it('shows the chosen axes before it turns', () => {
    const rows = rowsOf(6, [4, 0, 2], 0);
    expect(row(rows, 0).indexOf(1)).toBe(4);
    expect(row(rows, 1).indexOf(1)).toBe(0);
    expect(row(rows, 2).indexOf(1)).toBe(2);
    expect(rows.reduce((sum, value) => sum + value, 0)).toBe(3);
  });
  it('is a view of right angles and true lengths at every angle, and leaves no axis unseen', () => {
    for (const axes of [3, 4, 5, 8]) {
      const seen = new Set<number>();
      for (let angle = 0; angle < 40; angle += 0.7) {
        const rows = rowsOf(axes, FIRST_AXES, angle);
        for (let i = 0; i < 3; ++i) {
          for (let j = 0; j < 3; ++j)
            expect(product(row(rows, i), row(rows, j))).toBeCloseTo(i === j ? 1 : 0, 5);
        }
        rows.forEach((value, i) => Math.abs(value) > 0.5 && seen.add(i % MOST_AXES));
      }
      expect([...seen].sort()).toEqual(Array.from({ length: axes }, (_, axis) => axis));
    }
  });
  it('does not turn where nothing is hidden', () => {
    expect([...rowsOf(3, FIRST_AXES, 2)]).toEqual([...rowsOf(3, FIRST_AXES, 0)]);
  });
  it('tells what it keeps', () => {
    const shares = [0.5, 0.25, 0.125, 0.125];
    expect(keptBy(rowsOf(4, FIRST_AXES, 0), shares)).toBeCloseTo(0.875);
    expect(keptBy(rowsOf(4, [3, 1, 2], 0), shares)).toBeCloseTo(0.5);
    expect(keptBy(rowsOf(4, FIRST_AXES, Math.PI / 2), shares)).toBeCloseTo(0.5);
  });
  it('swaps axes, so that none is drawn twice', () => {
    expect(withAxis([0, 1, 2], 0, 2)).toEqual([2, 1, 0]);
    expect(withAxis([0, 1, 2], 1, 5)).toEqual([0, 5, 2]);
    expect(withAxis([0, 1, 2], 1, 1)).toEqual([0, 1, 2]);
  });
});
