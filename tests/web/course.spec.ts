// The course as a reader without a mouse meets it: every task, right and wrong; figures, links, frames.
import type { Locator, Page } from '@playwright/test';
import { COURSE_FILES, COURSE_PAGES } from '../../web/course/pages.ts';
import type { PlateauViewElement } from '../../web/src/embed/plateau-view-element.ts';
import { ForeignServer } from './foreign-page.ts';
import { expect, test } from './page.ts';

test.use({ viewport: { width: 720, height: 640 } });

async function openPage(page: Page, file: string): Promise<void> {
  await page.goto(`./course/${file}.html`);
  for (const sketch of await page.locator('plane-sketch').all()) await settled(sketch);
}

/** Until the core has said all about the sketch. */
async function settled(sketch: Locator): Promise<void> {
  await expect(sketch).toHaveAttribute('data-betti', /^\d/);
  await expect(sketch).not.toHaveAttribute('data-busy', '');
}

/** Scrolls to a view, which then computes, and waits for its end. */
async function finished(page: Page, id: string): Promise<void> {
  const view = page.locator(`plateau-view#${id}`);
  await view.scrollIntoViewIfNeeded();
  await expect(view.locator('.view')).toHaveAttribute('data-run-state', 'finished');
}

const task = (page: Page, name: string): Locator => page.locator(`form[data-task="${name}"]`);
const board = (page: Page, id: string): Locator => page.locator(`#${id} svg.board`);

/** Answers by keyboard alone and presses Check; '' where the figure is the answer. */
async function answer(page: Page, name: string, text: string): Promise<void> {
  const form = task(page, name);
  const radio = form.locator(`input[type=radio][value="${text}"]`);
  if ((await radio.count()) > 0) {
    await radio.focus();
    await page.keyboard.press('Space');
  } else if (text !== '') {
    await form.getByRole('textbox').last().focus();
    await page.keyboard.press('ControlOrMeta+a');
    await page.keyboard.type(text);
  }
  await form.getByRole('button', { name: 'Check' }).focus();
  await page.keyboard.press('Enter');
}

async function verdict(
  page: Page,
  name: string,
  kind: 'right' | 'wrong' | 'open',
  reason: RegExp,
): Promise<void> {
  await expect(task(page, name).locator('.verdict')).toHaveText(reason);
  await expect(task(page, name)).toHaveAttribute('data-verdict', kind);
}

async function press(page: Page, target: Locator, ...keys: string[]): Promise<void> {
  await target.focus();
  for (const key of keys) await page.keyboard.press(key);
}

const times = (count: number, key: string): string[] => Array.from({ length: count }, () => key);

/** Page, task, a wrong and a right answer, and what is said to the right one. */
const ANSWERS: readonly (readonly [string, string, string, string, RegExp])[] = [
  ['voronoi', 'diagonal', '1 3', '0 2', /p2 p4 is not in the Delaunay triangulation: every disc .* p3 or p1/],
  ['voronoi', 'triangles-after', '7', '8', /8 landmarks, 6 of them on the rim: .* = 8 triangles, after 6/],
  ['witnesses', 'witnessed-edge', '1 2', '2 3', /w2 are p3, p2, p4, in/],
  ['witnesses', 'without-w1', '5', '4', /4 edges instead of 5, for edge p1 p2 would go/],
  ['order-two', 'least-nu', '2', '3', /ν₁ = 3 the edge p1 p3 has 14 witnesses/],
  ['order-two', 'relaxed-triangles', '1', '2', /2 triangles: triangle p1 p2 p3 and triangle p1 p3 p4/],
  ['farthest', 'next-landmark', '7', '5', /w5 is farthest .* ε = 29\.5/],
  ['farthest', 'steps-to-scale', '8', '10', /After 9 landmarks ε is 15\.3, after 10 it is 13\.9/],
  ['curves', 'pieces', 'yes', 'no', /0 triangles/],
  [
    'plateaus',
    'fake',
    '2',
    '1',
    /Gone: p3 p5\. Born: p3 p8, p6 p8, where p8 is a\. Betti numbers 1, 1 before and 1, 1 after/,
  ],
];

