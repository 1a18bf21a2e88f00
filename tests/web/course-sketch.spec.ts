// What a sketch owes to its readers beyond moving points: what is offered, said, drawn, and put back.
import type { Locator, Page } from '@playwright/test';
import { answer, board, holdCore, openPage, press, settled, task, times, verdict } from './course.ts';
import { expect, test } from './page.ts';

test.use({ viewport: { width: 720, height: 640 } });

const spoken = (page: Page, id: string): Locator => page.locator(`#${id} [aria-live]`);
const said = (page: Page, id: string): Locator => page.locator(`#${id}`).getByRole('status');

test('what a figure has not to offer is not there: tools, keys, layers', async ({ page }) => {
  await openPage(page, 'voronoi');
  const map = page.locator('#map');
  await expect(map.getByLabel('Add landmarks')).toBeVisible();
  for (const later of ['Ask why', 'Add witnesses']) await expect(map.getByLabel(later)).toBeHidden();
  await press(page, board(page, 'map'), 'w', 'l');
  await expect(map).toHaveAttribute('landmarks', / 60,40$/);
  expect(await map.getAttribute('witnesses')).toBeNull();
  await expect(map.getByLabel('Voronoi cells', { exact: true })).toBeVisible();
  for (const later of ['Complex', 'Cells of order two', 'Only Delaunay simplices', 'Discs of radius ε'])
    await expect(map.getByLabel(later)).toBeHidden();
  await openPage(page, 'curves');
  const curve = page.locator('#curve');
  await curve.getByText('Keys on the board').click();
  await expect(curve.getByText('next or previous point')).toBeVisible();
  for (const key of ['remove the selected point', 'put a landmark', 'take the selected landmark'])
    await expect(curve.getByText(key)).toBeHidden();
  await openPage(page, 'witnesses');
  await expect(page.locator('#first').getByLabel('Ask why')).toBeVisible();
  await expect(page.locator('#first').getByLabel('ν₁')).toBeHidden();
});

test('all is put back as the page had it: points, layers, the complex, the question', async ({ page }) => {
  await openPage(page, 'sketch');
  const sketch = page.locator('#sketch');
  const reset = sketch.getByRole('button', { name: 'Reset' });
  await expect(reset).toBeDisabled();
  await sketch.getByLabel('Only Delaunay simplices').uncheck();
  await sketch.getByLabel('Voronoi cells').check();
  await press(page, board(page, 'sketch'), 'n', 'Space', 'ArrowUp');
  await expect(sketch).toHaveAttribute('ask', '1');
  await expect(sketch).toHaveAttribute('complex', 'whole');
  await reset.press('Enter');
  await expect(reset).toBeDisabled();
  await expect(board(page, 'sketch')).toBeFocused();
  await expect(sketch).toHaveAttribute('show', 'complex lists names');
  await expect(sketch).toHaveAttribute('landmarks', '30,22 86,18 62,62');
  expect(await sketch.getAttribute('complex')).toBeNull();
  expect(await sketch.getAttribute('ask')).toBeNull();
  await expect(sketch.getByLabel('Only Delaunay simplices')).toBeChecked();
  await expect(sketch.getByLabel('Voronoi cells')).not.toBeChecked();
  await settled(sketch);
  await expect(said(page, 'sketch')).toBeEmpty();
  await press(page, board(page, 'sketch'), 'Control+z');
  await expect(sketch).toHaveAttribute('landmarks', /^30,23 /);
});

test('a board can be cleared, and says what to do then', async ({ page }) => {
  await openPage(page, 'sketch');
  const sketch = page.locator('#sketch');
  await sketch.getByRole('button', { name: 'Clear' }).click();
  await expect(sketch.locator('.readout')).toHaveText(
    'The board is empty: put landmarks and witnesses on it.',
  );
  await expect(sketch.locator('.landmark, .witness')).toHaveCount(0);
  await sketch.getByRole('button', { name: 'Undo' }).click();
  await expect(sketch.locator('.landmark')).toHaveCount(3);
  // Elsewhere a figure is what the text is about.
  await openPage(page, 'witnesses');
  await expect(page.locator('#first').getByRole('button', { name: 'Clear' })).toBeHidden();
});

test('the first page speaks of what it shows, and of edges that flip', async ({ page }) => {
  await openPage(page, 'voronoi');
  await expect(page.locator('#map .readout')).toHaveText('7 landmarks: 12 Delaunay edges, 6 triangles.');
  await expect(page.locator('#square .readout')).toHaveText('4 landmarks.');
  // The counts stay; an edge flips.
  await press(page, board(page, 'map'), 'p', ...times(2, 'Shift+ArrowLeft'));
  await expect(spoken(page, 'map')).toHaveText(
    'Landmark p7 at 44, 38. 7 landmarks: 12 Delaunay edges, 6 triangles. Now p3 p5 instead of p4 p7.',
  );
  await openPage(page, 'order-two');
  await expect(page.locator('#circle .readout')).toHaveText(
    /^4 landmarks, 27 witnesses: 5 cells of order two\. The complex has 4 edges and 0 triangles/,
  );
});

