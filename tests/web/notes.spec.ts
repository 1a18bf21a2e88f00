import { drop, expect, openPaused, root, shown, state, test, torusText } from './page.ts';

test('points on a line and in a plane are shown, with a note', async ({ page }) => {
  await openPaused(page, 'torus', 60);
  const note = page.locator('#warning');
  await drop(page, 'line.xyz', Array.from({ length: 40 }, (_, i) => `${i} ${2 * i} ${3 * i}\n`).join(''));
  await shown(page, 'line.xyz');
  await expect(note).toContainText('on one line');
  await expect(page.getByRole('alert')).toBeHidden();
  expect(await state(page, 'betti')).toMatch(/^\d+,0,0$/);
  const ring = Array.from({ length: 60 }, (_, i) => `${Math.cos(i)} 7 ${Math.sin(i)}\n`).join('');
  await drop(page, 'ring.xyz', ring);
  await shown(page, 'ring.xyz');
  await expect(note).toContainText('in one plane');
  await expect(page.locator('.cards button').first()).toContainText('closed curve');
  await page.keyboard.press('End');
  await expect(root(page)).toHaveAttribute('data-step', '60');
  await drop(page, 'torus.xyz', torusText(60));
  await shown(page, 'torus.xyz');
  await expect(note).toBeHidden();
});

test('the question for columns is the page’s own, not the command’s', async ({ page }) => {
  await openPaused(page, 'torus', 60);
  await drop(page, 'wide.csv', '1,0,0,9\n2,1,0,9\n3,1,1,8\n');
  await expect(page.getByRole('alert')).toHaveText('wide.csv: 4 columns: choose the coordinates.');
  await expect(page.locator('main')).not.toContainText('--');
  await page.getByLabel('Which columns').fill('2, 3');
  await page.getByRole('button', { name: 'Open with these' }).click();
  await shown(page, 'wide.csv');
  await expect(page.locator('#columns-form')).toBeHidden();
});

test('a file of four numbers a point can be read as points of R⁴', async ({ page }) => {
  await openPaused(page, 'torus', 60);
  await drop(page, 'four.xyz', '0 0 0 1\n1 0 0 2\n0 1 0 3\n0 0 1 5\n1 1 1 0\n');
  await shown(page, 'four.xyz');
  const note = page.getByText('Took columns 1,2,3 of 4 as coordinates.');
  await expect(note).toBeVisible();
  await expect(page.locator('main')).not.toContainText('--');
  await expect(page.getByRole('button', { name: 'They are distances' })).toBeHidden();
  await expect(page.getByLabel('Which columns')).toHaveValue('1, 2, 3, 4');
  await page.getByRole('button', { name: 'Open with these' }).click();
  await expect(page.locator('#columns-form')).toBeHidden();
  await expect(note).toBeHidden();
  await expect.poll(async () => (await state(page, 'betti')).split(',').length).toBe(4);
});

test('a cloud without a plateau gets an honest card', async ({ page }) => {
  await openPaused(page, 'torus', 60);
  await drop(page, 'two.xyz', '0 0 0\n1 1 1\n');
  await shown(page, 'two.xyz');
  await expect(page.getByText(/^No scale at which the shape stands still: too few points/)).toBeVisible();
  await expect(page.locator('.cards button')).toHaveCount(0);
});

test('undo again while an undo is opening goes back one more', async ({ page }) => {
  await openPaused(page, 'torus', 100);
  const names = ['a.xyz', 'b.xyz', 'c.xyz'];
  for (const [i, name] of names.entries()) {
    await drop(page, name, torusText(40 + i));
    await shown(page, name);
  }
  // Both in one task: the first cannot have been opened.
  await page.evaluate(() => {
    for (let i = 0; i < 2; ++i) {
      document.body.dispatchEvent(new KeyboardEvent('keydown', { key: 'z', ctrlKey: true, bubbles: true }));
    }
  });
  await shown(page, 'a.xyz');
  await page.keyboard.press('Control+Shift+Z');
  await shown(page, 'b.xyz');
  // An undo that something else overtakes led nowhere: before the new one is what was seen.
  const dropped = torusText(50);
  await page.evaluate((text) => {
    document.body.dispatchEvent(new KeyboardEvent('keydown', { key: 'z', ctrlKey: true, bubbles: true }));
    const transfer = new DataTransfer();
    transfer.items.add(new File([text], 'd.xyz'));
    document.body.dispatchEvent(
      new DragEvent('drop', { dataTransfer: transfer, bubbles: true, cancelable: true }),
    );
  }, dropped);
  await shown(page, 'd.xyz');
  await page.keyboard.press('Control+z');
  await shown(page, 'b.xyz');
});

