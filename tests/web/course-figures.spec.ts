// Figures of the course by key, mouse and finger; links to their states, frames, and the way from page to page.
import type { CDPSession, FrameLocator, Page } from '@playwright/test';
import { COURSE_FILES, COURSE_PAGES } from '../../web/course/pages.ts';
import type { PlateauViewElement } from '../../web/src/embed/plateau-view-element.ts';
import { board, openPage, press, settled } from './course.ts';
import { ForeignServer } from './foreign-page.ts';
import { expect, test } from './page.ts';

test.use({ viewport: { width: 720, height: 640 } });

test('a sketch by keyboard: walk, move, add, delete, undo, ask, and hear what came of it', async ({
  page,
}) => {
  await openPage(page, 'sketch');
  const sketch = page.locator('#sketch');
  const spoken = sketch.locator('[aria-live]');
  await press(page, board(page, 'sketch'), 'n');
  await expect(spoken).toHaveText('Landmark p1 at 30, 22');
  await page.keyboard.press('p');
  await expect(spoken).toHaveText(/^Witness w7 at 62, 62; nearest landmarks p3, p2, p1/);
  await press(page, board(page, 'sketch'), 'n', 'ArrowRight', 'Shift+ArrowUp');
  await expect(sketch).toHaveAttribute('landmarks', '31,27 86,18 62,62');
  // It is a witness as well, which goes with it.
  await expect(sketch).toHaveAttribute('witnesses', /31,27 86,18 62,62$/);
  await expect(spoken).toHaveText('Landmark p1 at 31, 27');
  await press(page, board(page, 'sketch'), 'Delete');
  await expect(sketch).toHaveAttribute('landmarks', '86,18 62,62');
  await expect(spoken).toHaveText(
    /^Removed: Landmark p1 at 31, 27\. 2 landmarks, 7 witnesses\. The complex has 1 edge/,
  );
  await press(page, board(page, 'sketch'), 'Control+z', 'Control+z', 'Control+z');
  await expect(sketch).toHaveAttribute('landmarks', '30,22 86,18 62,62');
  await press(page, board(page, 'sketch'), 'Escape', 'l');
  await expect(sketch).toHaveAttribute('landmarks', /^30,22 86,18 62,62 \d+,\d+$/);
  await press(page, board(page, 'sketch'), 'Escape', 'l');
  await expect(spoken).toHaveText(/There is no room for another landmark/);
  await sketch.getByRole('button', { name: 'Reset' }).focus();
  await page.keyboard.press('Enter');
  await expect(sketch).toHaveAttribute('landmarks', '30,22 86,18 62,62');
  await settled(sketch);
  await press(page, board(page, 'sketch'), 'n', 'Space', 'n', 'Space');
  await expect(sketch.getByRole('status')).toHaveText(
    'The edge p1 p2 is in the complex. It has 1 witness: w1.',
  );
  await expect(sketch.locator('.witness.lit')).toHaveCount(1);
  await press(
    page,
    sketch.getByRole('textbox', { name: /Why/ }),
    'ControlOrMeta+a',
    '1',
    'Space',
    '9',
    'Enter',
  );
  await expect(sketch.getByRole('status')).toHaveText('Name one to three landmarks from 1 to 3.');
});

/** In the window, where a board has this place; that of the free sketch unless named. */
async function placeOn(page: Page, x: number, y: number, id = 'sketch'): Promise<[number, number]> {
  await board(page, id).scrollIntoViewIfNeeded();
  const box = await board(page, id).boundingBox();
  if (!box) throw new Error('no board');
  return [box.x + (box.width * (x + 3)) / 126, box.y + (box.height * (83 - y)) / 86];
}

test('a sketch by mouse: drag, add, ask, and layers', async ({ page }) => {
  await openPage(page, 'sketch');
  const sketch = page.locator('#sketch');
  await page.mouse.move(...(await placeOn(page, 30, 22)));
  await page.mouse.down();
  await page.mouse.move(...(await placeOn(page, 34, 26)), { steps: 4 });
  await page.mouse.up();
  await expect(sketch).toHaveAttribute('landmarks', '34,26 86,18 62,62');
  await sketch.getByRole('button', { name: 'Undo' }).click();
  await expect(sketch).toHaveAttribute('landmarks', '30,22 86,18 62,62');
  await settled(sketch);
  await page.mouse.click(...(await placeOn(page, 45, 21.1)));
  await expect(sketch.getByRole('status')).toHaveText(/^The edge p1 p2 is in the complex/);
  await sketch.getByLabel('Add witnesses').check();
  await page.mouse.click(...(await placeOn(page, 100, 70)));
  await expect(sketch).toHaveAttribute('witnesses', /100,70$/);
  await sketch.getByLabel('Cells of order two').check();
  await expect(sketch.locator('.pair-cell')).toHaveCount(3);
  await expect(sketch).toHaveAttribute('show', 'complex pairs lists names');
  await sketch.getByLabel('ν₁').fill('3');
  await sketch.getByLabel('ν₁').press('Enter');
  await expect(sketch).toHaveAttribute('nu', '1,3,3');
  await sketch.getByLabel('ν₁').fill('99');
  await sketch.getByLabel('ν₁').press('Enter');
  await expect(sketch.getByRole('alert')).toHaveText(/nu="1,99,3" was not understood/);
});

