import type { Page } from '@playwright/test';
import { complaints } from './axe.ts';
import { expect, openPaused, openSample, root, state, test } from './page.ts';

declare global {
  interface Window {
    uploads: number;
    started: Worker[];
  }
}

test('the page works under a strict policy and forbids evaluation', async ({ page }) => {
  const response = await page.goto('./?sample=torus&n=100');
  const policy = response?.headers()['content-security-policy'] ?? '';
  expect(policy).toContain("default-src 'self'");
  expect(policy).toContain("script-src 'self' 'wasm-unsafe-eval'");
  expect(policy).not.toMatch(/'unsafe-(inline|eval)'/);
  await expect(root(page)).toHaveAttribute('data-run-state', 'finished');
  const html = (await response?.text()) ?? '';
  expect(html).not.toMatch(/ style=|<style|<script(?![^>]*src=)/);
});

test('scrubbing uploads no geometry', async ({ page }) => {
  await page.addInitScript(() => {
    window.uploads = 0;
    const prototype = WebGL2RenderingContext.prototype;
    for (const name of [
      'bufferData',
      'bufferSubData',
      'texImage2D',
      'texSubImage2D',
      'texStorage2D',
    ] as const) {
      // eslint-disable-next-line @typescript-eslint/unbound-method -- applied to its object below
      const original = prototype[name] as (...words: unknown[]) => void;
      Object.defineProperty(prototype, name, {
        value(this: WebGL2RenderingContext, ...words: unknown[]) {
          window.uploads += 1;
          original.apply(this, words);
        },
      });
    }
  });
  await openPaused(page, 'torus', 200);
  // Every layer is drawn once before counting: what is drawn for the first time is uploaded then.
  const slider = page.getByRole('slider', { name: 'Step' });
  const drawn = (): Promise<void> =>
    page.evaluate(
      () => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(() => resolve()))),
    );
  for (const step of ['30', '60', '200', '3']) {
    await slider.fill(step);
    await drawn();
  }
  const before = await page.evaluate(() => window.uploads);
  expect(before).toBeGreaterThan(0);
  for (let step = 5; step <= 200; step += 13) {
    await slider.fill(String(step));
    await drawn();
  }
  expect(await page.evaluate(() => window.uploads)).toBe(before);
});

async function keepWorkers(page: Page): Promise<void> {
  await page.addInitScript(() => {
    window.started = [];
    const Original = Worker;
    window.Worker = class extends Original {
      constructor(address: string | URL, options?: WorkerOptions) {
        super(address, options);
        window.started.push(this);
      }
    };
  });
}

test('when the worker dies the picture stays, and the next file starts a fresh one', async ({ page }) => {
  await keepWorkers(page);
  await openPaused(page, 'torus', 150);
  await page.evaluate(() => {
    const worker = window.started[0];
    worker?.terminate();
    worker?.dispatchEvent(new ErrorEvent('error', { message: 'out of memory' }));
  });
  const alert = page.getByRole('alert');
  await expect(alert).toContainText('out of memory');
  await page.getByRole('slider', { name: 'Step' }).fill('77');
  await expect(root(page)).toHaveAttribute('data-step', '77');
  await page.getByRole('button', { name: 'Betti numbers (CSV)' }).click();
  await expect(alert).toContainText('not open');
  await page.getByLabel('Sample').selectOption({ label: 'Noisy circle' });
  await expect(root(page)).toHaveAttribute('data-source', 'circle-noise');
  await expect(alert).toBeHidden();
  expect(await page.evaluate(() => window.started.length)).toBe(2);
});

test('a worker that dies while it computes is told, and what was computed stays', async ({ page }) => {
  await keepWorkers(page);
  await page.goto('./');
  await expect.poll(async () => Number(await state(page, 'steps'))).toBeGreaterThan(20);
  await page.evaluate(() => {
    window.started[0]?.dispatchEvent(new ErrorEvent('error', { message: 'out of memory' }));
  });
  await expect(page.getByRole('alert')).toContainText('out of memory');
  await expect(root(page)).toHaveAttribute('data-run-state', 'stopped');
  await page.getByRole('slider', { name: 'Step' }).fill('10');
  await expect(root(page)).toHaveAttribute('data-step', '10');
});