test('a card frames the shape, from where it was turned', async ({ page }) => {
  await openPaused(page, 'torus', 120);
  const card = page.locator('.cards button[data-betti="1,2,1"]').first();
  await card.click();
  const bar = page.locator('#scale-length');
  const width = (): Promise<string> => bar.evaluate((element) => element.style.width);
  const framed = await width();
  await page.locator('#shape').focus();
  for (let i = 0; i < 3; ++i) await page.keyboard.press('+');
  await expect.poll(width).not.toBe(framed);
  await card.click();
  await expect.poll(width).toBe(framed);
});

test('on a phone the diagram scrolls along 1/ε, and the playhead stays in sight', async ({ page }) => {
  await page.setViewportSize({ width: 390, height: 844 });
  await openPaused(page, 'helix', 500);
  const timeline = page.locator('#timeline');
  const scrolled = (): Promise<number> => timeline.evaluate((element) => element.scrollLeft);
  const [seen, whole] = await timeline.evaluate((element) => [element.clientWidth, element.scrollWidth]);
  expect(whole).toBeGreaterThan((seen ?? 0) * 1.3);
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(390);
  const inSight = async (): Promise<boolean> => {
    const place = await page.locator('.playhead').boundingBox();
    const box = await timeline.boundingBox();
    return !!place && !!box && place.x >= box.x && place.x + place.width <= box.x + box.width;
  };
  await page.keyboard.press('Home');
  await expect.poll(inSight).toBe(true);
  const before = await scrolled();
  await page.keyboard.press('End');
  await expect.poll(inSight).toBe(true);
  expect(await scrolled()).toBeGreaterThan(before + 40);
  // A tap at the left edge of what is seen is not the beginning of the run.
  const box = await page.getByRole('img', { name: /Betti numbers/ }).boundingBox();
  const window = await timeline.boundingBox();
  if (!box || !window) throw new Error('no diagram');
  await page.mouse.click(window.x + 60, box.y + box.height / 2);
  const step = Number(await state(page, 'step'));
  expect(step).toBeGreaterThan(3);
  expect(step).toBeLessThan(500);
});

test.describe('a finger on the diagram', () => {
  test.use({ hasTouch: true, viewport: { width: 390, height: 844 } });

  test('taps a place or scrolls, and finds a grip at the playhead', async ({ page }) => {
    await openPaused(page, 'helix', 500);
    const timeline = page.locator('#timeline');
    const box = await timeline.boundingBox();
    if (!box) throw new Error('no diagram');
    const middle = box.y + box.height / 2;
    await page.touchscreen.tap(box.x + 200, middle);
    await expect.poll(async () => Number(await state(page, 'step'))).toBeGreaterThan(3);
    const tapped = Number(await state(page, 'step'));
    const finger = (type: string, x: number, target: string): Promise<void> =>
      page.locator(target).dispatchEvent(type, {
        pointerId: 9,
        pointerType: 'touch',
        button: 0,
        clientX: x,
        clientY: middle,
        bubbles: true,
      });
    // On the diagram itself a finger that moves scrolls and leaves the playhead.
    await finger('pointerdown', box.x + 100, '#diagram');
    await finger('pointermove', box.x + 300, '#diagram');
    await finger('pointercancel', box.x + 300, '#diagram');
    expect(Number(await state(page, 'step'))).toBe(tapped);
    expect(await page.locator('#diagram').evaluate((element) => getComputedStyle(element).touchAction)).toBe(
      'pan-x pan-y',
    );
    expect(await page.locator('.playhead').evaluate((element) => getComputedStyle(element).touchAction)).toBe(
      'none',
    );
  });
});

test('every term explains itself with a picture, by hover and by focus', async ({ page }) => {
  await page.setViewportSize({ width: 1280, height: 800 });
  await openPaused(page, 'torus', 60);
  await page.getByText('Settings', { exact: true }).click();
  // Those of family dilated are hidden here, and explained where it is.
  const terms = page.locator('.term:visible');
  const tip = page.getByRole('tooltip');
  const told = new Map<string, string>();
  for (const term of await terms.all()) {
    await page.mouse.move(0, 0);
    await term.hover();
    await expect(tip).toBeVisible();
    await expect(tip.locator('svg')).toBeVisible();
    expect(await tip.locator('svg path').count()).toBeGreaterThan(0);
    told.set((await term.textContent()) ?? '', (await tip.locator('p').textContent()) ?? '');
    await page.mouse.move(0, 0);
    await expect(tip).toBeHidden();
  }
  expect([...told.keys()].sort()).toEqual(['1/ε', 'Landmarks', 'Witnesses', 'plateau', 'ν']);
  expect(new Set(told.values()).size).toBe(5);
  // The tip of a setting covers no other setting.
  await page.getByRole('textbox', { name: 'ν' }).focus();
  await expect(tip).toBeVisible();
  const [box, form] = [await tip.boundingBox(), await page.locator('#settings').boundingBox()];
  expect(box && form && box.x + box.width <= form.x).toBe(true);
});
