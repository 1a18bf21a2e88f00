import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest';
import { PlateauClient } from '../../web/src/client/plateau-client.ts';
import type { PlateauError } from '../../web/src/client/plateau-error.ts';
import { WORKER_FAILED } from '../../web/src/client/plateau-error.ts';
import { openedWith } from '../web/model/fixtures.ts';
import { FakeWorker, OPENED } from './fake-worker.ts';

const source = { kind: 'sample', shape: 'torus', size: 10 } as const;
let workers: FakeWorker[];
let deaths: PlateauError[];
let client: PlateauClient;

function worker(index = workers.length - 1): FakeWorker {
  const found = workers[index];
  if (!found) throw new Error('no worker');
  return found;
}

beforeEach(() => {
  vi.useFakeTimers();
  workers = [];
  deaths = [];
  client = new PlateauClient({
    onDeath: (error) => deaths.push(error),
    spawn: () => {
      workers.push(new FakeWorker());
      return worker();
    },
  });
});
afterEach(() => {
  client.dispose();
  vi.useRealTimers();
});

describe('the client', () => {
  test('gives each answer to the request that asked', async () => {
    const opening = client.open(source, {});
    worker().open();
    const run = await opening;
    const csv = run.exportFile('betti-csv');
    const ply = run.exportFile('mesh-ply', 3);
    const [, first, second] = worker().requests;
    expect(second).toMatchObject({ kind: 'export', format: 'mesh-ply', step: 3 });
    worker().answer({
      kind: 'exported',
      runId: 1,
      requestId: second?.requestId ?? 0,
      bytes: Uint8Array.of(2),
    });
    worker().answer({
      kind: 'exported',
      runId: 1,
      requestId: first?.requestId ?? 0,
      bytes: Uint8Array.of(1),
    });
    expect(await csv).toEqual(Uint8Array.of(1));
    expect(await ply).toEqual(Uint8Array.of(2));
  });

  test('asks for a session with what the page wants to find again', async () => {
    const opening = client.open(source, {});
    worker().open();
    const run = await opening;
    void run.exportFile('session', 3, '{"zoom":2}').catch(() => undefined);
    expect(worker().requests[1]).toMatchObject({ format: 'session', step: 3, view: '{"zoom":2}' });
  });

  test('turns a failure of the core into an error with its code and words', async () => {
    const opening = client.open(source, {});
    worker().answer({ kind: 'failed', runId: 1, requestId: 1, failure: { code: 3, message: 'Line 2 …' } });
    await expect(opening).rejects.toMatchObject({ code: 'not-a-number', message: 'Line 2 …' });
  });

  test('settles every promise when the worker dies, and goes on with a fresh one', async () => {
    const opening = client.open(source, {});
    worker().open();
    const run = await opening;
    const pending = [
      run.fetchDelta(),
      run.fetchPlateaus(),
      run.exportFile('mesh-ply'),
      run.pause(),
      run.close(),
    ];
    const settled = Promise.allSettled(pending);
    worker().die('memory access out of bounds');
    for (const result of await settled) {
      expect(result).toMatchObject({ status: 'rejected', reason: { code: WORKER_FAILED } });
    }
    expect(worker(0).terminated).toBe(true);
    expect(deaths).toHaveLength(1);
    expect(deaths[0]?.message).toBe('The computation stopped unexpectedly (memory access out of bounds).');

    const again = client.open(source, {});
    expect(workers).toHaveLength(2);
    worker().open();
    await expect(again).resolves.toHaveProperty('opened', OPENED);
  });

  test('a run ends with its worker: what it is asked later fails for the same reason', async () => {
    const opening = client.open(source, {});
    worker().open();
    const run = await opening;
    worker().die('memory access out of bounds');
    for (const asked of [run.fetchDelta(), run.close()]) {
      await expect(asked).rejects.toMatchObject({ code: WORKER_FAILED, cause: deaths[0] });
      await expect(asked).rejects.toThrow(/not open any more.*memory access out of bounds/s);
    }
    expect(workers).toHaveLength(1);
  });

  test('keeps no timer when nothing is awaited', async () => {
    const opening = client.open(source, {});
    worker().begin();
    expect(vi.getTimerCount()).toBe(1);
    worker().open();
    await opening;
    expect(vi.getTimerCount()).toBe(0);
  });

  test('does not wait for ever for a worker that fell silent', async () => {
    const opening = client.open(source, {});
    const settled = expect(opening).rejects.toMatchObject({ code: WORKER_FAILED });
    worker().begin();
    await vi.advanceTimersByTimeAsync(60_000);
    await settled;
    expect(worker().terminated).toBe(true);
  });

  test('a network that takes its time is no dead worker', async () => {
    const opening = client.open(source, {});
    await vi.advanceTimersByTimeAsync(300_000);
    expect(worker().terminated).toBe(false);
    worker().begin();
    worker().open();
    await expect(opening).resolves.toHaveProperty('opened', OPENED);
  });

  test('what a dead worker still says is not of the next one', async () => {
    const lost = expect(client.open(source, {})).rejects.toMatchObject({ code: WORKER_FAILED });
    worker().die('out of bounds');
    await lost;
    const opening = client.open(source, {});
    worker(0).die('once more');
    worker(0).answer({ kind: 'opened', runId: 2, requestId: 2, opened: openedWith({ points: 7 }) });
    expect(deaths).toHaveLength(1);
    worker().open();
    await expect(opening).resolves.toHaveProperty('opened', OPENED);
  });

  test('a run that was closed says so, and is closed once', async () => {
    const opening = client.open(source, {});
    worker().open();
    const run = await opening;
    const closing = [run.close(), run.close()];
    await expect(run.fetchDelta()).rejects.toMatchObject({ code: 'closed' });
    expect(worker().requests.map(({ kind }) => kind)).toEqual(['open', 'close']);
    worker().answer({ kind: 'closed', runId: 1, requestId: 2 });
    await Promise.all(closing);
  });

  test('an aborted opening closes the run and rejects with the reason', async () => {
    const abort = new AbortController();
    const opening = client.open(source, {}, abort.signal);
    abort.abort();
    expect(worker().requests.map(({ kind }) => kind)).toEqual(['open', 'close']);
    worker().answer({ kind: 'failed', runId: 1, requestId: 1, failure: { code: 12, message: 'closed' } });
    await expect(opening).rejects.toHaveProperty('name', 'AbortError');
    await expect(client.open(source, {}, abort.signal)).rejects.toHaveProperty('name', 'AbortError');
  });

  test('an answer of the wrong kind is an error, not a value', async () => {
    const opening = client.open(source, {});
    worker().answer({ kind: 'paused', runId: 1, requestId: 1 });
    await expect(opening).rejects.toThrow(/out of turn/);
  });

  test('disposing settles what waits', async () => {
    const opening = client.open(source, {});
    const settled = expect(opening).rejects.toMatchObject({ code: 'closed' });
    client.dispose();
    await settled;
    expect(deaths).toHaveLength(0);
  });
});