test('a large file can be replaced before it is computed', async ({ page }) => {
  await page.goto('./?sample=tanglecube&n=15000');
  await expect(root(page)).toHaveAttribute('data-source', 'tanglecube');
  await page.getByLabel('Sample').selectOption({ label: 'Swiss roll' });
  await page.getByLabel('Sample').selectOption({ label: 'Curve with corners' });
  await expect(root(page)).toHaveAttribute('data-source', 'corner-curve');
  await expect(root(page)).toHaveAttribute('data-run-state', 'finished');
  await expect(page.getByRole('alert')).toBeHidden();
});

test('without WebGL the page says so, and the rest works', async ({ page }) => {
  await page.addInitScript(() => {
    // eslint-disable-next-line @typescript-eslint/unbound-method -- called on its object below
    const original = HTMLCanvasElement.prototype.getContext as (kind: string, ...words: unknown[]) => unknown;
    Object.defineProperty(HTMLCanvasElement.prototype, 'getContext', {
      value(this: HTMLCanvasElement, kind: string, ...words: unknown[]) {
        return kind.startsWith('webgl') ? null : original.call(this, kind, ...words);
      },
    });
    // The renderer also complains to the console; that is expected here.
    console.error = () => undefined;
  });
  await openSample(page, 'torus', 250);
  await expect(page.getByText('The shape needs WebGL 2')).toBeVisible();
  await page.locator('.cards button[data-betti="1,2,1"]').first().click();
  await expect(page.getByRole('status')).toContainText('β 1, 2, 1');
  // Two runs are compared by their diagrams and numbers.
  await page.getByRole('button', { name: 'Compare', exact: true }).click();
  await page.getByRole('dialog').getByRole('button', { name: 'Compare', exact: true }).click();
  await expect(page.getByText('The shape needs WebGL 2').filter({ visible: true })).toHaveCount(2);
  await expect(page.getByRole('status')).toContainText(/A: step \d+ of 250 .* B: step \d+ of 250/);
  await expect(page.getByRole('checkbox', { name: 'Turn both' })).toHaveCount(0);
});

test('more points than the card has room for are computed without a picture', async ({ page }) => {
  await page.addInitScript(() => {
    const original = Reflect.get(WebGL2RenderingContext.prototype, 'getParameter') as (
      name: number,
    ) => unknown;
    Object.defineProperty(WebGL2RenderingContext.prototype, 'getParameter', {
      value(this: WebGL2RenderingContext, name: number) {
        return name === this.MAX_TEXTURE_SIZE ? 1 : original.call(this, name);
      },
    });
  });
  await openSample(page, 'torus', 2100);
  await expect(page.getByText('more points than this graphics card has room for')).toBeVisible();
  await page.locator('.cards button[data-betti="1,2,1"]').first().click();
  await expect(page.getByRole('status')).toContainText('β 1, 2, 1');
  await openSample(page, 'torus', 300);
  await expect(page.getByText('more points than this graphics card has room for')).toBeHidden();
});

test('nothing sticks out of a phone', async ({ page }) => {
  await page.setViewportSize({ width: 390, height: 844 });
  await openPaused(page, 'torus', 120);
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(390);
  for (const name of ['Betti numbers (CSV)', 'Mesh (PLY)', 'Diagram (SVG)', 'Play', 'Step', 'Back']) {
    await expect(page.getByRole('button', { name, exact: true })).toBeVisible();
  }
});

for (const colorScheme of ['light', 'dark'] as const) {
  test(`axe finds nothing to complain about: ${colorScheme}`, async ({ page }) => {
    await page.emulateMedia({ colorScheme });
    await openPaused(page, 'torus', 120);
    expect(await complaints(page)).toEqual([]);
    await page.getByText('Settings', { exact: true }).click();
    await page.keyboard.press('x');
    await page.keyboard.press('c');
    expect(await complaints(page)).toEqual([]);
    for (const key of ['g', '?']) {
      await page.keyboard.press(key);
      await expect(page.getByRole('dialog')).toBeVisible();
      expect(await complaints(page)).toEqual([]);
      await page.keyboard.press('Escape');
    }
  });
}

test('the licences are text without an icon of its own, and the browser finds one', async ({ page }) => {
  await page.goto('./licences.txt');
  // It asks for this one, and complains where there is none.
  const icon = await page.request.get('./favicon.ico');
  expect(icon.headers()['content-type']).toBe('image/x-icon');
  expect((await icon.body()).readUInt16LE(2)).toBe(1);
});
