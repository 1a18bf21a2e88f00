import { SAMPLES } from '../../web/src/app/samples.ts';
import { drop, expect, openPaused, openSample, root, shown, state, test, torusText } from './page.ts';

test.describe('what is drawn', () => {
  test.beforeEach(async ({ page }) => {
    await openPaused(page, 'torus', 150);
  });

  test('layers, color, section and axis by keyboard alone', async ({ page }) => {
    const layers = ['Witnesses', 'Landmarks', 'Edges', 'Faces'];
    for (const [index, name] of layers.entries()) {
      const box = page.getByRole('checkbox', { name });
      await expect(box).toBeChecked();
      await page.keyboard.press(String(index + 1));
      await expect(box).not.toBeChecked();
      await box.press('Space');
      await expect(box).toBeChecked();
    }
    await page.keyboard.press('c');
    await expect(page.getByLabel('Color')).toHaveValue('age');
    await page.keyboard.press('x');
    await expect(page.getByRole('checkbox', { name: 'Section' })).toBeChecked();
    const place = page.getByRole('slider', { name: 'Section place' });
    const step = await state(page, 'step');
    await place.press('ArrowRight');
    await expect(place).toHaveValue('0.01');
    expect(await state(page, 'step')).toBe(step);
    await page.keyboard.press('l');
    await expect(page.getByLabel('Axis of 1/ε')).toHaveValue('linear');
  });

  test('each layer changes the picture', async ({ page }) => {
    await page.locator('.cards button[data-betti="1,2,1"]').first().click();
    const stage = page.locator('#shape');
    const picture = async (): Promise<string> => {
      await page.evaluate(
        () =>
          new Promise<void>((resolve) => requestAnimationFrame(() => requestAnimationFrame(() => resolve()))),
      );
      return (await stage.screenshot()).toString('base64');
    };
    const pictures = new Set([await picture()]);
    for (const key of ['1', '2', '3', '4', 'c', 'x']) {
      if (key === 'c') for (const layer of ['1', '2', '3', '4']) await page.keyboard.press(layer);
      await page.keyboard.press(key);
      pictures.add(await picture());
    }
    expect(pictures.size).toBe(7);
  });

  test('the diagram reads values under the pointer, on both axes', async ({ page }) => {
    const diagram = page.getByRole('img', { name: /Betti numbers/ });
    await diagram.scrollIntoViewIfNeeded();
    const before = await state(page, 'step');
    const reading = page.locator('.reading');
    for (const axis of ['log', 'linear']) {
      await page.getByLabel('Axis of 1/ε').selectOption(axis);
      const box = await diagram.boundingBox();
      if (!box) throw new Error('no diagram');
      for (const share of [0.3, 0.8]) {
        await page.mouse.move(box.x + box.width * share, box.y + box.height / 2);
        await expect(reading).toHaveText(/^step \d+ · ε \S+ · β \d+, \d+, \d+$/);
        const inside = await reading.boundingBox();
        expect(inside && inside.x >= box.x && inside.x + inside.width <= box.x + box.width).toBe(true);
      }
    }
    expect(await state(page, 'step')).toBe(before);
    await page.mouse.move(0, 0);
    await expect(reading).toBeHidden();
  });

  test('terms explain themselves on hover and on focus', async ({ page }) => {
    const tip = page.getByRole('tooltip');
    await page.getByText('Witnesses', { exact: true }).hover();
    await expect(tip).toContainText('a point of your cloud');
    await page.mouse.move(0, 0);
    await expect(tip).toBeHidden();
    await page.getByRole('button', { name: 'plateau', exact: true }).focus();
    await page.keyboard.press('Shift+Tab');
    await page.keyboard.press('Tab');
    await expect(tip).toContainText('stay the same');
    await page.keyboard.press('Escape');
    await expect(tip).toBeHidden();
    await expect(page.getByRole('checkbox', { name: 'Landmarks' })).toHaveAccessibleDescription(/farthest/);
  });

  test('the scale bar is in units of the input', async ({ page }) => {
    await expect(page.locator('#scale-text')).toHaveText('1 unit');
    const far = torusText(60)
      .split('\n')
      .map((line) => line.replace(/(-?\d+)\.(\d{3})(\d*)/g, '$1$2.$3'))
      .join('\n');
    await drop(page, 'millimeters.xyz', far);
    await shown(page, 'millimeters.xyz');
    await expect(page.locator('#scale-text')).toHaveText('1,000 units');
  });
});