/** A finger that goes from one place of the window to another. */
async function swipe(touch: CDPSession, from: [number, number], to: [number, number]): Promise<void> {
  const fingers = ([x, y]: [number, number]) => ({ touchPoints: [{ x, y }] });
  await touch.send('Input.dispatchTouchEvent', { type: 'touchStart', ...fingers(from) });
  for (const part of [0.2, 0.4, 0.6, 0.8, 1]) {
    const now: [number, number] = [from[0] + part * (to[0] - from[0]), from[1] + part * (to[1] - from[1])];
    await touch.send('Input.dispatchTouchEvent', { type: 'touchMove', ...fingers(now) });
  }
  await touch.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
}

test('what is only to be looked at can be selected, and is not changed, by mouse or key', async ({
  page,
}) => {
  await openPage(page, 'curves');
  const curve = page.locator('#curve');
  const before = await curve.getAttribute('witnesses');
  await page.mouse.move(...(await placeOn(page, 116, 40, 'curve')));
  await page.mouse.down();
  await page.mouse.move(...(await placeOn(page, 100, 60, 'curve')), { steps: 4 });
  await page.mouse.up();
  await expect(curve.locator('.witness.selected')).toHaveCount(1);
  await press(page, board(page, 'curve'), 'Escape', 'l', 'w', 'n', 'ArrowUp', 'Shift+ArrowLeft', 'Delete');
  await expect(curve.locator('.witness.selected')).toHaveCount(1);
  await settled(curve);
  expect(await curve.getAttribute('witnesses')).toBe(before);
  await expect(curve.locator('.witness')).toHaveCount(60);
  await expect(curve.getByRole('button', { name: 'Undo' })).toBeHidden();
  // What can be changed can be put back.
  const reset = curve.getByRole('button', { name: 'Reset' });
  await expect(reset).toBeDisabled();
  await curve.getByRole('button', { name: 'Next landmark' }).click();
  await expect(curve).toHaveAttribute('step', '11');
  await reset.click();
  await expect(curve).toHaveAttribute('step', '10');
});

test.describe('by finger', () => {
  test.use({ hasTouch: true });

  test('a swipe over a figure that is only to be looked at scrolls the page', async ({ page, context }) => {
    await page.setViewportSize({ width: 390, height: 640 });
    await openPage(page, 'curves');
    const before = await page.locator('#curve').getAttribute('witnesses');
    const [x, y] = await placeOn(page, 51, 69, 'curve');
    const from = await page.evaluate(() => scrollY);
    await swipe(await context.newCDPSession(page), [x, y], [x, y - 150]);
    await expect.poll(() => page.evaluate(() => scrollY)).toBeGreaterThan(from + 50);
    expect(await page.locator('#curve').getAttribute('witnesses')).toBe(before);
  });

  test('a sketch: drag and add', async ({ page, context }) => {
    await openPage(page, 'sketch');
    const sketch = page.locator('#sketch');
    await swipe(await context.newCDPSession(page), await placeOn(page, 30, 22), await placeOn(page, 40, 30));
    await expect(sketch).toHaveAttribute('landmarks', '40,30 86,18 62,62');
    await sketch.getByLabel('Add landmarks').tap();
    await page.touchscreen.tap(...(await placeOn(page, 100, 70)));
    await expect(sketch).toHaveAttribute('landmarks', '40,30 86,18 62,62 100,70');
  });
});

