import { beforeAll, beforeEach, describe, expect, test } from 'vitest';
import type { PlateauModule } from 'plateau-module';
import type { WorkerEvent, WorkerRequest } from '../../web/src/worker/protocol.ts';
import { WorkerRuntime } from '../../web/src/worker/runtime.ts';
import { buffersOf } from '../../web/src/worker/transfer.ts';
import { file, loadModule, sample } from './module.ts';

let module: PlateauModule;
let events: WorkerEvent[];
let waiting: (() => void)[];
let runtime: WorkerRuntime;

beforeAll(async () => {
  module = await loadModule();
});
beforeEach(() => {
  events = [];
  waiting = [];
  runtime = new WorkerRuntime(
    module,
    (event) => events.push(event),
    (callback) => waiting.push(callback),
  );
});

/** Lets the runtime compute, at most so many slices. */
function slices(most = Infinity): number {
  let done = 0;
  for (; done < most; ++done) {
    const next = waiting.shift();
    if (!next) break;
    next();
  }
  return done;
}

function answerTo(requestId: number): WorkerEvent {
  const found = events.filter((event) => event.kind !== 'ready' && event.requestId === requestId);
  expect(found).toHaveLength(1);
  return found[0];
}

function open(runId: number, requestId: number, source = sample('torus', 120)): void {
  runtime.handle({ kind: 'open', runId, requestId, source, options: {} });
}

