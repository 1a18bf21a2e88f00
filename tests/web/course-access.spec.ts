// What every page of the course owes to all readers: no complaints of axe, a small download, paper.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import type { Page } from '@playwright/test';
import { COURSE_PAGES } from '../../web/course/pages.ts';
import { expect, test } from './page.ts';

const AXE = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
const FILES = ['index', 'sketch', ...COURSE_PAGES.map(({ file }) => file)];
const SIZES = { desktop: { width: 1280, height: 800 }, phone: { width: 390, height: 844 } } as const;
/** Pictures for people to look at. */
const FOLDER = 'build/screens';

async function complaints(page: Page): Promise<string[]> {
  // Through the debugger: the policy of the page allows no script of others.
  await page.evaluate(AXE);
  return page.evaluate(async () => {
    const { axe } = window as unknown as {
      axe: { run(): Promise<{ violations: { id: string; nodes: { html: string }[] }[] }> };
    };
    const { violations } = await axe.run();
    return violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html).join(' ')}`);
  });
}

async function ready(page: Page, file: string): Promise<void> {
  await page.goto(`./course/${file}.html`);
  for (const sketch of await page.locator('plane-sketch').all())
    await expect(sketch).toHaveAttribute('data-betti', /^\d/);
}

for (const [device, viewport] of Object.entries(SIZES)) {
  for (const colorScheme of ['light', 'dark'] as const) {
    test(`axe finds nothing in the course: ${device}, ${colorScheme}`, async ({ page }) => {
      test.setTimeout(150_000);
      await page.setViewportSize(viewport);
      await page.emulateMedia({ colorScheme });
      for (const file of FILES) {
        await ready(page, file);
        const sketch = page.locator('plane-sketch').first();
        if ((await sketch.count()) > 0) {
          // With an answer, a mark and all that is folded.
          await page.evaluate(() => {
            const roots: ParentNode[] = [document];
            for (const host of document.querySelectorAll('plane-sketch'))
              if (host.shadowRoot) roots.push(host.shadowRoot);
            for (const root of roots)
              root.querySelectorAll('details').forEach((details) => (details.open = true));
          });
          await sketch.evaluate((element) =>
            Reflect.apply(Reflect.get(element, 'inspect') as () => void, element, [[0, 1]]),
          );
          await expect(sketch.getByRole('status').first()).not.toBeEmpty();
        }
        expect(await complaints(page), file).toEqual([]);
        await page.screenshot({
          path: `${FOLDER}/course-${device}-${colorScheme}-${file}.png`,
          fullPage: true,
        });
        expect(
          await page.evaluate(
            () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
          ),
          `${file} scrolls sideways`,
        ).toBe(0);
      }
    });
  }
}

test('a page of the course downloads little beyond the core', async ({ page }) => {
  /** The module, its worker, and what figures in space are made of: the page of Plateau has them, too. */
  const core = /\.wasm$|\/assets\/(transport|views)-[\w-]+\.js$/;
  for (const file of ['voronoi', 'surfaces']) {
    const sizes: [string, Promise<number>][] = [];
    page.on('requestfinished', (request) => {
      sizes.push([request.url(), request.sizes().then(({ responseBodySize }) => responseBodySize)]);
    });
    await ready(page, file);
    await page.waitForLoadState('networkidle');
    page.removeAllListeners('requestfinished');
    const loaded = await Promise.all(sizes.map(async ([url, size]) => ({ url, size: await size })));
    const workers = page.workers().map((worker) => worker.url());
    expect(workers).toHaveLength(1);
    const own = loaded.filter(({ url }) => !core.test(url) && !workers.includes(url));
    const bytes = own.reduce((sum, { size }) => sum + size, 0);
    console.log(
      `${file}: ${bytes} bytes`,
      own.map(({ url, size }) => `${url.replace(/.*\//, '')} ${size}`).join(', '),
    );
    expect(bytes).toBeGreaterThan(5_000);
    expect(bytes).toBeLessThanOrEqual(60_000);
  }
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
