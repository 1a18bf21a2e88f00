import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import type { Page } from '@playwright/test';
import { drop, expect, openPaused, root, state, test } from './page.ts';

const AXE = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

/** What axe finds, best practices included. */
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

const SIZES = { desktop: { width: 1280, height: 720 }, phone: { width: 390, height: 844 } } as const;

for (const [device, viewport] of Object.entries(SIZES)) {
  for (const colorScheme of ['light', 'dark'] as const) {
    test(`axe finds nothing in any state: ${device}, ${colorScheme}`, async ({ page }) => {
      test.setTimeout(150_000);
      await page.setViewportSize(viewport);
      await page.emulateMedia({ colorScheme });
      const clean = async (what: string): Promise<void> => expect(await complaints(page), what).toEqual([]);
      await page.goto('./?sample=none');
      await expect(root(page)).toHaveAttribute('data-run-state', 'empty');
      await clean('empty');
      await page.goto('./?sample=torus&n=300');
      await expect(page.getByRole('button', { name: 'Pause' })).toBeVisible();
      await clean('playing');
      await openPaused(page, 'torus', 250);
      await page.locator('.cards button[data-betti="1,2,1"]').first().click();
      await clean('at a plateau');
      await page.keyboard.press('x');
      await page.keyboard.press('c');
      await page.getByText('Settings', { exact: true }).click();
      await page.getByRole('textbox', { name: 'ν' }).fill('1,2,3,4');
      await page.getByRole('textbox', { name: 'ν' }).press('Enter');
      await expect(page.getByText('Before: ν 1, 6, 6, 4')).toBeVisible();
      await expect(root(page)).toHaveAttribute('data-run-state', 'finished');
      await clean('settings, section, by age, compared');
      await drop(page, 'wide.csv', '1,0,0,9\n2,1,0,9\n3,1,1,8\n');
      await expect(page.getByLabel('Which columns')).toBeVisible();
      await clean('error and question');
      for (const key of ['g', '?', 'i']) {
        await page.locator('h1').click();
        await page.keyboard.press(key);
        await expect(page.getByRole('dialog')).toBeVisible();
        await clean(`sheet ${key}`);
        await page.keyboard.press('Escape');
      }
    });
  }
}

test('one status, that speaks when the visitor moves; the film tells plateaus and no steps', async ({
  page,
}) => {
  await page.goto('./?sample=torus&n=250');
  const status = page.getByRole('status');
  await expect(status).toHaveCount(1);
  await expect(page.getByRole('button', { name: 'Pause' })).toBeVisible();
  await expect(status).toHaveAttribute('aria-live', 'off');
  const spoken = page.locator('#spoken');
  await expect(spoken).toHaveAttribute('aria-live', 'polite');
  await page.keyboard.press('Space');
  await expect(status).toHaveAttribute('aria-live', 'polite');
  await expect(root(page)).toHaveAttribute('data-run-state', 'finished');

  const said = page.evaluate(() => {
    const texts: string[] = [];
    const element = document.getElementById('spoken');
    if (element)
      new MutationObserver(() => texts.push(element.textContent)).observe(element, { childList: true });
    return new Promise<string[]>((done) =>
      document.addEventListener('visited', () => done(texts), { once: true }),
    );
  });
  await page.getByLabel('Speed').selectOption('4');
  await page.keyboard.press('Home');
  await page.locator('h1').click();
  await page.keyboard.press('Space');
  await expect(page.getByRole('button', { name: 'Pause' })).toBeVisible();
  await expect.poll(async () => Number(await state(page, 'step'))).toBe(250);
  await page.evaluate(() => document.dispatchEvent(new Event('visited')));
  const texts = await said;
  expect(texts.length).toBeGreaterThan(0);
  for (const text of texts) expect(text).toMatch(/^Plateau: .+: \d+ components?.*, ε \S+ → \S+$/);
  expect(texts.join()).not.toMatch(/step/);
  expect(texts.length).toBeLessThan(20);
});

test('at once when the playhead is moved by hand', async ({ page }) => {
  await openPaused(page, 'torus', 120);
  await page.getByRole('slider', { name: 'Step' }).fill('2');
  // All in one task: nothing waits for the next second.
  const texts = await page.evaluate(() => {
    const button = document.getElementById('forward');
    return Array.from({ length: 20 }, () => {
      button?.click();
      return document.querySelector('[role=status]')?.textContent ?? '';
    });
  });
  texts.forEach((text, i) =>
    expect(text).toMatch(new RegExp(`^step ${3 + i} of 120 · ε \\S+ · β \\d+, \\d+, \\d+ `)),
  );
});

test('what glows is gone when the film stands still, and never there for who asked for less motion', async ({
  page,
}) => {
  await page.addInitScript(() => {
    const recent = new WeakSet<WebGLUniformLocation>();
    const steps = new WeakSet<WebGLUniformLocation>();
    const watched = window as unknown as { behind: number[]; shownStep: number };
    watched.behind = [];
    const prototype = WebGL2RenderingContext.prototype;
    // eslint-disable-next-line @typescript-eslint/unbound-method -- applied to its object below
    const { getUniformLocation, uniform1f, uniform1ui } = prototype;
    prototype.getUniformLocation = function (program, name) {
      const place = getUniformLocation.call(this, program, name);
      if (place && name === 'uRecent') recent.add(place);
      if (place && name === 'uStep') steps.add(place);
      return place;
    };
    prototype.uniform1ui = function (place, value) {
      if (place && steps.has(place)) watched.shownStep = value;
      uniform1ui.call(this, place, value);
    };
    prototype.uniform1f = function (place, value) {
      if (place && recent.has(place)) watched.behind.push(value);
      uniform1f.call(this, place, value);
    };
  });
  const behind = (): Promise<number[]> =>
    page.evaluate(() => (window as unknown as { behind: number[] }).behind.splice(0));
  const play = async (): Promise<void> => {
    await page.getByRole('slider', { name: 'Step' }).fill('30');
    await behind();
    await page.getByRole('button', { name: 'Play' }).click();
    await expect.poll(async () => Number(await state(page, 'step'))).toBeGreaterThan(36);
    await page.getByRole('button', { name: 'Pause' }).click();
    await page.evaluate(
      () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))),
    );
  };
  await openPaused(page, 'torus', 200);
  await play();
  const values = await behind();
  expect(values.some((value) => !Number.isInteger(value))).toBe(true);
  expect(values.at(-1)).toBe(Number(await state(page, 'step')));
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await play();
  const calm = await behind();
  expect(calm.length).toBeGreaterThan(0);
  expect(calm.filter((value) => !Number.isInteger(value))).toEqual([]);
});

test('new simplices are seen to glow', async ({ page }) => {
  await page.clock.install();
  await openPaused(page, 'torus', 100);
  const picture = async (): Promise<string> => (await page.locator('#shape').screenshot()).toString('base64');
  await page.getByRole('slider', { name: 'Step' }).fill('12');
  await page.clock.pauseAt(new Date(Date.now() + 60_000));
  await page.getByRole('button', { name: 'Play' }).click();
  await page.clock.runFor(400);
  await expect(root(page)).toHaveAttribute('data-step', '13');
  const glowing = await picture();
  await page.getByRole('button', { name: 'Pause' }).click();
  await page.clock.runFor(100);
  await expect(root(page)).toHaveAttribute('data-step', '13');
  expect(await picture()).not.toBe(glowing);
});
