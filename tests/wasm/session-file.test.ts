import { beforeAll, describe, expect, test } from 'vitest';
import type { ModuleRun, PlateauModule } from 'plateau-module';
import type { CloudSource, Delta, OpenedRun, RunOptions } from '../../web/src/worker/protocol.ts';
import { allDeltas, expected, file, finishedRun, loadModule, opened, runThrough, sample } from './module.ts';

let module: PlateauModule;
beforeAll(async () => {
  module = await loadModule();
});

function saved(run: ModuleRun, step?: number, view?: string): Uint8Array<ArrayBuffer> {
  return expected(run.exportFile('session', step, view)).bytes;
}

interface Reopened {
  readonly run: ModuleRun;
  readonly answer: OpenedRun;
}

function reopened(bytes: Uint8Array, options: RunOptions = {}, more: object = {}): Reopened {
  const run = new module.Run({ ...file('x.plateau', bytes), ...more }, options);
  return { run, answer: opened(run) };
}

const last = (deltas: readonly Delta[]): Delta | undefined => deltas[deltas.length - 1];

describe('a session file', () => {
  test('opens as the run that was saved, with its view', () => {
    const view = '{"camera":[1,0.5,-2],"note":"naïve\\n→"}';
    const options = { family: 'delaunay', nu: [1, 2, 3, 4], first: 7, maxSteps: 150 } as const;
    const first = finishedRun(module, sample('torus', 300), options);
    const bytes = saved(first, 40, view);
    const { run, answer } = reopened(bytes);
    expect(answer.session).toEqual({
      step: 40,
      reached: 150,
      hash: first.hash(),
      view,
      options: { metric: 'euclidean', field: 2, rho: 0, ...options },
    });
    expect(answer.family).toBe('delaunay');
    expect(answer.stepsPlanned).toBe(150);
    runThrough(run, Infinity);
    expect(run.hash()).toBe(first.hash());
    expect(last(allDeltas(run, 1e9))?.agreesWithSession).toBe(true);
    expect(saved(run, 40, view)).toEqual(bytes);
    first.delete();
    run.delete();
  });

  test('goes on where it was saved, and tells as soon as it has come there', () => {
    const first = new module.Run(sample('torus', 200), {});
    opened(first);
    while (expected(first.run(Infinity, 10)).stepsDone < 50);
    const bytes = saved(first);
    const { run } = reopened(bytes);
    while (expected(run.run(Infinity, 10)).stepsDone < 40);
    expect(expected(run.delta(1e9))).not.toHaveProperty('agreesWithSession');
    runThrough(run, Infinity);
    expect(expected(run.delta(1e9)).agreesWithSession).toBe(true);
    const whole = finishedRun(module, sample('torus', 200));
    expect(run.hash()).toBe(whole.hash());
    for (const one of [first, run, whole]) one.delete();
  });

  test('says when the run is another one', () => {
    const first = finishedRun(module, sample('torus', 100));
    const bytes = saved(first);
    const at = bytes.length - 8 * 150;
    const number = new DataView(bytes.buffer).getFloat64(at, true);
    new DataView(bytes.buffer).setFloat64(at, number + 1e-9, true);
    const { run } = reopened(bytes);
    runThrough(run, Infinity);
    expect(last(allDeltas(run, 1e9))?.agreesWithSession).toBe(false);
    first.delete();
    run.delete();
  });

  test('of a run that was let on past its noise has no stop there', () => {
    const first = new module.Run(sample('torus', 300), { noiseStopFrom: 0 });
    opened(first);
    runThrough(first, Infinity);
    const early = saved(first);
    expected(first.runPastNoise());
    runThrough(first, Infinity);
    const { answer } = reopened(saved(first));
    expect(answer.session?.reached).toBe(300);
    expect(answer.session?.options).not.toHaveProperty('noiseStopFrom');
    const stopped = reopened(early);
    expect(stopped.answer.session?.options.noiseStopFrom).toBe(0);
    runThrough(stopped.run, Infinity);
    const delta = last(allDeltas(stopped.run, 1e9));
    expect(delta?.endedAtNoise).toBe(true);
    expect(delta?.stepCount).toBe(stopped.answer.session?.reached);
    expect(delta?.agreesWithSession).toBe(true);
  });

  test('keeps its options against those of the request, unless these are said to be new', () => {
    const first = finishedRun(module, sample('sphere', 80), { family: 'delaunay' });
    const bytes = saved(first);
    const asked = { family: 'witness', metric: 'l1', maxSteps: 30 } as const;
    expect(reopened(bytes, asked).answer).toMatchObject({ family: 'delaunay', metric: 'euclidean' });
    const { run, answer } = reopened(bytes, asked, { newOptions: true });
    expect(answer).toMatchObject({ family: 'witness', metric: 'l1', stepsPlanned: 30 });
    expect(answer).not.toHaveProperty('session');
    runThrough(run, Infinity);
    expect(last(allDeltas(run, 1e9))).not.toHaveProperty('agreesWithSession');
    // The memory is the page's affair in any case.
    expect(reopened(bytes, { memoryLimit: 1e8 }).answer.memoryLimitBytes).toBe(1e8);
  });

  test.each<[string, CloudSource, RunOptions]>([
    ['distances', file('m.csv', '0,1,2\n1,0,2.5\n2,2.5,0\n'), { metric: 'matrix' }],
    ['a flat torus', sample('circle-noise', 60), { metric: 'periodic', box: [3, 3.25], family: 'witness' }],
    ['geodesics', sample('sphere', 150), { metric: 'geodesic', knn: 7 }],
    [
      'four coordinates',
      { ...file('four.txt', '0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0.5\n'), anyDimension: true } as CloudSource,
      { maxDimension: 1, field: 3 },
    ],
  ])('holds %s', (_, source, options) => {
    const first = finishedRun(module, source, options);
    const { run, answer } = reopened(saved(first));
    expect(answer.session?.options).toMatchObject(options);
    runThrough(run, Infinity);
    expect(run.hash()).toBe(first.hash());
    expect(last(allDeltas(run, 1e9))?.agreesWithSession).toBe(true);
  });

  test('of 100,000 points comes back bit for bit', () => {
    const first = new module.Run(sample('torus', 100_000), { maxSteps: 300 });
    const before = opened(first);
    runThrough(first, Infinity);
    const bytes = saved(first, 200, '{}');
    expect(bytes.length).toBeLessThan(2_400_400);
    const { run, answer } = reopened(bytes);
    expect(Buffer.from(answer.coordinates.buffer).equals(Buffer.from(before.coordinates.buffer))).toBe(true);
    runThrough(run, Infinity);
    expect(run.hash()).toBe(first.hash());
    expect(saved(run, 200, '{}')).toEqual(bytes);
  });

  test('that is broken is a sentence', () => {
    const first = finishedRun(module, sample('torus', 60));
    const bytes = saved(first);
    const open = (broken: Uint8Array): unknown => new module.Run(file('x.plateau', broken), {}).open(1000);
    expect(open(bytes.subarray(0, bytes.length - 8))).toMatchObject({
      kind: 'failed',
      failure: { code: 5, message: 'The session promises 180 numbers, but 179 are there.' },
    });
    const text = new TextDecoder('latin1').decode(bytes);
    const changed = text.replace('option field 2', 'option color 2');
    expect(open(Uint8Array.from(changed, (letter) => letter.charCodeAt(0)))).toMatchObject({
      kind: 'failed',
      failure: { code: 8 },
    });
  });
});