test('a link holds the state of a figure, and nothing that it may not set', async ({ page, context }) => {
  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  await openPage(page, 'order-two');
  await press(page, board(page, 'circle'), 'n', 'ArrowUp');
  await expect(page.locator('#circle')).toHaveAttribute('landmarks', /^36,15 /);
  await page.getByRole('button', { name: 'Link to this state' }).first().click();
  const address = await page.evaluate(() => navigator.clipboard.readText());
  expect(address).toBe(page.url());
  await expect(page.locator('#circle ~ .figure-link').getByRole('status')).toHaveText('Copied.');
  expect(address).toMatch(
    /order-two\.html#circle\.landmarks=36,15_90,18_84,66_32,62&circle\.witnesses=[\d,_]+$/,
  );
  await page.goto('about:blank');
  await page.goto(`${address}&circle.nu=1,3,3&circle.onclick=x&nobody.nu=1`);
  const circle = page.locator('#circle');
  await expect(circle).toHaveAttribute('landmarks', '36,15 90,18 84,66 32,62');
  await expect(circle).toHaveAttribute('nu', '1,3,3');
  await settled(circle);
  expect(await circle.getAttribute('onclick')).toBeNull();
  await circle.getByRole('button', { name: 'Reset' }).click();
  await expect(circle).toHaveAttribute('landmarks', /^36,14 /);
});

test('a sketch that a teacher has written wrongly says what it takes', async ({ page }) => {
  await page.goto('./course/sketch.html#sketch.landmarks=20,30_here');
  const sketch = page.locator('#sketch');
  // It stays to be read, beside the picture of what the page has.
  await settled(sketch);
  await expect(sketch.getByRole('alert')).toHaveText(/"here" is no point/);
  await sketch.getByRole('button', { name: 'Reset' }).click();
  await expect(sketch.getByRole('alert')).toBeHidden();
});

test('pages of the course stand in a frame of another site, and their links are for the taking', async ({
  page,
  baseURL,
}) => {
  const foreign = await ForeignServer.start(baseURL ?? '');
  try {
    const lesson = async (path: string): Promise<FrameLocator> => {
      const src = `${baseURL ?? ''}/course/${path}`;
      const frame = `<iframe title="Course" width="700" height="600" src="${src}"></iframe>`;
      await page.goto(foreign.put('/lesson', `<!doctype html><title>Lesson</title>${frame}`));
      return page.frameLocator('iframe');
    };
    const witnesses = await lesson('witnesses.html');
    await expect(witnesses.locator('#first')).toHaveAttribute('data-betti', '1,0');
    await expect(witnesses.getByRole('heading', { level: 1 })).toHaveText('2. Witnesses and landmarks');
    // The frame may not use the clipboard, and its address is in no bar.
    await witnesses.locator('#first svg.board').focus();
    for (const key of ['n', 'ArrowUp']) await page.keyboard.press(key);
    await expect(witnesses.locator('#first')).toHaveAttribute('landmarks', /^26,21 /);
    await witnesses.getByRole('button', { name: 'Link to this state' }).first().click();
    const field = witnesses.getByRole('textbox', { name: 'Link to this state' }).first();
    await expect(field).toHaveValue(/\/course\/witnesses\.html#first\.landmarks=26,21_82,12_/);
    expect(
      await field.evaluate((input: HTMLInputElement) =>
        input.value.slice(input.selectionStart ?? 0, input.selectionEnd ?? 0),
      ),
    ).toBe(await field.inputValue());
    const plateaus = await lesson('plateaus.html#helix.step=90');
    await expect(plateaus.locator('#helix .view')).toHaveAttribute('data-run-state', 'finished');
    await expect
      .poll(() => plateaus.locator('#helix').evaluate((view: PlateauViewElement) => view.currentStep))
      .toBe(90);
    // Plateau itself may not stand in the frame: its link leaves it.
    await plateaus.getByRole('link', { name: 'Plateau', exact: true }).click();
    await expect(page).toHaveURL(`${baseURL ?? ''}/`);
  } finally {
    await foreign.stop();
  }
});

test('from page to page: every link of the course leads somewhere', async ({ page, request }) => {
  await page.goto('./course/');
  await expect(page.locator('.contents a')).toHaveCount(COURSE_PAGES.length);
  const seen = new Set<string>();
  for (const file of COURSE_FILES) {
    const html = await (await request.get(`./course/${file}.html`)).text();
    for (const [, href = ''] of html.matchAll(/<a[^>]*\shref="([^"#]+)"/g))
      if (!href.startsWith('https://')) seen.add(href);
  }
  for (const href of seen) expect((await request.get(`./course/${href}`)).status(), href).toBe(200);
  await page.goto('./?sample=none');
  await page.getByRole('button', { name: 'Help' }).click();
  await page
    .getByRole('dialog')
    .getByRole('link', { name: /course/i })
    .click();
  await expect(page).toHaveURL(/\/course\/$/);
});