test('why not is shown as well as named: the witness of a face, the face, the disc and who is in it', async ({
  page,
}) => {
  await openPage(page, 'witnesses');
  const corner = page.locator('#corner');
  await corner.evaluate((sketch) => sketch.setAttribute('ask', '1 2 3'));
  await expect(said(page, 'corner')).toHaveText(
    /one of its faces is not: edge p1 p2\..* closest miss is w\d/,
  );
  await expect(corner.locator('.missing')).toHaveCount(1);
  await expect(corner.locator('.lit')).toHaveCount(1);
  await openPage(page, 'order-two');
  const circle = page.locator('#circle');
  await circle.evaluate((sketch) => {
    sketch.setAttribute('nu', '1,4,4');
    sketch.setAttribute('ask', '1 2 4');
  });
  await expect(said(page, 'circle')).toHaveText(/edge p2 p4 is not in the Delaunay .* holds p3 or p1/);
  await expect(circle.locator('.blocker')).toHaveCount(2);
  // A triangle all of whose edges are there has one disc.
  await openPage(page, 'voronoi');
  const map = page.locator('#map');
  await map.evaluate((sketch) => {
    sketch.setAttribute('offer', 'why');
    sketch.setAttribute('landmarks', '10,10 110,10 60,70 60,30');
    sketch.setAttribute('witnesses', '10,10 110,10 60,70 60,30 60,10 35,40 85,40');
    sketch.setAttribute('nu', '1,4,4');
    sketch.setAttribute('ask', '1 2 3');
  });
  await expect(said(page, 'map')).toHaveText(/the disc through its corners holds p4/);
  await expect(map.locator('.disc')).toHaveCount(1);
  await expect(map.locator('.blocker')).toHaveCount(1);
});

test('the landmark a has one name, seen, heard and typed; other words are refused', async ({ page }) => {
  await openPage(page, 'plateaus');
  const fake = page.locator('#fake');
  await fake.getByRole('button', { name: 'Insert a' }).click();
  await settled(fake);
  const field = fake.getByRole('textbox', { name: /Why/ });
  await field.fill('3 a');
  await field.press('Enter');
  await expect(said(page, 'fake')).toHaveText(/^The edge p3 a is in the complex/);
  await expect(fake).toHaveAttribute('ask', '3 a');
  await field.fill('3 8');
  await field.press('Enter');
  await expect(said(page, 'fake')).toHaveText('Name one to three landmarks from 1 to 7, or a.');
  await field.fill('3 b');
  await field.press('Enter');
  await expect(said(page, 'fake')).toHaveText(/"b" is no landmark/);
  await expect(field).toHaveValue('3 b');
  await fake.getByText('The figure in words').click();
  await expect(fake.locator('.lists')).toContainText('a at 84, 66');
  await expect(fake.locator('.lists')).not.toContainText('p8');
});

test('a question goes with its landmarks: into the link, and through a deletion', async ({ page }) => {
  await page.goto('./course/witnesses.html#first.ask=1_2_3');
  const first = page.locator('#first');
  await settled(first);
  await expect(said(page, 'first')).toHaveText(/^The triangle p1 p2 p3 is/);
  await expect(first.getByRole('textbox', { name: /Why/ })).toHaveValue('1 2 3');
  await press(page, board(page, 'first'), 'n', 'Delete');
  await expect(first).toHaveAttribute('ask', '1 2');
  await expect(said(page, 'first')).toHaveText(/^The edge p1 p2 is/);
  await page.getByRole('button', { name: 'Link to this state' }).first().click();
  await expect(page).toHaveURL(/#first\.landmarks=82,12_100,58_40,66&.*first\.ask=1_2/);
});

test('an empty field is no number', async ({ page }) => {
  await openPage(page, 'order-two');
  const circle = page.locator('#circle');
  await circle.getByLabel('ν₁').fill('');
  await circle.getByLabel('ν₁').press('Enter');
  await circle.getByLabel('ν₁').blur();
  await expect(circle.getByRole('alert')).toHaveText(/nu="1,\?,3" was not understood/);
  expect(await circle.getAttribute('nu')).toBeNull();
});

test('before the core has answered nothing is lost, and it is said', async ({ page }) => {
  const release = await holdCore(page);
  await page.goto('./course/farthest.html');
  const film = page.locator('#film');
  await expect(film.locator('.readout')).toHaveText('Computing…');
  await film.getByRole('button', { name: 'Next landmark' }).click();
  await expect(film).toHaveAttribute('step', '4');
  await answer(page, 'next-landmark', '5');
  await verdict(page, 'next-landmark', 'open', /^Computing…$/);
  release();
  await verdict(page, 'next-landmark', 'right', /w5 is farthest/);
  await expect(film.locator('.readout')).toHaveText('4 landmarks, 24 witnesses.');
});

test('more steps than there are witnesses are all of them, and the next step is one of these', async ({
  page,
}) => {
  await page.goto('./course/curves.html#all.step=200');
  const all = page.locator('#all');
  await settled(all);
  await all.getByRole('button', { name: 'Back' }).click();
  await expect(all).toHaveAttribute('step', '59');
  await settled(all);
  await expect(all.locator('.scale')).toHaveText(/^step 59 /);
  await expect(task(page, 'pieces')).toBeVisible();
});
