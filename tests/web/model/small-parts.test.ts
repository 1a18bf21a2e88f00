import { describe, expect, test } from 'vitest';
import { Afterglow } from '../../../web/src/model/afterglow.ts';
import { flatness } from '../../../web/src/model/flatness.ts';
import { History } from '../../../web/src/model/history.ts';
import { CardStack, cardWords } from '../../../web/src/model/plateau-cards.ts';
import { bettiInNumbers } from '../../../web/src/model/words.ts';
import { plateausOf } from './fixtures.ts';

describe('the afterglow', () => {
  test('runs after the playhead, smoothly, and reaches it', () => {
    const afterglow = new Afterglow();
    afterglow.restart(7);
    expect(afterglow.follow(7, 16)).toBe(7);
    const first = afterglow.follow(8, 16);
    expect(first).toBeGreaterThan(7);
    expect(first).toBeLessThan(7.1);
    let before = first;
    for (let frame = 0; frame < 200 && before < 8; ++frame) {
      const now = afterglow.follow(8, 16);
      expect(now).toBeGreaterThan(before);
      before = now;
    }
    expect(before).toBe(8);
  });

  test('does not depend on how often it is asked', () => {
    const [often, seldom] = [new Afterglow(), new Afterglow()];
    for (let i = 0; i < 10; ++i) often.follow(100, 10);
    expect(often.follow(100, 0)).toBeCloseTo(seldom.follow(100, 100), 9);
  });
});

describe('flatness', () => {
  const points = (...rows: number[][]): Float64Array => Float64Array.from(rows.flat());
  /** On a tilted plane, far from the origin. */
  const tilted = (i: number): number[] => {
    const [u, v] = [Math.cos(i), Math.sin(2 * i)];
    return [100 + 0.3 * u + 0.5 * v, -20 + 0.7 * u - 0.1 * v, 5 + 0.9 * u + 0.2 * v];
  };

  test.each([
    ['collinear in space', points([0, 0, 0], [0.1, 0.2, 0.3], [0.7, 1.4, 2.1]), 3, 'line'],
    ['collinear in the plane', points([1, 1], [2, 3], [4, 7]), 2, 'line'],
    ['a plane of the axes', points([0, 0, 5], [1, 0, 5], [0, 1, 5], [3, 3, 5]), 3, 'plane'],
    ['a tilted plane', points(...Array.from({ length: 90 }, (_, i) => tilted(i))), 3, 'plane'],
    ['twice the same point first', points([1, 1], [1, 1], [2, 2], [3, 1]), 2, undefined],
    ['in space', points([0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]), 3, undefined],
    ['almost flat', points([0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0.0001]), 3, undefined],
    ['in the plane', points([0, 0], [1, 0], [0, 1]), 2, undefined],
  ])('%s', (_, coordinates, dimension, expected) => {
    expect(flatness(coordinates, dimension)).toBe(expected);
  });
});

test('a history that went ahead comes back to what is shown', () => {
  const history = new History<string>();
  for (const entry of ['a', 'b', 'c']) history.add(entry);
  const shown = history.place;
  history.go(-1);
  history.go(-1);
  expect(history.peek(1)).toBe('b');
  history.returnTo(shown);
  expect([history.peek(-1), history.peek(1)]).toEqual(['b', undefined]);
  history.add('d');
  expect(history.peek(-1)).toBe('c');
});

test('dust comes last, and says that it is dust', () => {
  const plateaus = plateausOf([
    { steps: [900, 5000], epsilon: [1e-3, 1e-5], ratio: 100, family: 1, betti: [1700, 0, 0] },
    { steps: [30, 50], epsilon: [1, 0.6], ratio: 1.8, family: 2, betti: [2, 2, 2] },
  ]);
  const [shape, dust] = new CardStack({ bettiCount: 3, otherField: 0 }).ranked(plateaus);
  expect([shape?.firstStep, dust?.firstStep]).toEqual([30, 900]);
  expect(shape && cardWords(shape).note).toBeUndefined();
  expect(dust && cardWords(dust).note).toBe('at most 2 landmarks a piece: too few to trust');
});

test('lists of large numbers stay readable', () => {
  expect(bettiInNumbers([11060, 0, 999])).toBe('β 11\u202f060, 0, 999');
});

test('cards of few landmarks come last, however long', () => {
  const plateaus = plateausOf([
    { steps: [1, 3], epsilon: [8, 4], ratio: 4, family: 1, betti: [1, 0, 0] },
    { steps: [30, 50], epsilon: [1, 0.6], ratio: 1.8, family: 2, betti: [1, 2, 1] },
    { steps: [60, 90], epsilon: [0.5, 0.2], ratio: 2.6, family: 1, betti: [1, 1, 0] },
  ]);
  expect(
    new CardStack({ bettiCount: 3, otherField: 0 }).ranked(plateaus).map(({ firstStep }) => firstStep),
  ).toEqual([60, 30, 1]);
});
