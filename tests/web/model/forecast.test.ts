import { describe, expect, test } from 'vitest';
import {
  distancesInWords,
  durationInWords,
  expectedEnd,
  expectedEpsilon,
  memoryInWords,
  progressInWords,
  scanInWords,
  StepRate,
} from '../../../web/src/model/forecast.ts';
import { RunRecord } from '../../../web/src/model/record.ts';
import { deltaOf, openedWith, recordOf } from './fixtures.ts';

const MB = 2 ** 20;

/** A scan of 100,000 points on a surface, 2,000 steps of it: ε falls with the square root of the steps. */
function scan(parts: Parameters<typeof deltaOf>[2] = {}, affordable = 100_000): RunRecord {
  const frame = {
    scale: 1,
    count: 100_000,
    axes: 3,
    shares: [],
    positions: new Float32Array(),
    beyond: new Float32Array(),
    outline: new Float32Array(),
  };
  const record = new RunRecord(
    openedWith({
      frame,
      stepsPlanned: 100_000,
      stepsAffordable: affordable,
      estimatedBytes: 1300 * MB,
      memoryLimitBytes: 3072 * MB,
    }),
  );
  const epsilon = Array.from({ length: 2000 }, (_, i) => 2 / Math.sqrt(i + 1));
  record.append(deltaOf(1, epsilon, { memoryBytes: 30 * MB, ...parts }));
  return record;
}

describe('a scan', () => {
  test('foretells its scales and where it ends', () => {
    expect(expectedEpsilon(scan(), 8000)).toBeCloseTo(2 / Math.sqrt(8000), 10);
    expect(expectedEnd(scan())).toBe(100_000);
    expect(expectedEnd(scan({}, 40_000))).toBe(40_000);
    const atNoise = expectedEnd(scan({ noise: 0.01 }));
    expect(Math.abs(atNoise - 40_000)).toBeLessThanOrEqual(1);
    expect(expectedEnd(scan({ noise: 0.001 }))).toBe(100_000);
  });

  test('says what it takes while it runs', () => {
    const words = progressInWords(scan({ noise: 0.01 }), 1000).replaceAll('\u00a0', ' ');
    expect(words).toBe('computed 2,000 of 100,000 · 30 MB in use of about 1.3 GB · about 40 s left');
    expect(progressInWords(scan({ memoryBytes: 0 }), undefined)).toMatch(/about 1\.3\sGB needed$/);
  });

  test('says where its memory or its noise will end it', () => {
    expect(scanInWords(scan(), 1234)).toBe('');
    const words = scanInWords(scan({ noise: 0.004 }, 41_234), 1234).replaceAll('\u00a0', ' ');
    expect(words).toBe(
      '100,000 points, read in 1.2 s. The memory of this page (3.0 GB) is enough for about 41,000 landmarks, ' +
        'down to ε ≈ 0.00980. Stops at the noise, ε = 0.00400.',
    );
    const ended = scan({ noise: 0.05, endedAtNoise: true, state: 'finished' });
    expect(scanInWords(ended, 1234)).toBe('Stopped at the noise, ε = 0.0500.');
    ended.runPastNoise();
    expect(ended.state).toBe('running');
    expect(scanInWords(ended, 1234)).toBe('');
  });
});

test('says where a plateau ends it', () => {
  const record = recordOf([1, 0.5, 0.25], 'running', 10, 0.75);
  expect(scanInWords(record, 0)).toBe('Stops at a plateau of length 0.750.');
  record.append(deltaOf(4, [0.2], { state: 'finished', endedAtPlateau: true }));
  expect(scanInWords(record, 0)).toBe('Stopped at a plateau of length 0.750.');
  record.runToNextPlateau();
  expect([record.state, record.plateausPassed]).toEqual(['running', 1]);
  record.append(deltaOf(5, [0.1], { state: 'finished' }));
  record.runToNextPlateau();
  expect([record.state, record.plateausPassed]).toEqual(['finished', 1]);
  expect(scanInWords(record, 0)).toBe('');
});

test('the rate is that of the last seconds', () => {
  const rate = new StepRate();
  rate.see(0, 0);
  expect(rate.perSecond).toBeUndefined();
  for (let at = 100; at <= 20_000; at += 100) rate.see(at, at <= 10_000 ? at : 10_000 + 3 * (at - 10_000));
  expect(rate.perSecond).toBeCloseTo(3000, 6);
});

test('a table of distances says what it takes where that is worth saying', () => {
  expect(distancesInWords(5000)).toBe('As distances of 5,000 points they would take up to 95\u00a0MB.');
  expect(distancesInWords(1500)).toBe('');
});

test('durations and memory are as exact as a guess deserves', () => {
  expect([0.2, 11, 58, 61, 3600, 7800].map(durationInWords)).toEqual([
    'a moment',
    'about 15 s',
    'about 60 s',
    'about 2 min',
    'about 1 h',
    'about 2 h 10 min',
  ]);
  expect([1, 312 * MB, 999 * MB, 1024 * MB, 3072 * MB].map((bytes) => memoryInWords(bytes))).toEqual([
    '1\u00a0MB',
    '312\u00a0MB',
    '999\u00a0MB',
    '1.0\u00a0GB',
    '3.0\u00a0GB',
  ]);
});
