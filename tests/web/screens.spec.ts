import type { Page } from '@playwright/test';
import { SAMPLES } from '../../web/src/app/samples.ts';
import { drop, expect, root, test } from './page.ts';
import { torusFile } from './scan-files.ts';

/** Pictures of every state a visitor meets, for people to look at: build/screens. `npm run test:full` takes them all. */
const FOLDER = 'build/screens';
const FULL = process.env['PLATEAU_FULL'] === '1';
const SIZES = {
  desktop: { width: 1280, height: 800 },
  phone: { width: 390, height: 844 },
} as const;

for (const [device, viewport] of Object.entries(SIZES)) {
  const quickly = device === 'desktop' ? 'light' : 'dark';
  for (const colorScheme of FULL ? (['light', 'dark'] as const) : ([quickly] as const)) {
    test(`screens: ${device}, ${colorScheme}`, async ({ page }) => {
      test.setTimeout(180_000);
      await page.setViewportSize(viewport);
      await page.emulateMedia({ colorScheme });
      const take = async (name: string): Promise<void> => {
        await drawn(page);
        await page.screenshot({ path: `${FOLDER}/${device}-${colorScheme}-${name}.png` });
      };
      await page.goto('./?sample=helix&n=800');
      await expect.poll(async () => Number(await root(page).getAttribute('data-step'))).toBeGreaterThan(3);
      await take('first-seconds');
      await expect(root(page)).toHaveAttribute('data-run-state', 'finished', { timeout: 120_000 });
      await page.locator('.cards button[data-betti="1,2,1"]').first().click();
      await take('torus-plateau');
      await page.getByRole('button', { name: 'Why?' }).click();
      await page.getByRole('textbox', { name: 'Landmarks' }).fill('1, 2, 9');
      await page.keyboard.press('Enter');
      await expect(page.getByRole('dialog')).toContainText('landmarks 1, 2 and 9');
      await take('why');
      await page.keyboard.press('Escape');
      if (device === 'desktop') {
        await page.keyboard.press('x');
        await page.keyboard.press('c');
        await page.getByText('Landmarks', { exact: true }).hover();
        await take('section-by-age');
        await page.keyboard.press('x');
        await page.keyboard.press('c');
      }
      await page.locator('.cards button[data-betti="1,1,0"]').first().click();
      await take('curve-plateau');
      await page.getByText('Settings', { exact: true }).click();
      await page.getByRole('textbox', { name: 'ν' }).fill('1,2,3,4');
      await page.getByRole('textbox', { name: 'ν' }).press('Enter');
      await expect(page.getByText('Before: ν 1, 6, 6, 4')).toBeVisible();
      await expect(root(page)).toHaveAttribute('data-run-state', 'finished');
      await take('compared');
      await page.getByText('Settings', { exact: true }).click();
      await drop(page, 'wide.csv', '1,0,0,9\n2,1,0,9\n3,1,1,8\n');
      await expect(page.getByLabel('Which columns')).toBeVisible();
      await take('question');
      await drop(page, 'ragged.xyz', '0 0 0\n1 1 1\n1 0\n');
      await expect(page.getByRole('alert')).toContainText(/line 3/i);
      await take('dropped-error');
      await page.getByRole('button', { name: 'Help' }).click();
      await take('help');
      await page.getByRole('button', { name: 'Close the help' }).click();
      await page.getByRole('button', { name: 'Gallery', exact: true }).click();
      await expect(page.locator('.shape-card canvas[data-drawn]')).toHaveCount(SAMPLES.length);
      await take('gallery');
      await page.goto('./?sample=none');
      await expect(root(page)).toHaveAttribute('data-run-state', 'empty');
      await take('empty');
    });
  }
}

/** The state of a scan: while it runs, and where it has ended. */
for (const [device, viewport] of FULL ? Object.entries(SIZES) : []) {
  test(`screens of a scan: ${device}`, async ({ page }) => {
    test.setTimeout(1_800_000);
    await page.setViewportSize(viewport);
    await page.goto('./?sample=none');
    await page.getByLabel('Open point cloud').setInputFiles(torusFile(100_000));
    const take = async (name: string): Promise<void> => {
      for (const colorScheme of ['light', 'dark'] as const) {
        await page.emulateMedia({ colorScheme });
        await drawn(page);
        await page.screenshot({ path: `${FOLDER}/${device}-${colorScheme}-${name}.png`, timeout: 120_000 });
      }
    };
    await expect(page.locator('#scan')).toContainText('Stops at the noise');
    await expect.poll(async () => Number(await root(page).getAttribute('data-steps'))).toBeGreaterThan(3000);
    await take('scan-running');
    await expect(root(page)).toHaveAttribute('data-run-state', 'finished', { timeout: 1_500_000 });
    await take('scan-at-its-answer');
  });
}

/** What was asked for is on the screen: reading a pixel waits for the card, the pictures after it show what it drew. */
async function drawn(page: Page): Promise<void> {
  await page.evaluate(async () => {
    const twoPictures = () =>
      new Promise<void>((resolve) => requestAnimationFrame(() => requestAnimationFrame(() => resolve())));
    await twoPictures();
    const context = document.querySelector<HTMLCanvasElement>('#shape canvas')?.getContext('webgl2');
    context?.readPixels(0, 0, 1, 1, context.RGBA, context.UNSIGNED_BYTE, new Uint8Array(4));
    await twoPictures();
  });
}
