import type { Locator, Page } from '@playwright/test';
import { expect, openPaused, root, test } from './page.ts';

test.use({ viewport: { width: 1000, height: 700 } });

const sheet = (page: Page): Locator => page.getByRole('dialog', { name: 'Why?' });
const landmarks = (page: Page): Locator => page.getByRole('textbox', { name: 'Landmarks, by their steps' });
const marks = (page: Page, kind: string): Locator => page.locator(`.why-marks .${kind}`);

async function toStep(page: Page, step: number): Promise<void> {
  await page.getByRole('slider', { name: 'Step' }).fill(String(step));
  await expect(root(page)).toHaveAttribute('data-step', String(step));
}

test('by keyboard: opened, asked, closed', async ({ page }) => {
  await openPaused(page, 'torus', 120);
  await toStep(page, 60);
  await page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur());
  await page.keyboard.press('i');
  await expect(landmarks(page)).toBeFocused();
  await expect(landmarks(page)).toHaveValue('60');
  await expect(sheet(page)).toContainText('Landmark 60 is in the complex at step 60.');
  await expect(marks(page, 'asked')).toHaveCount(1);
  expect(await marks(page, 'sees').count()).toBeGreaterThan(0);
  await page.keyboard.type('3, 90');
  await page.keyboard.press('Enter');
  await expect(sheet(page)).toContainText('Landmark 90 comes later.');
  await expect(marks(page, 'sees')).toHaveCount(0);
  await landmarks(page).fill('1, x');
  await page.keyboard.press('Enter');
  await expect(sheet(page)).toContainText('Landmarks takes whole numbers from 1 on');
  await landmarks(page).fill('1, 2');
  await page.keyboard.press('Enter');
  await expect(sheet(page)).toContainText('The edge of landmarks 1 and 2');
  await page.keyboard.press('Escape');
  await expect(sheet(page)).toBeHidden();
  await expect(marks(page, 'asked')).toHaveCount(0);
  await expect(page.getByRole('button', { name: 'Why?' })).toBeFocused();
});

test('the answer follows the playhead and the run', async ({ page }) => {
  await openPaused(page, 'torus', 120);
  await toStep(page, 40);
  await page.getByRole('button', { name: 'Why?' }).click();
  await landmarks(page).fill('40');
  await page.keyboard.press('Enter');
  await expect(sheet(page)).toContainText('at step 40.');
  // The film goes on beside the sheet, by its keys, too.
  await page.getByRole('slider', { name: 'Step' }).focus();
  await page.keyboard.press('ArrowLeft');
  await expect(sheet(page)).toContainText('at step 39. Landmark 40 comes later.');
  await page.getByRole('button', { name: 'Close the answer' }).click();
  await expect(sheet(page)).toBeHidden();
});

/** Where a landmark is: in the ring that the sheet draws around it. */
async function ringOf(page: Page, landmark: number): Promise<{ x: number; y: number }> {
  await landmarks(page).fill(String(landmark));
  await landmarks(page).press('Enter');
  await expect(sheet(page)).toContainText(`Landmark ${landmark} is`);
  const ring = marks(page, 'asked');
  await expect(ring).toBeVisible();
  // It is drawn anew with every picture of the shape.
  let place = { x: 0, y: 0 };
  await expect(async () => {
    const { x, y, width, height } = (await ring.boundingBox()) ?? { x: 0, y: 0, width: 0, height: 0 };
    expect(width).toBeGreaterThan(0);
    place = { x: x + width / 2, y: y + height / 2 };
  }).toPass();
  return place;
}

test('by mouse: a landmark, another one with shift, nothing beside the shape', async ({ page }) => {
  // In the plane nothing hides what is behind it.
  await openPaused(page, 'circle-noise', 150);
  await toStep(page, 30);
  await page.getByRole('button', { name: 'Why?' }).click();
  const seven = await ringOf(page, 7);
  const twelve = await ringOf(page, 12);
  await page.mouse.click(seven.x, seven.y);
  await expect(sheet(page)).toContainText('Landmark 7 is in the complex');
  await page.keyboard.down('Shift');
  await page.mouse.click(twelve.x, twelve.y);
  await page.keyboard.up('Shift');
  await expect(landmarks(page)).toHaveValue('7, 12');
  await expect(sheet(page)).toContainText('The edge of landmarks 7 and 12');
  await expect(marks(page, 'asked')).toHaveCount(2);
  // A drag moves the shape and asks nothing.
  await page.mouse.move(seven.x, seven.y);
  await page.mouse.down();
  await page.mouse.move(seven.x + 40, seven.y + 20, { steps: 3 });
  await page.mouse.up();
  await expect(landmarks(page)).toHaveValue('7, 12');
});

test.describe('by finger', () => {
  test.use({ hasTouch: true });

  test('a landmark, and another one once Add is ticked; closed, it begins afresh', async ({ page }) => {
    await openPaused(page, 'circle-noise', 150);
    await toStep(page, 30);
    await page.getByRole('button', { name: 'Why?' }).tap();
    const seven = await ringOf(page, 7);
    const twelve = await ringOf(page, 12);
    await page.touchscreen.tap(seven.x, seven.y);
    await expect(landmarks(page)).toHaveValue('7');
    await page.getByLabel('Add to the question').tap();
    await page.touchscreen.tap(twelve.x, twelve.y);
    await expect(landmarks(page)).toHaveValue('7, 12');
    await expect(sheet(page)).toContainText('The edge of landmarks 7 and 12');
    await page.touchscreen.tap(seven.x, seven.y);
    await expect(landmarks(page)).toHaveValue('12');
    await page.getByRole('button', { name: 'Close the answer' }).tap();
    await page.getByRole('button', { name: 'Why?' }).tap();
    await expect(page.getByLabel('Add to the question')).not.toBeChecked();
  });
});

test('by mouse: what is clicked on a surface lies on it', async ({ page }) => {
  await openPaused(page, 'torus', 400);
  await toStep(page, 120);
  const box = await page.locator('#shape').boundingBox();
  if (!box) throw new Error('no shape');
  // In front of the middle of the tube, somewhere to the left.
  for (let x = 0.2; x < 0.5 && !(await sheet(page).isVisible()); x += 0.03) {
    await page.mouse.click(box.x + box.width * x, box.y + box.height * 0.55);
  }
  await expect(sheet(page)).toContainText('It is on the surface.');
  await expect(landmarks(page)).toHaveValue(/^\d+(, \d+){0,2}$/);
});
