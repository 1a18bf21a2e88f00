// The tasks of the course as a reader without a mouse meets them: each one, right and wrong.
import { COURSE_PAGES } from '../../web/course/pages.ts';
import type { PlateauViewElement } from '../../web/src/embed/plateau-view-element.ts';
import {
  answer,
  board,
  finished,
  holdCore,
  openPage,
  press,
  settled,
  task,
  times,
  verdict,
} from './course.ts';
import { expect, test } from './page.ts';

test.use({ viewport: { width: 720, height: 640 } });

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
  ['plateaus', 'fake', '2', '1', /Gone: p3 p5\. Born: p3 a, p6 a\. Betti numbers 1, 1 before and 1, 1 after/],
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

test('the next landmark may be named by its number, with a letter, or by its place', async ({ page }) => {
  await openPage(page, 'farthest');
  for (const right of ['w5', '33,17', '(33, 17)']) {
    await answer(page, 'next-landmark', '7');
    await verdict(page, 'next-landmark', 'wrong', /^Not yet/);
    await answer(page, 'next-landmark', right);
    await verdict(page, 'next-landmark', 'right', /w5 is farthest/);
  }
  for (const wrong of ['-5', '17,33', '33']) {
    await answer(page, 'next-landmark', wrong);
    await verdict(page, 'next-landmark', 'wrong', /^Not yet/);
  }
});

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
  await verdict(page, 'closed-surface', 'wrong', /2 loops, 300 voids/);
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
  // A coarse ring has the numbers of a closed curve, too.
  await page.locator('#helix').evaluate((view: PlateauViewElement) => view.goTo(6));
  await answer(page, 'curve-scale', '');
  await verdict(page, 'curve-scale', 'wrong', /At step 6 .* closed curve\. But it soon passes/);
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

test('a figure whose ν or triangle is another one is no answer', async ({ page }) => {
  await openPage(page, 'order-two');
  await page.locator('#circle').getByLabel('ν₁').fill('3');
  await page.locator('#circle').getByLabel('ν₁').press('Enter');
  await settled(page.locator('#circle'));
  await answer(page, 'open-diagonal', '');
  await verdict(page, 'open-diagonal', 'wrong', /With ν = \(1, 2, 3\), please\./);
  await openPage(page, 'witnesses');
  // A triangle of others: p1 p2 p3 has still no witness for p1 p2.
  const corner = page.locator('#corner');
  await corner.evaluate((sketch) => {
    sketch.setAttribute('landmarks', '36,18 88,24 58,64 110,50');
    sketch.setAttribute('witnesses', '36,18 88,24 58,64 110,50 100,36 84,58 74,43');
  });
  await settled(corner);
  await expect(corner.locator('.triangle')).not.toHaveCount(0);
  await answer(page, 'some-triangle', '');
  await verdict(page, 'some-triangle', 'wrong', /triangle p1 p2 p3 is not in the complex/);
});

test('how few witnesses a triangle takes is marked', async ({ page }) => {
  await openPage(page, 'witnesses');
  const corner = page.locator('#corner');
  await corner.evaluate((sketch) => sketch.setAttribute('witnesses', '36,18 88,24 58,64 60,18 62,20'));
  await settled(corner);
  await answer(page, 'some-triangle', '');
  await verdict(page, 'some-triangle', 'right', /You added 2 witnesses; 1 would have been enough\./);
  await corner.evaluate((sketch) => sketch.setAttribute('witnesses', '36,18 88,24 58,64 60,18'));
  await settled(corner);
  await answer(page, 'some-triangle', '');
  await verdict(page, 'some-triangle', 'right', /You added 1 witness; no fewer would do\./);
});

test('what is said steps back once the answer or the figure is another', async ({ page }) => {
  await openPage(page, 'witnesses');
  const form = task(page, 'witnessed-edge');
  await answer(page, 'witnessed-edge', '2 3');
  await verdict(page, 'witnessed-edge', 'right', /^Right/);
  await expect(form).not.toHaveAttribute('data-stale', '');
  await form.getByRole('textbox').fill('1 2');
  await expect(form).toHaveAttribute('data-stale', '');
  await answer(page, 'witnessed-edge', '1 2');
  await verdict(page, 'witnessed-edge', 'wrong', /^Not yet/);
  await expect(form).not.toHaveAttribute('data-stale', '');
  // A layer more is the same figure; a landmark moved is another.
  await page.locator('#first').getByLabel('Voronoi cells').check();
  await expect(page.locator('#first')).toHaveAttribute('show', /cells/);
  await expect(form).not.toHaveAttribute('data-stale', '');
  await press(page, board(page, 'first'), 'n', 'ArrowUp');
  await expect(form).toHaveAttribute('data-stale', '');
});

test('a wrong guess at the diagonal does not draw the answer', async ({ page }) => {
  await openPage(page, 'voronoi');
  await answer(page, 'diagonal', '1 3');
  await verdict(page, 'diagonal', 'wrong', /^Not yet/);
  await expect(page.locator('#square .delaunay')).toHaveCount(0);
  await answer(page, 'diagonal', '0 2');
  await verdict(page, 'diagonal', 'right', /^Right/);
  await expect(page.locator('#square .delaunay')).toHaveCount(5);
});

test('before a figure in space is open, or done, a right answer is not called wrong', async ({ page }) => {
  const release = await holdCore(page);
  await openPage(page, 'surfaces');
  await answer(page, 'genus', '5');
  await verdict(page, 'genus', 'open', /^The figure shows nothing yet/);
  await answer(page, 'closed-surface', '');
  await verdict(page, 'closed-surface', 'open', /^The figure shows nothing yet/);
  // Enough points that the end is far.
  const tanglecube = page.locator('plateau-view#tanglecube');
  await tanglecube.evaluate((view: PlateauViewElement) => {
    view.setAttribute('size', '60000');
    view.removeAttribute('steps');
  });
  release();
  await tanglecube.scrollIntoViewIfNeeded();
  await expect
    .poll(() => tanglecube.evaluate((view: PlateauViewElement) => view.currentStep))
    .toBeGreaterThan(0);
  // Out of view its run stands still.
  await page.evaluate(() => scrollTo(0, 0));
  expect(await tanglecube.evaluate((view: PlateauViewElement) => view.finished)).toBe(false);
  await answer(page, 'genus', '5');
  await verdict(page, 'genus', 'open', /^The figure is still computing/);
});

test('opposite is who lies opposite, whatever the landmarks are called', async ({ page }) => {
  await openPage(page, 'order-two');
  const circle = page.locator('#circle');
  await circle.evaluate((sketch) => sketch.setAttribute('landmarks', '36,14 84,66 90,18 32,62'));
  await settled(circle);
  await answer(page, 'least-nu', '2');
  await verdict(page, 'least-nu', 'wrong', /ν₁ = 3 the edge p1 p2 has 14 witnesses/);
  await answer(page, 'least-nu', '3');
  await verdict(page, 'least-nu', 'right', /ν₁ = 3 the edge p1 p2/);
});