for (const { file } of COURSE_PAGES.slice(0, 5)) {
  test(`predictions by keyboard: ${file}`, async ({ page }) => {
    await openPage(page, file);
    for (const [, name, wrong, right, reason] of ANSWERS.filter(([where]) => where === file)) {
      await press(page, task(page, name).getByRole('button', { name: 'Check' }), 'Enter');
      await verdict(page, name, 'open', /^Answer first/);
      await answer(page, name, wrong);
      await verdict(page, name, 'wrong', /^Not yet\. /);
      await answer(page, name, right);
      await verdict(page, name, 'right', /^Right\. /);
      await verdict(page, name, 'right', reason);
    }
  });
}

test('a triangle is made by keyboard: one witness for the edge that had none', async ({ page }) => {
  await openPage(page, 'witnesses');
  await answer(page, 'some-triangle', '');
  await verdict(page, 'some-triangle', 'wrong', /one of its faces is not: edge p1 p2\. .* closest miss is w/);
  await press(page, board(page, 'corner'), ...times(4, 'Shift+ArrowDown'), ...times(2, 'ArrowDown'), 'w');
  await expect(page.locator('#corner')).toHaveAttribute('witnesses', /60,18$/);
  await answer(page, 'some-triangle', '');
  await verdict(page, 'some-triangle', 'right', /triangle p1 p2 p3 is in the complex/);
  // Taken back, it is wrong again: the mark is of the figure at that moment.
  await press(page, board(page, 'corner'), 'Control+z');
  await answer(page, 'some-triangle', '');
  await verdict(page, 'some-triangle', 'wrong', /w4|edge p1 p2/);
});

test('a cell of order two is opened by keyboard', async ({ page }) => {
  await openPage(page, 'order-two');
  await answer(page, 'open-diagonal', '');
  await verdict(page, 'open-diagonal', 'wrong', /has no witness\. The closest miss/);
  await press(
    page,
    board(page, 'circle'),
    'n',
    'n',
    'n',
    ...times(3, 'Shift+ArrowLeft'),
    ...times(3, 'Shift+ArrowDown'),
  );
  await expect(page.locator('#circle')).toHaveAttribute('landmarks', /69,51 32,62/);
  await answer(page, 'open-diagonal', '');
  await verdict(page, 'open-diagonal', 'right', /is in the complex/);
});

test('the last step of a closed curve is found by keyboard', async ({ page }) => {
  await openPage(page, 'curves');
  await answer(page, 'one-loop', '');
  await verdict(page, 'one-loop', 'wrong', /so it has at the next one/);
  const next = page.locator('#curve').getByRole('button', { name: 'Next landmark' });
  for (let step = 10; step < 20; ++step) {
    await press(page, next, 'Enter');
    await expect(page.locator('#curve')).toHaveAttribute('step', String(step + 1));
  }
  await settled(page.locator('#curve'));
  await answer(page, 'one-loop', '');
  await verdict(page, 'one-loop', 'right', /at step 21 it has 1 component\./);
  await press(page, next, 'Enter');
  await answer(page, 'one-loop', '');
  await verdict(page, 'one-loop', 'wrong', /At step 21 the complex has 1 component\./);
});

test('surfaces: the three complexes, their loops and the genus, by keyboard', async ({ page }) => {
  await openPage(page, 'surfaces');
  await finished(page, 'torus');
  await answer(page, 'closed-surface', '');
  await verdict(page, 'closed-surface', 'wrong', /174 loops/);
  await answer(page, 'holes', 'two');
  await verdict(page, 'holes', 'wrong', /has 174 loops/);
  await press(page, page.getByRole('button', { name: 'the surface inside it' }), 'Enter');
  await expect(page.locator('#torus')).toHaveAttribute('family', 'surface');
  // Only in view it opens the other run.
  const torus = page.locator('plateau-view#torus');
  await torus.scrollIntoViewIfNeeded();
  await expect
    .poll(() => torus.evaluate((view: PlateauViewElement) => view.plateaus[0]?.family))
    .toBe('surface');
  await finished(page, 'torus');
  await answer(page, 'closed-surface', '');
  await verdict(page, 'closed-surface', 'right', /torus-like closed surface/);
  await verdict(page, 'closed-surface', 'right', /^Right/);
  await answer(page, 'holes', 'more');
  await verdict(page, 'holes', 'right', /has 174 loops/);
  await finished(page, 'tanglecube');
  await answer(page, 'genus', '10');
  await verdict(page, 'genus', 'wrong', /1, 10, 1/);
  await answer(page, 'genus', '5');
  await verdict(page, 'genus', 'right', /10 loops, so 5 handles/);
});

