// The first visit, and those after it: what is downloaded, how soon something is seen, and that no network is needed.
import { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import type { Server } from 'node:http';
import type { Socket } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Page } from '@playwright/test';
import { pageFiles, writeServiceWorker } from '../../scripts/lib/offline.mjs';
import { serve } from '../../scripts/serve.mjs';
import { expect, root, state, test } from './page.ts';

test.use({ serviceWorkers: 'allow' });

let folder: string;
let server: Server;
let address: string;
let sockets: Socket[];

test.beforeEach(async () => {
  folder = mkdtempSync(join(tmpdir(), 'plateau-page-'));
  cpSync('web/dist', folder, { recursive: true });
  ({ server, address } = await serve(folder, { port: 0 }));
  sockets = [];
  server.on('connection', (socket) => sockets.push(socket));
});
test.afterEach(() => {
  server.closeAllConnections();
  server.close();
  rmSync(folder, { recursive: true });
});

const sent = (): number => sockets.reduce((sum, socket) => sum + socket.bytesWritten, 0);

/** Until every file of the page is kept; their number. */
async function kept(page: Page): Promise<number> {
  await page.evaluate(() => navigator.serviceWorker.ready.then(() => undefined));
  await page.waitForFunction(() => navigator.serviceWorker.controller !== null);
  return page.evaluate(async () => {
    const names = await caches.keys();
    if (names.length !== 1) throw new Error(`${names.length} caches`);
    return (await (await caches.open(names[0] ?? '')).keys()).length;
  });
}

test('the first visit downloads at most a megabyte, and soon shows something', async ({ page }) => {
  await page.goto(address);
  await expect.poll(() => state(page, 'step')).not.toBe('0');
  const drawn = await page.evaluate(
    () =>
      new Promise<number>((resolve) =>
        requestAnimationFrame(() => requestAnimationFrame(() => resolve(performance.now()))),
      ),
  );
  const painted = await page.evaluate(
    () => performance.getEntriesByName('first-contentful-paint')[0]?.startTime ?? NaN,
  );
  expect(await kept(page)).toBe(pageFiles(folder).length);
  const bytes = sent();
  console.log(
    `first visit: ${Math.round(bytes / 1000)} kB sent, first paint after ${Math.round(painted)} ms, ` +
      `first landmark drawn within ${Math.round(drawn)} ms of navigation`,
  );
  expect(bytes).toBeLessThanOrEqual(1_000_000);
  // The second visit: nothing but questions whether it is still so.
  await page.goto(address);
  await expect.poll(() => state(page, 'step')).not.toBe('0');
  expect(sent() - bytes).toBeLessThan(20_000);
});

test('after the first visit no network is needed', async ({ page, context }) => {
  await page.goto(`${address}?sample=torus&n=150`);
  await expect(root(page)).toHaveAttribute('data-run-state', 'finished');
  await kept(page);
  const hash = await state(page, 'hash');
  await context.setOffline(true);
  server.closeAllConnections();
  server.close();
  await page.reload();
  await expect(root(page)).toHaveAttribute('data-run-state', 'finished');
  expect(await state(page, 'hash')).toBe(hash);
  // Another address of the same page, and what is loaded only when it is asked for.
  await page.goto(address);
  await expect.poll(async () => Number(await state(page, 'step'))).toBeGreaterThan(3);
  await page.getByLabel('Sample').selectOption({ label: 'Stanford bunny' });
  await expect(root(page)).toHaveAttribute('data-source', 'bunny');
  // The course came along.
  for (const name of ['', 'witnesses.html']) {
    await page.goto(`${address}course/${name}`);
    await expect(page.locator('h1')).toHaveText(name === '' ? /course/ : '2. Witnesses and landmarks');
  }
  await expect(page.locator('#first')).toHaveAttribute('data-betti', '1,0');
});

test('a new build is shown at once and replaces what was kept', async ({ page }) => {
  await page.goto(`${address}?sample=none`);
  await kept(page);
  const names = (): Promise<string[]> => page.evaluate(() => caches.keys());
  const [old = ''] = await names();
  // A copy of Plateau elsewhere on the server keeps what is its own.
  await page.evaluate(() => caches.open('plateau http://elsewhere/ 1').then(() => undefined));
  const index = join(folder, 'index.html');
  writeFileSync(index, readFileSync(index, 'utf8').replace('<title>Plateau</title>', '<title>Newer</title>'));
  writeServiceWorker(folder);
  await page.reload();
  await expect(page).toHaveTitle('Newer');
  await expect.poll(async () => (await names()).includes(old)).toBe(false);
  expect(await names()).toHaveLength(2);
  expect(await names()).toContain('plateau http://elsewhere/ 1');
});
