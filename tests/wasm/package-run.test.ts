import { expect, test } from 'vitest';
import { openWith } from '../../web/src/package/open-cloud.ts';
import type { Run } from '../../web/src/package/run.ts';
import { SharedClient } from '../../web/src/package/shared-client.ts';
import { deltaOf } from '../web/model/fixtures.ts';
import { FakeWorker } from './fake-worker.ts';

const turn = (): Promise<void> => new Promise((done) => setTimeout(done));

/** A run that is paused and has given all steps that it has. */
async function pausedRun(worker: FakeWorker): Promise<{ run: Run; ending: Promise<unknown> }> {
  const opening = openWith(new SharedClient(() => worker), { shape: 'torus', size: 10 }, {});
  await turn();
  worker.open();
  const run = await opening;
  const pausing = run.pause();
  worker.answer({ kind: 'paused', runId: 1, requestId: 2 });
  await pausing;
  const ending = run.end();
  worker.answer({ kind: 'delta', runId: 1, requestId: 3, delta: deltaOf(1, []) });
  await turn();
  return { run, ending };
}

test('who waits for a paused run is told when its worker dies', async () => {
  const worker = new FakeWorker();
  const { ending } = await pausedRun(worker);
  const told = expect(ending).rejects.toMatchObject({ code: 'worker-failed' });
  worker.die('out of bounds');
  await told;
});

test('a pause is over also where the run cannot be resumed', async () => {
  const worker = new FakeWorker();
  const { run, ending } = await pausedRun(worker);
  const told = expect(ending).rejects.toThrow('no more');
  const resuming = expect(run.resume()).rejects.toThrow('not now');
  worker.answer({ kind: 'failed', runId: 1, requestId: 4, failure: { code: 12, message: 'not now' } });
  await resuming;
  worker.answer({ kind: 'failed', runId: 1, requestId: 5, failure: { code: 12, message: 'no more' } });
  await told;
});
