// Scans: large clouds dropped onto the page. Times are printed, not asserted: they are the machine's. What is asserted
// is why they are short: how much a task is given at once, and what is uploaded how often.
import type { Page } from '@playwright/test';
import { expect, root, state, test } from './page.ts';
import { torusFile } from './scan-files.ts';

const FULL = process.env['PLATEAU_FULL'] === '1';
/** As many simplices as the worker gives at once (DELTA_SIMPLICES), and what one step may add to that. */
const MOST_ROWS = 30_000 + 5_000;

interface Seen {
  longTasks: [number, number][];
  /** Simplices and deaths in the largest message from the worker. */
  mostRows: number;
  messages: number;
  /** Arrays of a message that do not own their whole buffer: what is transferred does. */
  sharedBuffers: number;
  /** Buffers of messages to the worker that were copied instead of transferred. */
  copiedFiles: number;
  created: number;
  allocated: number;
  uploads: number;
  uploadedBytes: number;
}

declare global {
  interface Window {
    seen: Seen;
    dropped: File | undefined;
  }
}

test.beforeEach(async ({ page }) => {
  await page.addInitScript(() => {
    const seen: Seen = {
      longTasks: [],
      mostRows: 0,
      messages: 0,
      sharedBuffers: 0,
      copiedFiles: 0,
      created: 0,
      allocated: 0,
      uploads: 0,
      uploadedBytes: 0,
    };
    window.seen = seen;
    new PerformanceObserver((list) => {
      for (const { startTime, duration } of list.getEntries()) seen.longTasks.push([startTime, duration]);
    }).observe({ type: 'longtask' });
    const Original = Worker;
    window.Worker = class extends Original {
      constructor(address: string | URL, options?: WorkerOptions) {
        super(address, options);
        this.addEventListener('message', ({ data }: MessageEvent<{ delta?: Record<string, unknown> }>) => {
          if (!data.delta) return;
          seen.messages += 1;
          const arrays = Object.values(data.delta)
            .flat()
            .filter((each) => ArrayBuffer.isView(each));
          for (const each of arrays) if (each.byteLength !== each.buffer.byteLength) seen.sharedBuffers += 1;
          const length = (key: string): number => (data.delta?.[key] as Uint32Array).length;
          const rows = length('edges') / 2 + length('triangles') / 3 + length('rowFrom');
          seen.mostRows = Math.max(seen.mostRows, rows);
        });
      }
      override postMessage(message: unknown, transfer?: unknown): void {
        super.postMessage(message, transfer as Transferable[]);
        for (const each of (transfer ?? []) as ArrayBuffer[]) if (each.byteLength > 0) seen.copiedFiles += 1;
      }
    };
    const prototype = WebGL2RenderingContext.prototype;
    const count = (
      name: 'createBuffer' | 'bufferData' | 'bufferSubData',
      see: (words: unknown[]) => void,
    ) => {
      // eslint-disable-next-line @typescript-eslint/unbound-method -- applied to its object below
      const original = prototype[name] as (...words: unknown[]) => unknown;
      Object.defineProperty(prototype, name, {
        value(this: WebGL2RenderingContext, ...words: unknown[]) {
          see(words);
          return original.apply(this, words);
        },
      });
    };
    count('createBuffer', () => (seen.created += 1));
    count('bufferData', ([, data]) => {
      seen.allocated += 1;
      seen.uploads += 1;
      seen.uploadedBytes += ArrayBuffer.isView(data) ? data.byteLength : 0;
    });
    count('bufferSubData', ([, , data, , length]) => {
      seen.uploads += 1;
      const bytes = ArrayBuffer.isView(data) ? data.byteLength : 0;
      seen.uploadedBytes += typeof length === 'number' && length > 0 ? 4 * length : bytes;
    });
  });
});

