import { describe, expect, test } from 'vitest';
import { Playback } from '../../../web/src/model/playback.ts';
import { axisOf, scaleOf, stepAt } from '../../../web/src/model/scale-axis.ts';
import { layOut, scaleToX, xToScale } from '../../../web/src/view/diagram-layout.ts';
import { diagramSvg } from '../../../web/src/view/diagram-svg.ts';
import { recordOf } from './fixtures.ts';

const halving = Array.from({ length: 40 }, (_, i) => 2 ** (-i / 4));

test('twice the speed comes as far in half the time', () => {
  const record = recordOf(halving);
  const reached = (speed: number, frames: number): number => {
    const playback = new Playback();
    playback.speed = speed;
    let step = 20;
    for (let i = 0; i < frames; ++i) step = playback.advance(record, step, 20);
    return step;
  };
  expect(reached(2, 100)).toBe(reached(1, 200));
  expect(reached(2, 100)).toBeGreaterThan(reached(1, 100));
});

describe('the scale', () => {
  test('finds the step that begins at a place or before', () => {
    const record = recordOf(halving);
    for (const step of [1, 2, 17, 40]) {
      expect(stepAt(record, scaleOf(record, step) + 1e-9)).toBe(step);
      expect(stepAt(record, scaleOf(record, step) - 1e-9)).toBe(Math.max(1, step - 1));
    }
    expect(stepAt(record, -100)).toBe(1);
    expect(stepAt(record, 100)).toBe(40);
  });

  test('has a place for ε = 0, also where nothing else is', () => {
    const ending = recordOf([1, 0.5, 0, 0]);
    expect(scaleOf(ending, 3)).toBeGreaterThan(scaleOf(ending, 2));
    expect(scaleOf(ending, 4)).toBe(scaleOf(ending, 3));
    const nothing = recordOf([0]);
    const axis = axisOf(nothing);
    expect(Number.isFinite(axis.low) && axis.high > axis.low).toBe(true);
  });

  test('reaches beyond what is computed while the run goes on, and not after', () => {
    const running = axisOf(recordOf(halving, 'running', 4000));
    expect(running.high).toBeGreaterThan(running.computed + 0.5);
    const finished = axisOf(recordOf(halving, 'finished', 4000));
    expect(finished.high).toBe(finished.computed);
  });
});

describe('the film', () => {
  test('shows the first twenty landmarks one by one, whatever the frame rate', () => {
    for (const frame of [7, 16, 100]) {
      const record = recordOf(halving);
      const playback = new Playback();
      let step = 1;
      let shown = [1];
      for (let time = 0; step < 20; time += frame) {
        expect(time).toBeLessThan(19 * 320 + 20 * 100);
        step = playback.advance(record, step, frame);
        if (step !== shown.at(-1)) shown = [...shown, step];
      }
      expect(shown).toEqual(Array.from({ length: 20 }, (_, i) => i + 1));
    }
  });

  test('then runs with ln 1/ε', () => {
    const epsilon = Array.from({ length: 3000 }, (_, i) => 1 / Math.sqrt(i + 1));
    const record = recordOf(epsilon, 'finished', 3000);
    const playback = new Playback();
    let step = 20;
    let seconds = 0;
    for (; step < 3000; seconds += 0.016) step = playback.advance(record, step, 16);
    // ln(sqrt(3000 / 20)) = 2.5 e-folds of four seconds.
    expect(seconds).toBeGreaterThan(9);
    expect(seconds).toBeLessThan(12);
  });

  test('waits at the end of what is computed and does not rush through ties', () => {
    const ties = recordOf(new Array<number>(500).fill(1), 'running', 1000);
    const playback = new Playback();
    expect(playback.advance(ties, 30, 16)).toBeLessThanOrEqual(32);
    expect(playback.advance(ties, 500, 16)).toBe(500);
  });
});

describe('the diagram', () => {
  const card = {
    firstStep: 5,
    lastStep: 20,
    middleStep: 10,
    epsilonFirst: 0.5,
    length: 2,
    family: 'delaunay' as const,
    betti: [1, 0, 0],
    runs: 1,
  };

  test('draws steps as steps and bands from first step to the step after the last', () => {
    const record = recordOf(halving);
    const layout = layOut(record, [card], { width: 600, height: 200, resolution: 1 });
    expect(layout.series).toHaveLength(3);
    for (const corners of layout.series) {
      for (let i = 2; i + 1 < corners.length; i += 2) {
        const moved = [corners[i] !== corners[i - 2], corners[i + 1] !== corners[i - 1]];
        expect(moved[0] && moved[1]).toBe(false);
      }
    }
    const [band] = layout.bands;
    const perFold = (layout.right - layout.left) / (layout.axis.high - layout.axis.low);
    expect((band?.to ?? 0) - (band?.from ?? 0)).toBeCloseTo((16 / 4) * Math.LN2 * perFold, 6);
  });

  test('spreads 1/ε evenly on the linear axis, with round values', () => {
    const record = recordOf(halving);
    const layout = layOut(record, [], { width: 600, height: 200, resolution: 1, kind: 'linear' });
    const [one, two, three] = [1, 2, 3].map((value) => scaleToX(layout, Math.log(value)));
    expect((three ?? 0) - (two ?? 0)).toBeCloseTo((two ?? 0) - (one ?? 0), 9);
    for (const x of [layout.left + 1, 300, layout.right]) {
      expect(scaleToX(layout, xToScale(layout, x))).toBeCloseTo(x, 6);
    }
    expect(layout.columns.length).toBeGreaterThan(3);
    const apart = layout.columns.slice(1).map(({ at }, i) => at - (layout.columns[i]?.at ?? 0));
    for (const distance of apart) expect(distance).toBeCloseTo(apart[0] ?? 0, 6);
    const svg = diagramSvg(record, [card], 'linear', 'linear');
    expect(svg).not.toMatch(/NaN|Infinity|undefined/);
  });

  test('thins many steps out to the width', () => {
    const record = recordOf(
      Array.from({ length: 20_000 }, (_, i) => 1 / (i + 1)),
      'finished',
      20_000,
    );
    const layout = layOut(record, [], { width: 600, height: 200, resolution: 1 });
    for (const corners of layout.series) expect(corners.length).toBeLessThan(600 * 8);
  });

  test('is a file of its own', () => {
    const svg = diagramSvg(recordOf(halving), [card], 'A < B & "C"');
    expect(svg).toContain('<title>A &lt; B &amp; &quot;C&quot;</title>');
    expect(svg).toContain('1/ε');
    expect(svg).toContain('plateau: delaunay');
    expect(svg).not.toMatch(/NaN|Infinity|undefined|style=/);
  });
});
