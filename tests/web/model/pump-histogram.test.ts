import { describe, expect, test } from 'vitest';
import {
  amplitudeWarning,
  binInWords,
  pumpHistogram,
  pumpsInWords,
} from '../../../web/src/model/pump-histogram.ts';
import { RunRecord } from '../../../web/src/model/record.ts';
import { deltaOf, openedWith, recordOf } from './fixtures.ts';

/** A record of landmarks with (weight squared, before, after, amplitude, thresholds) each. */
function pumped(pumps: readonly (readonly [number, number, number, number, number])[]): RunRecord {
  const record = new RunRecord(openedWith({ stepsPlanned: pumps.length }));
  // In two deltas, as runs come.
  const middle = Math.ceil(pumps.length / 2);
  for (const [from, to] of [
    [0, middle],
    [middle, pumps.length],
  ] as const) {
    const part = pumps.slice(from, to);
    record.append(
      deltaOf(
        from + 1,
        part.map(() => 1),
        { pumps: Float64Array.from(part.flat()) },
      ),
    );
  }
  return record;
}

describe('the histogram of pumping', () => {
  test('there is none where nothing was pumped', () => {
    expect(pumpHistogram(recordOf([1, 0.5]))).toBeUndefined();
  });

  test('every landmark is counted once before and once after', () => {
    const record = pumped([
      [0, 1, 1, 0, 0],
      [0.25, 0.001, 0.09, 0.25, 7],
      [0, 0.11, 0.11, 0.3, 0],
      [0, 0.1, 0.1, 0.51, 4],
      [0.1, 0, 0.03, 0.6, 1],
    ]);
    const histogram = pumpHistogram(record);
    if (!histogram) throw new Error('there is one');
    // Nine tenths of the measures between 0 and 1 lie below 0.11, which eleven bars of 0.01 or more reach.
    expect(histogram.bins.map(({ from }) => from)).toEqual([
      0, 0.01, 0.02, 0.03, 0.04, 0.05, 0.06, 0.07, 0.08, 0.09, 0.1, 0.11,
    ]);
    expect(histogram.bins.map(({ before }) => before)).toEqual([2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 2]);
    expect(histogram.bins.map(({ after }) => after)).toEqual([0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 1, 2]);
    expect(binInWords(histogram.bins, 3)).toBe('0.03 to 0.04');
    expect(binInWords(histogram.bins, 11)).toBe('0.11 and more');
    expect(pumpsInWords(histogram)).toBe(
      '2 of 5 landmarks got a weight; the largest relative amplitude is 0.600.',
    );
    expect(histogram.thresholds).toBe(12);
    expect(histogram.unsafeFrom).toBe(4);
    expect(amplitudeWarning(histogram)).toMatch(/^From step 4 on .* more than half/);
  });

  test('where no simplex is flat, and no weight is chosen', () => {
    const histogram = pumpHistogram(
      pumped([
        [0, 1, 1, 0, 0],
        [0, 1, 1, 0, 0],
      ]),
    );
    if (!histogram) throw new Error('there is one');
    expect(histogram.bins.at(-1)).toMatchObject({ before: 2, after: 2 });
    expect(pumpsInWords(histogram)).toMatch(/^0 of 2 landmarks got a weight: nowhere/);
    expect(amplitudeWarning(histogram)).toBe('');
  });
});
