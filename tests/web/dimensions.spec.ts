// Clouds without three coordinates of their own, and distances that are not Euclidean.
import { createWriteStream } from 'node:fs';
import { once } from 'node:events';
import type { Page } from '@playwright/test';
import type { ShownFamily } from '../../web/src/worker/protocol.ts';
import { drop, expect, openPaused, root, shown, state, test } from './page.ts';

const SHOWN_FAMILIES: readonly ShownFamily[] = ['witness', 'delaunay', 'surface', 'dilated'];
const FULL = process.env['PLATEAU_FULL'] === '1';

/** Points on the Clifford torus in four dimensions, from a fixed sequence. */
function cliffordText(size: number): string {
  const golden = 2 * Math.PI * 0.6180339887;
  return Array.from({ length: size }, (_, i) => {
    const [u, v] = [i * golden, (2 * Math.PI * i) / size];
    return [Math.cos(u), Math.sin(u), Math.cos(v), Math.sin(v)].map((x) => x.toFixed(9)).join(',');
  }).join('\n');
}

/** Points with whole coordinates, each once. */
const GRID = Array.from({ length: 60 }, (_, i) => [(i * 7) % 11, (i * 5) % 13, i % 4] as const);
const apart = (a: readonly number[], b: readonly number[]): number =>
  a.reduce((sum, value, axis) => sum + Math.abs(value - (b[axis] ?? 0)), 0);

async function openClifford(page: Page): Promise<void> {
  await page.goto('./?sample=none');
  await drop(page, 'clifford.csv', cliffordText(400));
  await page.getByLabel('Which columns').fill('1, 2, 3, 4');
  await page.getByRole('button', { name: 'Open with these' }).click();
  await shown(page, 'clifford.csv');
}

async function choose(page: Page, label: string, option: string): Promise<void> {
  const settings = page.locator('#settings-fold');
  if ((await settings.getAttribute('open')) === null)
    await page.getByText('Settings', { exact: true }).click();
  await page.getByRole('combobox', { name: label, exact: true }).selectOption(option);
}

test('points of four dimensions are drawn by a projection that says what it keeps, and turns', async ({
  page,
}) => {
  await openClifford(page);
  await expect(page.getByRole('status')).toContainText(/β \d+, \d+, 0, 0 · dilated/);
  await expect(page.getByText('β₃', { exact: true })).toBeVisible();
  const note = page.getByText(/^A projection: it keeps \d+ % of the spread\.$/);
  await expect(note).toHaveText('A projection: it keeps 75 % of the spread.');

  const right = page.getByRole('combobox', { name: 'Axis to the right' });
  const up = page.getByRole('combobox', { name: 'Axis upwards' });
  await expect(right.locator('option')).toHaveText([1, 2, 3, 4].map((axis) => `axis ${axis} (25 %)`));
  await right.selectOption('1');
  await expect(up).toHaveValue('0');
  const rows = (): Promise<string | null> => root(page).getAttribute('data-turned');
  await expect.poll(rows).toBe('0');
  await page.locator('h1').click();
  await page.keyboard.press('d');
  await expect(page.getByRole('checkbox', { name: 'Turn through dimensions' })).toBeChecked();
  await expect.poll(async () => Number(await rows())).toBeGreaterThan(0);
  await page.keyboard.press('d');
  const stood = await rows();
  await page.waitForTimeout(300);
  expect(await rows()).toBe(stood);

  // Three dimensions need no projection.
  await openPaused(page, 'torus', 60);
  await expect(note).toBeHidden();
  await expect(right).toBeHidden();
});

test('a file of distances is asked for, opened and drawn; whole coordinates give the same hash', async ({
  page,
}) => {
  await openPaused(page, 'torus', 60);
  await drop(page, 'grid.csv', GRID.map((point) => point.join(',')).join('\n'));
  await shown(page, 'grid.csv');
  await choose(page, 'Distances', 'l1');
  await expect(root(page)).toHaveAttribute('data-family', 'witness');
  await shown(page, 'grid.csv');
  const hash = await state(page, 'hash');

  const square = GRID.map((a) => GRID.map((b) => apart(a, b)).join(',')).join('\n');
  await drop(page, 'distances.csv', square);
  await expect(page.getByRole('alert')).toContainText('60 columns');
  expect(await state(page, 'source'), 'what was there stays').toBe('grid.csv');
  await page.getByRole('button', { name: 'They are distances' }).click();
  await shown(page, 'distances.csv');
  expect(await state(page, 'hash')).toBe(hash);
  await expect(page.getByText(/^A projection: it keeps \d+ %/)).toBeVisible();
  const metric = page.getByRole('combobox', { name: 'Distances', exact: true });
  await expect(metric).toHaveValue('matrix');
  await expect(metric.locator('option:enabled')).toHaveText(['As in the file']);

  const below = GRID.map((a, i) => [`p${i}`, ...GRID.slice(0, i).map((b) => apart(a, b))].join(',')).join(
    '\n',
  );
  await drop(page, 'named.csv', below);
  await expect(page.getByRole('alert')).toContainText('"p1" where a number should be');
  await expect(page.getByLabel('Which columns')).toBeHidden();
  await page.getByRole('button', { name: 'They are distances' }).click();
  await shown(page, 'named.csv');
  expect(await state(page, 'hash')).toBe(hash);

  await drop(page, 'crooked.csv', square.replace('\n', '\n1,'));
  await page.getByRole('button', { name: 'They are distances' }).click();
  await expect(page.getByRole('alert')).toContainText('Line 2 has 61 distances');
  expect(await state(page, 'source')).toBe('named.csv');
});