/** Drops the file and waits for its first landmarks; the milliseconds until the source and until they were drawn. */
async function dropScan(page: Page, path: string): Promise<{ read: number; drawn: number }> {
  await page.evaluate(() => {
    const input = document.createElement('input');
    input.type = 'file';
    input.id = 'scan-to-drop';
    input.addEventListener('change', () => (window.dropped = input.files?.[0]));
    document.body.append(input);
  });
  await page.locator('#scan-to-drop').setInputFiles(path);
  return page.evaluate(
    () =>
      new Promise((resolve) => {
        const main = document.querySelector('main');
        if (!main || !window.dropped) throw new Error('nothing to drop');
        document.querySelector('#scan-to-drop')?.remove();
        window.seen.longTasks.length = 0;
        const begin = performance.now();
        let read = 0;
        const watch = new MutationObserver(() => {
          read ||= main.dataset['source'] === window.dropped?.name ? performance.now() - begin : 0;
          if (read === 0 || Number(main.dataset['steps']) === 0) return;
          watch.disconnect();
          requestAnimationFrame(() =>
            requestAnimationFrame(() => resolve({ read, drawn: performance.now() - begin })),
          );
        });
        watch.observe(main, { attributes: true });
        const dataTransfer = new DataTransfer();
        dataTransfer.items.add(window.dropped);
        document.body.dispatchEvent(new DragEvent('drop', { bubbles: true, cancelable: true, dataTransfer }));
      }),
  );
}

const seenBy = (page: Page): Promise<Seen> => page.evaluate(() => window.seen);

function tellTasks(what: string, { longTasks }: Seen): void {
  const longest = Math.max(0, ...longTasks.map(([, duration]) => duration));
  const all = longTasks.map(([at, duration]) => `${Math.round(duration)} at ${Math.round(at / 100) / 10} s`);
  console.log(
    `${what}: ${all.length} tasks over 50 ms, the longest ${Math.round(longest)} ms (${all.join(', ')})`,
  );
}

async function ended(page: Page, runState: string): Promise<void> {
  await expect(root(page)).toHaveAttribute('data-run-state', runState, {
    timeout: FULL ? 1_500_000 : 150_000,
  });
}

test('a scan is drawn at once, stops at its noise, goes on, and is scrubbed without uploads', async ({
  page,
}) => {
  test.setTimeout(FULL ? 3_000_000 : 400_000);
  const size = FULL ? 100_000 : 20_000;
  await page.goto('./?sample=none');
  const { read, drawn } = await dropScan(page, torusFile(size));
  console.log(
    `${size} points: read in ${Math.round(read)} ms, first landmarks after ${Math.round(drawn)} ms`,
  );
  const computing = page.locator('#computing');
  await expect(computing).toContainText(/\d+\sMB in use of about [\d.]+\s[MG]B/);
  const scan = page.locator('#scan');
  await expect(scan).toContainText('Stops at the noise, ε = 0.0');
  await ended(page, 'finished');
  const atNoise = await seenBy(page);
  tellTasks('until the noise', atNoise);
  console.log(`uploaded ${Math.round(atNoise.uploadedBytes / 1e6)} MB in ${atNoise.uploads} parts`);
  const steps = Number(await state(page, 'steps'));
  expect(steps).toBeGreaterThan(size / 2);
  expect(steps).toBeLessThan(size);
  expect(atNoise.messages).toBeGreaterThan(5);
  expect(atNoise.mostRows).toBeLessThan(MOST_ROWS);
  expect(atNoise.sharedBuffers).toBe(0);
  expect(atNoise.copiedFiles).toBe(0);
  // Each buffer is allocated once: what grows gets a new one, and nothing that is there is copied.
  expect(atNoise.allocated).toBeLessThanOrEqual(atNoise.created);

  const slider = page.getByRole('slider', { name: 'Step' });
  const frames = (): Promise<void> =>
    page.evaluate(
      () =>
        new Promise((resolve) =>
          requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(resolve, 100))),
        ),
    );
  const uploads = async (): Promise<number> => (await seenBy(page)).uploads;
  // A picture carries a part of what was gained: the last ones may be on their way.
  await expect(page.locator('#shape')).toHaveAttribute('aria-busy', 'false', {
    timeout: FULL ? 600_000 : 60_000,
  });
  const before = await uploads();
  console.log(`uploaded ${Math.round((await seenBy(page)).uploadedBytes / 1e6)} MB in all`);
  const places = FULL ? 10 : 8;
  for (let place = 0; place <= places; ++place) {
    await slider.fill(String(1 + Math.round(((steps - 1) * place) / places)));
    await frames();
  }
  expect(await uploads()).toBe(before);

  await expect(scan).toContainText('Stopped at the noise');
  await page.getByRole('button', { name: 'Run to the end' }).click();
  await expect(scan).toBeHidden();
  if (FULL) await expect.poll(async () => Number(await state(page, 'steps'))).toBeGreaterThan(steps);
  else {
    await ended(page, 'finished');
    expect(await state(page, 'steps')).toBe(String(size));
  }
});