test('plateaus: two answers of one cloud and a fake one, by keyboard', async ({ page }) => {
  await openPage(page, 'plateaus');
  for (const [, name, wrong, right, reason] of ANSWERS.filter(([where]) => where === 'plateaus')) {
    await answer(page, name, wrong);
    await verdict(page, name, 'wrong', /^Not yet/);
    await answer(page, name, right);
    await verdict(page, name, 'right', reason);
  }
  await finished(page, 'helix');
  await answer(page, 'curve-scale', '');
  await verdict(page, 'curve-scale', 'wrong', /At step 60 it shows/);
  await press(page, page.locator('#helix').getByRole('slider'), 'PageUp', 'PageUp');
  await answer(page, 'curve-scale', '');
  await verdict(page, 'curve-scale', 'right', /closed curve/);
  await answer(page, 'long-plateaus', '2');
  await verdict(page, 'long-plateaus', 'wrong', /There are 3/);
  await answer(page, 'long-plateaus', '3');
  await verdict(page, 'long-plateaus', 'right', /1, 1, 0 of length 1\.59; 1, 2, 1 of length 1\.26/);
});

test('four dimensions, by keyboard', async ({ page }) => {
  await openPage(page, 'dimensions');
  await finished(page, 'clifford');
  await answer(page, 'clifford-betti', 'no');
  await verdict(page, 'clifford-betti', 'wrong', /1 component, 2 loops, 1 void/);
  await answer(page, 'clifford-betti', 'yes');
  await verdict(page, 'clifford-betti', 'right', /1 component, 2 loops, 1 void/);
  await finished(page, 'sphere');
  await answer(page, 'three-sphere', '1,0,1,0');
  await verdict(page, 'three-sphere', 'wrong', /1, 0, 0, 1/);
  await answer(page, 'three-sphere', '1,0,0,1');
  await verdict(page, 'three-sphere', 'right', /1, 0, 0, 1/);
});

test('without a figure in view a task says so', async ({ page }) => {
  await openPage(page, 'plateaus');
  await page.locator('#helix').evaluate((view) => view.remove());
  await answer(page, 'curve-scale', '');
  await verdict(page, 'curve-scale', 'open', /#helix is no view/);
});

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

/** In the window, where the board of the free sketch has this place. */
async function placeOn(page: Page, x: number, y: number): Promise<[number, number]> {
  await board(page, 'sketch').scrollIntoViewIfNeeded();
  const box = await board(page, 'sketch').boundingBox();
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

test.describe('by finger', () => {
  test.use({ hasTouch: true });

  test('a sketch: drag and add', async ({ page, context }) => {
    await openPage(page, 'sketch');
    const sketch = page.locator('#sketch');
    const touch = await context.newCDPSession(page);
    const [from, to] = [await placeOn(page, 30, 22), await placeOn(page, 40, 30)];
    const fingers = ([x, y]: [number, number]) => ({ touchPoints: [{ x, y }] });
    await touch.send('Input.dispatchTouchEvent', { type: 'touchStart', ...fingers(from) });
    for (const part of [0.3, 0.6, 1]) {
      const now: [number, number] = [from[0] + part * (to[0] - from[0]), from[1] + part * (to[1] - from[1])];
      await touch.send('Input.dispatchTouchEvent', { type: 'touchMove', ...fingers(now) });
    }
    await touch.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
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
  await expect(page.locator('#sketch').getByRole('alert')).toHaveText(/"here" is no point/);
});

test('a page of the course stands in a frame of another site', async ({ page, baseURL }) => {
  const foreign = await ForeignServer.start(baseURL ?? '');
  try {
    const src = `${baseURL ?? ''}/course/witnesses.html`;
    await page.goto(
      foreign.put(
        '/lesson',
        `<!doctype html><title>Lesson</title><iframe title="Course" src="${src}"></iframe>`,
      ),
    );
    const frame = page.frameLocator('iframe');
    await expect(frame.locator('#first')).toHaveAttribute('data-betti', '1,0');
    await expect(frame.getByRole('heading', { level: 1 })).toHaveText('2. Witnesses and landmarks');
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