test('the gallery by keyboard: every shape with a picture of its own, the bunny too', async ({ page }) => {
  await openPaused(page, 'torus', 60);
  await page.keyboard.press('g');
  const gallery = page.getByRole('dialog', { name: 'Gallery' });
  await expect(gallery.locator('canvas[data-drawn]')).toHaveCount(SAMPLES.length);
  const pictures = await gallery
    .locator('canvas')
    .evaluateAll((canvases) => canvases.map((canvas) => (canvas as HTMLCanvasElement).toDataURL()));
  expect(new Set(pictures).size).toBe(SAMPLES.length);
  await page.keyboard.press('Escape');
  await expect(gallery).toBeHidden();
  await page.keyboard.press('g');
  const circle = gallery.getByRole('button', { name: /Noisy circle.*One loop/ });
  await circle.press('Enter');
  await expect(gallery).toBeHidden();
  await shown(page, 'circle-noise');
});

test('the bunny is a closed surface', async ({ page }) => {
  test.setTimeout(120_000);
  await openSample(page, 'bunny', 1500);
  await expect(
    page.locator('.cards button[data-family="surface"][data-betti="1,0,1"]').first(),
  ).toBeVisible();
  await expect(page.locator('#source')).toHaveText('Stanford bunny · 1,500 points');
});

test('the help sheet, and single keys that can be switched off for good', async ({ page }) => {
  await openPaused(page, 'torus', 60);
  await page.keyboard.press('?');
  const help = page.getByRole('dialog', { name: 'Help' });
  await expect(help).toBeVisible();
  const box = help.getByRole('checkbox');
  await box.press('Space');
  await page.keyboard.press('Escape');
  await page.keyboard.press('g');
  await expect(page.getByRole('dialog')).toHaveCount(0);
  await page.keyboard.press('Home');
  await page.keyboard.press('ArrowRight');
  await expect(root(page)).toHaveAttribute('data-step', '2');
  await openPaused(page, 'torus', 60);
  await page.keyboard.press('?');
  await expect(help).toBeHidden();
  await page.getByRole('button', { name: 'Help' }).click();
  await expect(box).not.toBeChecked();
});

test('settings of sample and run; undo and redo bring them back', async ({ page }) => {
  await openPaused(page, 'torus', 150);
  await page.getByText('Settings', { exact: true }).click();
  const hashes = [await state(page, 'hash')];
  const enter = async (label: string, value: string): Promise<void> => {
    await page.getByLabel(label, { exact: true }).fill(value);
    await page.getByLabel(label, { exact: true }).press('Enter');
    await expect.poll(async () => hashes.includes(await state(page, 'hash'))).toBe(false);
    await expect(root(page)).toHaveAttribute('data-run-state', 'finished');
    hashes.push(await state(page, 'hash'));
  };
  await enter('Stop at N', '100');
  expect(await state(page, 'steps')).toBe('100');
  await enter('Stop at ε', '0.5');
  expect(Number(await state(page, 'steps'))).toBeLessThan(100);
  await enter('Noise', '0.05');
  await enter('Points', '200');
  await expect(page.locator('#source')).toHaveText('Torus · 200 points');
  await page.getByLabel('ρ').fill('-1');
  await page.getByLabel('ρ').press('Enter');
  await expect(page.getByRole('alert')).toContainText('ρ takes a number');

  const at = async (index: number): Promise<void> => {
    await expect(root(page)).toHaveAttribute('data-hash', hashes[index] ?? '');
    await expect(root(page)).toHaveAttribute('data-run-state', 'finished');
  };
  await page.getByRole('button', { name: 'Undo' }).click();
  await at(3);
  await expect(page.getByLabel('Points', { exact: true })).toHaveValue('150');
  await page.locator('h1').click();
  for (const index of [2, 1, 0]) {
    await page.keyboard.press('Control+z');
    await at(index);
  }
  await expect(page.getByRole('button', { name: 'Undo' })).toBeDisabled();
  await page.keyboard.press('Control+Shift+Z');
  await at(1);
  await page.getByRole('button', { name: 'Redo' }).click();
  await at(2);
  // What is opened now takes the place of what was undone.
  await page.getByLabel('Sample').selectOption({ label: 'Curve with corners' });
  await shown(page, 'corner-curve');
  await expect(page.getByRole('button', { name: 'Redo' })).toBeDisabled();
});

test('an empty page says what to do', async ({ page }) => {
  await page.goto('./?sample=none');
  await page.getByRole('button', { name: 'Diagram (SVG)' }).click();
  await expect(page.getByRole('alert')).toContainText('nothing to save');
  await page.getByRole('button', { name: 'Choose a shape' }).click();
  await page.getByRole('button', { name: /Nested circles/ }).click();
  await shown(page, 'nested-circles');
  await expect(page.getByText('What shape is your point cloud')).toBeHidden();
});