test('a scan that does not fit is opened, says how far it will go, and keeps what it has', async ({
  page,
}) => {
  test.setTimeout(FULL ? 3_000_000 : 300_000);
  // Large enough to be seen while it runs, also on a fast machine.
  const size = FULL ? 1_000_000 : 40_000;
  const [megabytes, words] = FULL ? [1536, '1.5 GB'] : [120, '120 MB'];
  await page.goto(`./?sample=none&memory=${megabytes}`);
  const { read, drawn } = await dropScan(page, torusFile(size));
  console.log(
    `${size} points: read in ${Math.round(read)} ms, first landmarks after ${Math.round(drawn)} ms`,
  );
  const scan = page.locator('#scan');
  await expect(scan).toContainText(`${size.toLocaleString('en')} points, read in`);
  await expect(scan).toContainText(`The memory of this page (${words}) is enough for about`);
  await expect(scan).toContainText(/landmarks, down to ε ≈ 0\.\d+\./);
  await expect(page.locator('#computing')).toContainText('left');
  await ended(page, 'stopped');
  tellTasks('until the memory was full', await seenBy(page));
  const alert = page.getByRole('alert');
  await expect(alert.first()).toContainText(`of ${size.toLocaleString('en')} landmarks`);
  const steps = Number(await state(page, 'steps'));
  expect(steps).toBeGreaterThan(500);
  await page.getByRole('slider', { name: 'Step' }).fill('400');
  await expect(root(page)).toHaveAttribute('data-step', '400');
  const download = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Betti numbers (CSV)' }).click();
  expect((await download).suggestedFilename()).toContain('betti.csv');
});

test('a small file runs to its end without a word about memory or noise', async ({ page }) => {
  await page.goto('./?sample=none');
  await dropScan(page, torusFile(400));
  await ended(page, 'finished');
  expect(await state(page, 'steps')).toBe('400');
  await expect(page.locator('#scan')).toBeHidden();
});

test('a lost graphics card is told, the diagram goes on, and the shape comes back', async ({ page }) => {
  await page.goto('./?sample=torus&n=200');
  await ended(page, 'finished');
  await page.getByRole('button', { name: 'Pause' }).click();
  await page.evaluate(() => {
    const canvas = document.querySelector<HTMLCanvasElement>('#shape canvas');
    const extension = canvas?.getContext('webgl2')?.getExtension('WEBGL_lose_context');
    if (!extension) throw new Error('the context cannot be lost');
    (window as unknown as { given: WEBGL_lose_context }).given = extension;
    extension.loseContext();
  });
  const words = page.getByText('taken the graphics card away');
  await expect(words).toBeVisible();
  await page.locator('.cards button[data-betti="1,2,1"]').first().click();
  await expect(page.getByRole('status')).toContainText('β 1, 2, 1');
  const before = (await seenBy(page)).allocated;
  await page.evaluate(() => (window as unknown as { given: WEBGL_lose_context }).given.restoreContext());
  await expect(words).toBeHidden();
  // Everything that is drawn is put onto the card anew.
  await expect.poll(async () => (await seenBy(page)).allocated).toBeGreaterThan(before + 3);
});
