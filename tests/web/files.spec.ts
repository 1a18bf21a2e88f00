import { drop, expect, fileOf, openPaused, root, shown, state, test, torusText } from './page.ts';

test.beforeEach(async ({ page }) => {
  await openPaused(page, 'torus', 120);
});

test('a file is opened, and the page goes to its longest plateau', async ({ page }) => {
  await page.getByLabel('Open point cloud').setInputFiles(fileOf('ring.xyz', torusText(200)));
  await shown(page, 'ring.xyz');
  expect(await state(page, 'steps')).toBe('200');
  await expect(page.getByRole('button', { name: 'Play' })).toBeVisible();
  const first = page.locator('.cards button').first();
  await expect(first).toHaveAttribute('aria-current', 'step');
});

test('a file is dropped anywhere', async ({ page }) => {
  await drop(page, 'square.csv', 'x,y\n0,0\n1,0\n1,1\n0,1\n0.5,0\n0.5,1\n0,0.5\n1,0.5\n');
  await shown(page, 'square.csv');
  expect(await state(page, 'steps')).toBe('8');
  expect(await state(page, 'betti')).toMatch(/^\d+,\d+$/);
  await expect(page.getByText('β₂ voids')).toBeHidden();
});

const bad: readonly [string, string, string | Uint8Array, RegExp][] = [
  ['an empty file', 'empty.xyz', '', /empty/i],
  ['a coordinate that is no number', 'nan.xyz', '0 0 0\n1 1 1\n1 nan 0\n', /line 3/i],
  ['rows of different length', 'ragged.xyz', '0 0 0\n1 1 1\n1 0\n', /line 3/i],
  ['one point', 'one.xyz', '1 2 3\n', /point/i],
  ['equal points', 'same.xyz', '1 2 3\n'.repeat(5), /same|equal|identical/i],
  ['a picture', 'picture.xyz', Uint8Array.of(0x89, 0x50, 0x4e, 0x47, 13, 10, 26, 10, 0, 0, 0, 13), /PNG/],
  ['words', 'letter.txt', 'Dear reader,\nthis is no point cloud.\n', /./],
];
for (const [what, name, content, words] of bad) {
  test(`${what}: a sentence, and what was there stays`, async ({ page }) => {
    const before = await root(page).evaluate((element) => ({ ...element.dataset }));
    await page.getByLabel('Open point cloud').setInputFiles(fileOf(name, content));
    const alert = page.getByRole('alert');
    await expect(alert).toContainText(name);
    await expect(alert).toContainText(words);
    await expect(root(page)).not.toHaveAttribute('aria-busy');
    expect(await root(page).evaluate((element) => ({ ...element.dataset }))).toEqual(before);
    await page.getByRole('button', { name: 'Step', exact: true }).click();
    expect(Number(await state(page, 'step'))).toBe(Math.min(120, Number(before['step']) + 1));
    await expect(page.getByLabel('Sample')).toHaveValue('torus');
    // The next good file clears the message.
    await page.getByLabel('Open point cloud').setInputFiles(fileOf('good.xyz', torusText(60)));
    await shown(page, 'good.xyz');
    await expect(alert).toBeHidden();
  });
}

test('a table with more columns asks which are the coordinates', async ({ page }) => {
  const rows = torusText(80)
    .trimEnd()
    .split('\n')
    .slice(1)
    .map((row) => `7 ${row} 255`);
  await page.getByLabel('Open point cloud').setInputFiles(fileOf('wide.csv', rows.join('\n')));
  await expect(page.getByRole('alert')).toContainText('5');
  await page.getByLabel('Which columns').fill('2, 3, 4');
  await page.getByRole('button', { name: 'Open with these' }).click();
  await shown(page, 'wide.csv');
  expect(await state(page, 'steps')).toBe('80');
});

test('family, ν and first landmark make a new run; what makes no sense is told', async ({ page }) => {
  const hashes = new Set([await state(page, 'hash')]);
  const changed = async (): Promise<void> => {
    await expect.poll(async () => hashes.has(await state(page, 'hash'))).toBe(false);
    await expect(root(page)).toHaveAttribute('data-run-state', 'finished');
    hashes.add(await state(page, 'hash'));
  };
  await page.getByText('Settings', { exact: true }).click();
  await page.locator('#family').selectOption('delaunay');
  await changed();
  await expect(page.getByRole('textbox', { name: 'ν' })).toHaveAttribute('placeholder', '1, 6, 6, 4');
  await page.getByRole('textbox', { name: 'ν' }).fill('1, 3, 4, 4');
  await page.getByRole('textbox', { name: 'ν' }).press('Enter');
  await changed();
  await page.locator('#first').fill('17');
  await page.locator('#first').press('Enter');
  await changed();
  await page.getByRole('textbox', { name: 'ν' }).fill('one');
  await page.getByRole('textbox', { name: 'ν' }).press('Enter');
  await expect(page.getByRole('alert')).toContainText('ν');
  await page.getByRole('button', { name: 'Dismiss' }).click();
  await expect(page.getByRole('alert')).toBeHidden();
  expect(hashes.has(await state(page, 'hash'))).toBe(true);
});

test('another sample is chosen from the list', async ({ page }) => {
  await page.getByLabel('Sample').selectOption({ label: 'Noisy circle' });
  await shown(page, 'circle-noise');
  await expect(page.locator('.cards button').first()).toContainText('closed curve');
});
