import { describe, expect, test } from 'vitest';
import { readable } from '../../../web/src/model/numbers.ts';
import { cardWords, CardStack } from '../../../web/src/model/plateau-cards.ts';
import { bettiInWords, shapeInWords } from '../../../web/src/model/words.ts';
import { plateausOf } from './fixtures.ts';

const EMBEDDED = { bettiCount: 3, otherField: 0 };

describe('words', () => {
  test.each([
    ['surface', [1, 0, 1], 'sphere-like closed surface'],
    ['surface', [1, 2, 1], 'torus-like closed surface'],
    ['surface', [1, 4, 1], 'double-torus-like closed surface'],
    ['surface', [1, 10, 1], 'closed surface with 5 handles'],
    ['surface', [2, 2, 2], '2 closed surfaces, 1 handle in all'],
    ['delaunay', [1, 1, 0], 'closed curve'],
    ['delaunay', [1, 1], 'closed curve'],
    ['dilated', [1, 1, 0], 'circle-like shape'],
    ['dilated', [1, 1, 1], 'hollow shape with 1 void'],
    ['delaunay', [2, 2], '2 closed curves'],
    ['delaunay', [1, 0, 0], 'one piece without holes'],
    ['delaunay', [1, 3, 0], 'one piece with 3 loops'],
    ['witness', [1, 0, 0, 1], '3-sphere-like shape'],
    ['witness', [1, 2, 1, 0], 'torus-like hollow shape'],
    ['witness', [1, 1, 1, 1], 'one piece with holes up to dimension 3'],
    ['witness', [2, 0, 0, 1], '2 pieces with holes up to dimension 3'],
    ['delaunay', [3, 0, 0], '3 separate pieces'],
    ['delaunay', [1, 2, 1], 'torus-like hollow shape'],
    ['witness', [1, 0, 2], 'hollow shape with 2 voids'],
  ] as const)('%s %j', (family, betti, words) => {
    expect(shapeInWords(family, betti)).toBe(words);
  });

  test('name the two shapes whose torsion is well known', () => {
    const projectivePlane = 'projective-plane-like shape';
    expect(shapeInWords('witness', [1, 1, 1], [1, 0, 0])).toBe(projectivePlane);
    expect(shapeInWords('witness', [1, 0, 0, 0], [1, 1, 1, 0])).toBe(projectivePlane);
    expect(shapeInWords('witness', [1, 2, 1], [1, 1, 0])).toBe('Klein-bottle-like shape');
    expect(shapeInWords('witness', [1, 3, 1], [1, 2, 0])).toBe('hollow shape with 1 void');
  });

  test('say where a plateau means little', () => {
    const card = {
      firstStep: 4,
      lastStep: 9,
      middleStep: 6,
      epsilonFirst: 1,
      length: 0.5,
      family: 'delaunay' as const,
      betti: [1, 1, 0],
      runs: 1,
    };
    expect(cardWords(card).note).toBe('at most 9 landmarks: too few to trust');
    expect(cardWords({ ...card, lastStep: 40 }).note).toBeUndefined();
  });

  test('count what is there', () => {
    expect(bettiInWords([1, 2, 1])).toBe('1 component, 2 loops, 1 void');
    expect(bettiInWords([1200, 0, 0])).toBe('1,200 components');
  });

  test.each([
    [0, '0'],
    [0.43219, '0.432'],
    [0.09999, '0.100'],
    [12.345, '12.3'],
    [999.6, '1,000'],
    [12345.6, '12,300'],
    [0.00012345, '0.000123'],
    [1.5e-9, '1.5\u202f×\u202f10⁻⁹'],
    [2e9, '2\u202f×\u202f10⁹'],
  ])('%d reads %s', (value, text) => {
    expect(readable(value)).toBe(text);
  });
});

describe('cards', () => {
  const torus = { family: 2, betti: [1, 2, 1] };
  const odd = { family: 1, betti: [1, 7, 0] };

  test('join equal runs over a short gap, and look where one of them is', () => {
    const plateaus = plateausOf([
      { steps: [10, 50], epsilon: [1, 0.5], ratio: 2, ...torus },
      { steps: [51, 52], epsilon: [0.5, 0.495], ratio: 1.01, ...odd },
      { steps: [53, 90], epsilon: [0.495, 0.1], ratio: 4.95, ...torus },
    ]);
    const cards = new CardStack(EMBEDDED).joined(plateaus);
    expect(cards).toHaveLength(1);
    expect(cards[0]).toMatchObject({ firstStep: 10, lastStep: 90, runs: 2, middleStep: 71 });
    expect(cards[0]?.length).toBeCloseTo(Math.log(10), 10);
    expect(cardWords(cards[0])).toEqual({
      shape: 'torus-like closed surface',
      counts: '1 component, 2 loops, 1 void',
      scale: 'ε 1.00 → 0.100',
      family: 'surface · 2 runs joined',
    });
  });

  test('keep runs apart that a longer gap separates', () => {
    const plateaus = plateausOf([
      { steps: [10, 50], epsilon: [1, 0.5], ratio: 2, ...torus },
      { steps: [51, 80], epsilon: [0.5, 0.3], ratio: 1.7, ...odd },
      { steps: [81, 90], epsilon: [0.294, 0.1], ratio: 3, ...torus },
    ]);
    expect(new CardStack(EMBEDDED).joined(plateaus)).toHaveLength(3);
    expect(new CardStack(EMBEDDED).ranked(plateaus).map(({ firstStep }) => firstStep)).toEqual([81, 10, 51]);
  });

  test('leave out what is too short to mean anything', () => {
    const plateaus = plateausOf([{ steps: [1, 2], epsilon: [1, 1], ratio: 1.02, ...odd }]);
    expect(new CardStack(EMBEDDED).ranked(plateaus)).toEqual([]);
  });

  test('are the same for a run that grows as for all of it at once', () => {
    let seed = 7;
    const random = (below: number): number => (seed = (seed * 16807) % 2147483647) % below;
    const list = Array.from({ length: 400 }, (_, i) => ({
      steps: [i + 1, i + 1] as const,
      epsilon: [Math.exp(-i / 50), Math.exp(-i / 50)] as const,
      ratio: Math.exp(1 / 50),
      family: 1 + (random(9) === 0 ? 1 : 0),
      betti: [1, random(3) === 0 ? random(3) : 1, 0],
    }));
    const growing = new CardStack(EMBEDDED);
    for (let count = 1; count <= list.length; count += 1 + random(7)) {
      const soFar = plateausOf(list.slice(0, count));
      // The last one can still become longer, or be joined otherwise than it looks now.
      expect(growing.joined(soFar)).toEqual(new CardStack(EMBEDDED).joined(soFar));
    }
    expect(growing.joined(plateausOf(list)).some(({ runs }) => runs > 3)).toBe(true);
  });
});
