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

test('a page of the course downloads little beyond the core, the next one next to nothing', async ({
  page,
}) => {
  /** The module, its worker, and what figures in space are made of: the page of Plateau has them, too. */
  const core = /\.wasm$|\/assets\/(three|views)-[\w-]+\.js$/;
  const load = async (file: string): Promise<number> => {
    const sizes: { url: string; size: Promise<number> }[] = [];
    page.on('requestfinished', (request) => {
      sizes.push({ url: request.url(), size: request.sizes().then((each) => each.responseBodySize) });
    });
    await ready(page, file);
    await page.waitForLoadState('networkidle');
    page.removeAllListeners('requestfinished');
    const workers = page.workers().map((worker) => worker.url());
    expect(workers).toHaveLength(1);
    const own = sizes.filter(({ url }) => !core.test(url) && !workers.includes(url));
    expect(own.some(({ url }) => url.endsWith('.css'))).toBe(true);
    return (await Promise.all(own.map(({ size }) => size))).reduce((sum, size) => sum + size, 0);
  };
  const first = await load('surfaces');
  expect(first).toBeGreaterThan(10_000);
  expect(first).toBeLessThanOrEqual(60_000);
  const next = await load('plateaus');
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
