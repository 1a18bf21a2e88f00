import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { CloudSource, RunOptions, WorkerEvent, WorkerRequest } from '../../web/src/worker/protocol.ts';
import { expect, root, shown, state, test } from '../web/page.ts';
import { cases, commandHash, full, plateau, title } from './cases.ts';

declare global {
  interface Window {
    workerAddress: string;
  }
}

const budgets = [1, Infinity];
const limit = full ? 1_800_000 : 300_000;

test('the worker in Chromium computes what the command computes, for every cloud and family', async ({
  page,
}) => {
  test.setTimeout(limit);
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
  const all = cases();
  const found = await page.evaluate(async (list) => {
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
    let runId = 0;
    const hashOf = async (source: CloudSource, options: RunOptions): Promise<string> => {
      runId += 1;
      await ask({ kind: 'open', runId, source, options });
      for (;;) {
        const event = await ask({ kind: 'fetchDelta', runId });
        if (event.kind !== 'delta') return JSON.stringify(event);
        if (event.delta.state !== 'finished') continue;
        await ask({ kind: 'close', runId });
        return event.delta.hash;
      }
    };
    const hashes: string[] = [];
    for (const { fileName, text, family, sample, options, anyDimension } of list) {
      const bytes = new TextEncoder().encode(text).buffer;
      const source: CloudSource = sample
        ? { kind: 'sample', ...sample }
        : { kind: 'file', name: fileName, bytes, ...(anyDimension && { anyDimension }) };
      hashes.push(await hashOf(source, { family, ...options }));
    }
    worker.terminate();
    return hashes;
  }, all);
  const named = all.map((one, i) => [title(one), found[i]]);
  expect(named).toEqual(all.map((one) => [title(one), commandHash(one)]));
});

test('the module in a worker of Chromium computes the same under every budget', async ({ page }) => {
  test.setTimeout(limit);
  const answer = await page.goto('./?sample=circle-noise&n=50');
  await expect(root(page)).toHaveAttribute('data-run-state', 'finished');
  // Served as the page is, so under the same policy; a worker has the policy of its own answer.
  const policy = answer?.headers()['content-security-policy'] ?? '';
  expect(policy).toContain('worker-src');
  const served = {
    'budget-worker.mjs': new URL('./budget-worker.mjs', import.meta.url),
    'plateau.mjs': new URL('../../build/wasm/bin/plateau.mjs', import.meta.url),
    'plateau.wasm': new URL('../../build/wasm/bin/plateau.wasm', import.meta.url),
  };
  for (const [name, file] of Object.entries(served)) {
    const contentType = name.endsWith('.wasm') ? 'application/wasm' : 'text/javascript';
    const headers = { 'Content-Security-Policy': policy };
    await page.route(`**/parity/${name}`, (route) =>
      route.fulfill({ path: fileURLToPath(file), contentType, headers: { ...headers } }),
    );
  }
  const all = cases();
  const found = await page.evaluate(
    (asked) =>
      new Promise<string[][]>((resolve, reject) => {
        const worker = new Worker(new URL('parity/budget-worker.mjs', location.href), { type: 'module' });
        worker.onmessage = ({ data }: MessageEvent<string[][]>) => resolve(data);
        worker.onerror = ({ message }) => reject(new Error(`the worker failed: ${message}`));
        worker.postMessage(asked);
      }),
    { cases: all, budgets },
  );
  const named = all.map((one, i) => [title(one), ...(found[i] ?? [])]);
  expect(named).toEqual(all.map((one) => [title(one), ...budgets.map(() => commandHash(one))]));
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
