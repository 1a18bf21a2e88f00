import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { WorkerEvent, WorkerRequest } from '../../web/src/worker/protocol.ts';
import { expect, root, shown, state, test } from '../web/page.ts';
import { clouds, commandHash, familiesFor, plateau } from './cases.ts';

declare global {
  interface Window {
    workerAddress: string;
  }
}

test('the worker in Chromium computes what the command computes, for every cloud and family', async ({
  page,
}) => {
  test.setTimeout(300_000);
  await page.addInitScript(() => {
    const Original = Worker;
    window.Worker = class extends Original {
      constructor(address: string | URL, options?: WorkerOptions) {
        super(address, options);
        window.workerAddress = String(address);
      }
    };
  });
  await page.goto('./?sample=circle-noise&n=50');
  await expect(root(page)).toHaveAttribute('data-run-state', 'finished');
  const cases = clouds().flatMap((cloud) =>
    familiesFor(cloud).map((family) => ({ name: cloud.name, text: cloud.text, family })),
  );
  const found = await page.evaluate(async (all) => {
    const worker = new Worker(window.workerAddress, { type: 'module' });
    const waiting = new Map<number, (event: WorkerEvent) => void>();
    worker.onmessage = ({ data }: MessageEvent<WorkerEvent>) => {
      if (data.kind !== 'ready') waiting.get(data.requestId)?.(data);
    };
    let requestId = 0;
    const ask = (request: { kind: WorkerRequest['kind'] } & Record<string, unknown>): Promise<WorkerEvent> =>
      new Promise((resolve) => {
        requestId += 1;
        waiting.set(requestId, resolve);
        worker.postMessage({ ...request, requestId });
      });
    const hashes: string[] = [];
    for (const [runId, { text, family }] of all.entries()) {
      const bytes = new TextEncoder().encode(text).buffer;
      await ask({
        kind: 'open',
        runId,
        source: { kind: 'file', name: 'cloud.xyz', bytes },
        options: { family },
      });
      for (;;) {
        const event = await ask({ kind: 'fetchDelta', runId });
        if (event.kind !== 'delta') {
          hashes.push(JSON.stringify(event));
          break;
        }
        if (event.delta.state === 'finished') {
          hashes.push(event.delta.hash);
          break;
        }
      }
      await ask({ kind: 'close', runId });
    }
    worker.terminate();
    return hashes;
  }, cases);
  const named = cases.map(({ name, family }, i) => `${name}, ${family}: ${found[i]}`);
  const expected = cases.map(({ name, text, family }) => `${name}, ${family}: ${commandHash(text, family)}`);
  expect(named).toEqual(expected);
});

test('a dropped file gives the hash and the files that the command gives', async ({ page }) => {
  const folder = mkdtempSync(join(tmpdir(), 'plateau-'));
  const cloud = join(folder, 'cloud.xyz');
  const [csv, ply] = [join(folder, 'betti.csv'), join(folder, 'mesh.ply')];
  writeFileSync(cloud, plateau(['sample', 'torus', '--n', '300']));
  await page.goto('./?sample=circle-noise&n=50');
  await expect(root(page)).toHaveAttribute('data-run-state', 'finished');
  await page.getByLabel('Open point cloud').setInputFiles(cloud);
  await shown(page, 'cloud.xyz');
  const printed = plateau([
    'run',
    cloud,
    '--hash',
    '--betti',
    csv,
    '--mesh',
    ply,
    '--at',
    await state(page, 'step'),
  ]);
  expect(printed).toContain(`hash ${await state(page, 'hash')}`);
  for (const [button, file] of [
    ['Betti numbers (CSV)', csv],
    ['Mesh (PLY)', ply],
  ] as const) {
    const download = page.waitForEvent('download');
    await page.getByRole('button', { name: button }).click();
    expect(readFileSync(await (await download).path(), 'utf8')).toBe(readFileSync(file, 'utf8'));
  }
});