describe('the worker', () => {
  test('answers each request once, from opening to closing', () => {
    open(1, 1);
    slices();
    expect(answerTo(1).kind).toBe('opened');
    const requests: WorkerRequest[] = [
      { kind: 'fetchDelta', runId: 1, requestId: 2 },
      { kind: 'fetchPlateaus', runId: 1, requestId: 3 },
      { kind: 'export', runId: 1, requestId: 4, format: 'betti-csv' },
      { kind: 'pause', runId: 1, requestId: 5 },
      { kind: 'resume', runId: 1, requestId: 6 },
      { kind: 'close', runId: 1, requestId: 7 },
      { kind: 'fetchDelta', runId: 1, requestId: 8 },
    ];
    for (const request of requests) runtime.handle(request);
    slices();
    const kinds = [2, 3, 4, 5, 6, 7, 8].map((requestId) => answerTo(requestId).kind);
    expect(kinds).toEqual(['delta', 'plateaus', 'exported', 'paused', 'resumed', 'closed', 'failed']);
    const delta = answerTo(2);
    expect(delta.kind === 'delta' && delta.delta.state).toBe('finished');
  });

  test('a value of a wrong type fails alone: another run goes on', () => {
    open(1, 1, sample('torus', 400));
    slices(3);
    const wrong = 20000 as unknown as string;
    open(2, 2, sample(wrong, 10));
    runtime.handle({ kind: 'export', runId: 1, requestId: 3, format: wrong as 'betti-csv' });
    runtime.handle({ kind: 'fetchDelta', runId: 1, requestId: 4 });
    for (const requestId of [2, 3])
      expect(answerTo(requestId)).toMatchObject({ kind: 'failed', failure: { code: 8 } });
    expect(answerTo(4).kind).toBe('delta');
    slices();
    runtime.handle({ kind: 'fetchDelta', runId: 1, requestId: 5 });
    const delta = answerTo(5);
    expect(delta.kind === 'delta' && delta.delta.state).toBe('finished');
  });

  test('gives a session away and opens it as that run', () => {
    open(1, 1);
    slices();
    runtime.handle({
      kind: 'export',
      runId: 1,
      requestId: 2,
      format: 'session',
      step: 9,
      view: '{"zoom":2}',
    });
    const exported = answerTo(2);
    if (exported.kind !== 'exported') throw new Error('a file was asked for');
    open(2, 3, file('any name', exported.bytes));
    slices();
    const opened = answerTo(3);
    if (opened.kind !== 'opened') throw new Error('it is to be opened');
    expect(opened.opened.session).toMatchObject({ step: 9, reached: 120, view: '{"zoom":2}' });
    runtime.handle({ kind: 'fetchDelta', runId: 2, requestId: 4 });
    expect(answerTo(4)).toMatchObject({ kind: 'delta', delta: { agreesWithSession: true } });
  });

  test('computes nothing while it is paused', () => {
    open(1, 1, sample('torus', 2000));
    slices(2);
    runtime.handle({ kind: 'pause', runId: 1, requestId: 2 });
    slices();
    runtime.handle({ kind: 'fetchDelta', runId: 1, requestId: 3 });
    runtime.handle({ kind: 'fetchDelta', runId: 1, requestId: 4 });
    const [first, second] = [answerTo(3), answerTo(4)];
    if (first.kind !== 'delta' || second.kind !== 'delta') throw new Error('no deltas');
    expect(first.delta.state).not.toBe('finished');
    expect(second.delta.landmark).toHaveLength(0);
    runtime.handle({ kind: 'resume', runId: 1, requestId: 5 });
    expect(slices(3)).toBe(3);
    runtime.handle({ kind: 'close', runId: 1, requestId: 6 });
    expect(slices()).toBeLessThanOrEqual(1);
  });

  test('a failed opening leaves the other run alone', () => {
    open(1, 1);
    open(2, 2, file('a.xyz', '1 2 3\n4 5\n'));
    slices();
    expect(answerTo(1).kind).toBe('opened');
    expect(answerTo(2)).toMatchObject({ kind: 'failed', runId: 2 });
    runtime.handle({ kind: 'fetchDelta', runId: 1, requestId: 3 });
    expect(answerTo(3).kind).toBe('delta');
  });

  test('closing a run that still opens answers both', () => {
    open(1, 1);
    runtime.handle({ kind: 'close', runId: 1, requestId: 2 });
    slices();
    expect(answerTo(1).kind).toBe('failed');
    expect(answerTo(2).kind).toBe('closed');
  });

  function delta(requestId: number) {
    runtime.handle({ kind: 'fetchDelta', runId: 1, requestId });
    const event = answerTo(requestId);
    if (event.kind !== 'delta') throw new Error(event.kind);
    return event.delta;
  }

  test('the first landmarks are not kept back until a block of them is full', () => {
    open(1, 1, sample('torus', 20_000));
    while (!events.some(({ kind }) => kind === 'opened')) slices(1);
    let first = delta(100);
    for (let id = 101; first.stepCount === 0; ++id) {
      slices(1);
      first = delta(id);
    }
    expect(first.stepCount).toBeLessThan(40);
  });

  test('a stop at the noise can be lifted', () => {
    const source = sample('torus', 600);
    runtime.handle({ kind: 'open', runId: 1, requestId: 1, source, options: { noiseStopFrom: 600 } });
    slices();
    let last = delta(1000);
    for (let id = 1001; last.state === 'running'; ++id) last = delta(id);
    expect(last).toMatchObject({ state: 'finished', endedAtNoise: true });
    expect(last.noise).toBeGreaterThan(0);
    expect(last.memoryBytes).toBeGreaterThan(100_000);
    expect(last.stepCount).toBeLessThan(600);
    runtime.handle({ kind: 'runPastNoise', runId: 1, requestId: 2000 });
    expect(answerTo(2000).kind).toBe('lifted');
    slices();
    last = delta(2001);
    expect(last).toMatchObject({ state: 'finished', endedAtNoise: false, stepCount: 600, noise: 0 });
  });

  test.each(['auto', 'delaunay', 'witness', 'dilated'] as const)(
    'an end at a plateau is one from which it goes on to the next, and to the end: %s',
    (family) => {
      const source = sample('torus', 300);
      const maxSteps = 120;
      runtime.handle({
        kind: 'open',
        runId: 1,
        requestId: 1,
        source,
        options: { family, minLength: 0.4, maxSteps },
      });
      slices();
      let id = 1000;
      const ends: number[] = [];
      for (;;) {
        let last = delta(id++);
        while (last.state === 'running') last = delta(id++);
        expect(last.state).toBe('finished');
        ends.push(last.stepCount);
        if (!last.endedAtPlateau) break;
        runtime.handle({ kind: 'runToNextPlateau', runId: 1, requestId: ++id });
        expect(answerTo(id++).kind).toBe('lifted');
        slices();
      }
      expect(ends.length).toBeGreaterThan(1);
      expect(ends.at(-1)).toBe(maxSteps);
      expect(ends).toEqual([...new Set(ends)].sort((a, b) => a - b));
      // What did not end at a plateau ends where it was.
      runtime.handle({ kind: 'runToNextPlateau', runId: 1, requestId: ++id });
      slices();
      expect(delta(id + 1)).toMatchObject({ state: 'finished', stepCount: maxSteps, endedAtPlateau: false });
    },
  );

  test('what it sends can be transferred as a whole', () => {
    open(1, 1);
    slices();
    runtime.handle({ kind: 'fetchDelta', runId: 1, requestId: 2 });
    runtime.handle({ kind: 'fetchPlateaus', runId: 1, requestId: 3 });
    runtime.handle({ kind: 'export', runId: 1, requestId: 4, format: 'mesh-ply' });
    for (const event of events) {
      const buffers = buffersOf(event);
      expect(buffers.length).toBeGreaterThan(0);
      const received = structuredClone(event, { transfer: buffers });
      for (const buffer of buffers) expect(buffer.byteLength).toBe(0);
      expect(buffersOf(received)).toHaveLength(buffers.length);
    }
  });
});
