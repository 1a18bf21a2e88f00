// What every page of the course owes to all readers: no complaints of axe, a small download, paper.
import type { Page } from '@playwright/test';
import { COURSE_FILES } from '../../web/course/pages.ts';
import { complaints } from './axe.ts';
import { expect, test } from './page.ts';

const SIZES = { desktop: { width: 1280, height: 800 }, phone: { width: 390, height: 844 } } as const;
/** `npm run test:full` takes pictures of all pages, for people to look at. */
const FULL = process.env['PLATEAU_FULL'] !== undefined;
const FOLDER = 'build/screens';

async function ready(page: Page, file: string): Promise<void> {
  await page.goto(`./course/${file}.html`);
  for (const sketch of await page.locator('plane-sketch').all())
    await expect(sketch).toHaveAttribute('data-betti', /^\d/);
}

/** With an answer, and with all that is folded. */
async function unfold(page: Page): Promise<void> {
  await page.evaluate(() => {
    const roots: ParentNode[] = [document];
    for (const host of document.querySelectorAll('plane-sketch'))
      if (host.shadowRoot) roots.push(host.shadowRoot);
    for (const root of roots) root.querySelectorAll('details').forEach((details) => (details.open = true));
  });
  const sketch = page.locator('plane-sketch').first();
  if ((await sketch.count()) === 0) return;
  await sketch.evaluate((element) => {
    const inspect = Reflect.get(element, 'inspect') as (vertices: number[]) => void;
    inspect.call(element, [0, 1]);
  });
  await expect(sketch.getByRole('status').first()).not.toBeEmpty();
}

for (const file of COURSE_FILES) {
  test(`axe finds nothing, large and light or small and dark: ${file}`, async ({ page }) => {
    await page.setViewportSize(SIZES.desktop);
    await ready(page, file);
    for (const [device, viewport] of Object.entries(SIZES)) {
      await page.setViewportSize(viewport);
      for (const colorScheme of ['light', 'dark'] as const) {
        await page.emulateMedia({ colorScheme });
        if (FULL) {
          const path = `${FOLDER}/course-${device}-${colorScheme}-${file}.png`;
          await page.screenshot({ path, fullPage: true });
        }
        if (device === 'desktop' && colorScheme === 'light') await unfold(page);
        // Each of both every day, and all of both in the full test.
        if (!FULL && (device === 'desktop') !== (colorScheme === 'light')) continue;
        expect(await complaints(page), `${device}, ${colorScheme}`).toEqual([]);
      }
      const sideways = await page.evaluate(
        () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
      );
      expect(sideways, `${device}: it scrolls sideways`).toBe(0);
    }
  });
}

/** What the figures compute with, once for all pages: the module and its worker; for those in space, the viewer and three.js. */
const CORE = /\.wasm$|\/assets\/(three|views)-[\w-]+\.js$/;

/** Bytes that a page itself takes on a first visit. */
async function bytesOf(page: Page, file: string): Promise<number> {
  const sizes: { url: string; size: Promise<number> }[] = [];
  page.on('requestfinished', (request) => {
    sizes.push({ url: request.url(), size: request.sizes().then((each) => each.responseBodySize) });
  });
  await ready(page, file);
  await page.waitForLoadState('networkidle');
  page.removeAllListeners('requestfinished');
  const workers = page.workers().map((worker) => worker.url());
  const own = sizes.filter(({ url }) => !CORE.test(url) && !workers.includes(url));
  expect(own.some(({ url }) => url.endsWith('.css'))).toBe(true);
  return (await Promise.all(own.map(({ size }) => size))).reduce((sum, size) => sum + size, 0);
}

for (const file of COURSE_FILES) {
  test(`beyond the core a first visit takes at most 60 KB: ${file}`, async ({ page }) => {
    const bytes = await bytesOf(page, file);
    test.info().annotations.push({ type: 'bytes', description: String(bytes) });
    expect(bytes).toBeGreaterThan(10_000);
    expect(bytes).toBeLessThanOrEqual(60_000);
  });
}

test('the next page takes next to nothing', async ({ page }) => {
  await bytesOf(page, 'surfaces');
  const sizes: Promise<number>[] = [];
  page.on('requestfinished', (request) => {
    if (request.url().endsWith('.wasm')) return;
    sizes.push(request.sizes().then((each) => each.responseBodySize));
  });
  await ready(page, 'plateaus');
  await page.waitForLoadState('networkidle');
  const next = (await Promise.all(sizes)).reduce((sum, size) => sum + size, 0);
  expect(next).toBeGreaterThan(1_000);
  expect(next).toBeLessThanOrEqual(10_000);
});

test('on paper there are figures and questions, and no buttons or hints', async ({ page }) => {
  await ready(page, 'witnesses');
  await page.emulateMedia({ media: 'print' });
  await expect(page.locator('#first svg.board')).toBeVisible();
  await expect(page.locator('form.task').first()).toBeVisible();
  for (const hidden of ['form.task details', 'form.task .button', '.pages', '.figure-link'])
    await expect(page.locator(hidden).first()).toBeHidden();
  await expect(page.locator('#first').getByRole('button', { name: 'Undo' })).toBeHidden();
});

/** Whether a picture was drawn, and not an empty one. */
function hasInk(canvas: HTMLCanvasElement): boolean {
  const { width, height } = canvas;
  const pixels = canvas.getContext('2d')?.getImageData(0, 0, width, height).data ?? [];
  return pixels.some((value) => value > 0);
}

test('on paper a figure in space is the picture drawn last, in view or not; one never opened says so', async ({
  page,
}) => {
  await ready(page, 'surfaces');
  const [torus, tanglecube] = [page.locator('#torus'), page.locator('#tanglecube')];
  await torus.scrollIntoViewIfNeeded();
  await expect(torus.locator('.view')).toHaveAttribute('data-run-state', 'finished');
  await expect(torus.locator('.shape')).toHaveAttribute('aria-busy', 'false');
  // A browser tells the page, and then asks it for its look on paper.
  const print = async (): Promise<void> => {
    await page.evaluate(() => dispatchEvent(new Event('beforeprint')));
    await page.emulateMedia({ media: 'print' });
  };
  await print();
  await expect(torus.locator('.still')).toBeVisible();
  expect(await torus.locator('.still').evaluate(hasInk)).toBe(true);
  await expect(torus.getByRole('button')).toHaveCount(0);
  await expect(torus.locator('.readout')).toBeVisible();
  await expect(page.locator('figcaption.choices')).toBeHidden();
  await expect(tanglecube.getByText('Open this figure first, then print.')).toBeVisible();
  await page.emulateMedia({ media: 'screen' });
  await expect(torus.locator('.still')).toBeHidden();
  await expect(tanglecube.getByText('Open this figure first, then print.')).toBeHidden();
  await tanglecube.scrollIntoViewIfNeeded();
  await expect(torus.locator('.shape canvas')).toHaveCount(0);
  await print();
  await expect(torus.locator('.still')).toBeVisible();
  expect(await torus.locator('.still').evaluate(hasInk)).toBe(true);
});