test('a large table of distances says what it takes before it is read', async ({ page }, testInfo) => {
  const size = FULL ? 5000 : 1700;
  // Sums of differences of whole numbers.
  const place = (i: number): readonly number[] => [(i * 37) % 101, (i * 59) % 211, (i * 11) % 17];
  const file = testInfo.outputPath('large.csv');
  const out = createWriteStream(file);
  for (let i = 0; i < size; ++i) {
    const row = Array.from({ length: size }, (_, j) => apart(place(i), place(j)));
    if (!out.write(`${row.join(',')}\n`)) await once(out, 'drain');
  }
  out.end();
  await once(out, 'finish');
  await page.goto('./?sample=none');
  await page.getByLabel('Open point cloud').setInputFiles(file);
  await expect(page.getByRole('alert')).toContainText(`${size} columns`);
  const advice = page.getByText(/As distances of [\d,]+ points they would take up to (\d+)\sMB\./);
  await expect(advice).toHaveText(FULL ? /95\sMB/ : /11\sMB/);
  await page.getByRole('button', { name: 'They are distances' }).click();
  await expect(root(page)).toHaveAttribute('data-steps', String(size), { timeout: 240_000 });
  await shown(page, 'large.csv');
});

test('what turns over on its way around is named, with its torsion', async ({ page }) => {
  await openPaused(page, 'sphere', 1500);
  await choose(page, 'Distances', 'projective');
  await expect(root(page)).toHaveAttribute('data-family', 'witness');
  await page.getByRole('textbox', { name: 'ν' }).fill('1, 4, 5, 5');
  await page.getByLabel('Stop at N').fill('60');
  await page.getByLabel('Stop at N').press('Enter');
  const card = page.getByRole('button', { name: /^projective-plane-like shape/ });
  await expect(card).toContainText('torsion: 1, 0, 0 over Z/3');
  await card.click();
  await expect(page.getByRole('status')).toContainText('β 1, 1, 1 · torsion: 1, 0, 0 over Z/3 · witness');
});

test('named hues: differences alone show the circle of hues', async ({ page }) => {
  await openPaused(page, 'colors', 652);
  await expect(page.locator('#metric')).toHaveValue('matrix');
  const cards = page.locator('.cards button');
  // The longest is what a dozen landmarks look like.
  await expect(cards.nth(1)).toContainText('closed curve');
  await expect(cards.nth(1)).toHaveAttribute('data-betti', '1,1,0');
  await expect(page.getByText('Noise', { exact: true })).toBeHidden();
});

test('a Klein bottle of the gallery is named with its torsion', async ({ page }) => {
  await openPaused(page, 'klein', FULL ? 20_000 : 6000);
  await expect(root(page)).toHaveAttribute('data-family', 'dilated');
  const card = page.getByRole('button', { name: /^Klein-bottle-like shape/ }).first();
  await expect(card).toContainText('torsion: 1, 1, 0, 0 over Z/3');
  // Every family that can be shown has its band in the diagram.
  const bands = await page.evaluate((families) => {
    const style = getComputedStyle(document.body);
    return families.map((family) => style.getPropertyValue(`--band-${family}`).trim());
  }, SHOWN_FAMILIES);
  for (const band of bands) expect(band).toMatch(/^#[0-9a-f]{6}$/);
});

test('other distances are a setting; each asks for what it needs, and undo leads back', async ({ page }) => {
  await openPaused(page, 'swiss-roll', 400);
  const family = root(page);
  await expect(page.getByLabel('Neighbors')).toBeHidden();
  await choose(page, 'Distances', 'geodesic');
  await expect(family).toHaveAttribute('data-family', 'witness');
  await expect(page.getByLabel('Neighbors')).toBeVisible();
  await page.getByLabel('Neighbors').fill('2');
  await page.getByLabel('Neighbors').press('Enter');
  await expect(page.getByRole('alert')).toContainText('neighbors');

  await choose(page, 'Distances', 'periodic');
  await expect(page.getByRole('alert')).toContainText('box');
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(page.getByRole('combobox', { name: 'Distances', exact: true })).toHaveValue('euclidean');
});
