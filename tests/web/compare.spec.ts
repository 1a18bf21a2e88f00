// Two runs side by side under one playhead.
import { readFileSync } from 'node:fs';
import type { Browser, Locator, Page } from '@playwright/test';
import { complaints } from './axe.ts';
import { drop, expect, inFreshProfile, linkOf, openPaused, root, state, test, torusText } from './page.ts';

test.use({ viewport: { width: 1000, height: 700 } });

const run = (page: Page, letter: 'A' | 'B'): Locator => page.getByRole('group', { name: `Run ${letter}` });
const film = (page: Page): Locator => page.locator('#compared-film');

async function data(place: Locator, key: string): Promise<string> {
  return (await place.getAttribute(`data-${key}`)) ?? '';
}

/** Fills in the sheet and waits until both runs are complete. */
async function compare(page: Page, fields: Readonly<Record<string, string>> = {}): Promise<void> {
  await page.getByRole('button', { name: 'Compare', exact: true }).click();
  const sheet = page.getByRole('dialog', { name: 'Compare' });
  for (const [label, value] of Object.entries(fields)) {
    const field = sheet.getByLabel(label);
    if ((await field.evaluate((element) => element.localName)) === 'select') await field.selectOption(value);
    else await field.fill(value);
  }
  await sheet.getByRole('button', { name: 'Compare', exact: true }).click();
  await complete(page);
}

async function complete(page: Page): Promise<void> {
  await expect(page.locator('#open-compare')).not.toHaveAttribute('aria-busy');
  for (const letter of ['A', 'B'] as const)
    await expect(run(page, letter)).toHaveAttribute('data-run-state', 'finished');
}

/** ε of every step of a run, as its table says. */
async function epsilons(page: Page, address: string): Promise<number[]> {
  await page.goto(address);
  await expect(root(page)).toHaveAttribute('data-run-state', 'finished');
  const download = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Betti numbers (CSV)' }).click();
  const rows = readFileSync(await (await download).path(), 'utf8')
    .trim()
    .split('\n');
  return rows.slice(1).map((row) => Number(row.split(',')[2]));
}

/** Where a step begins along ln(1/ε); where ε is 0, a little after the last one. */
function places(table: readonly number[]): number[] {
  const last = Math.min(...table.filter((epsilon) => epsilon > 0));
  return table.map((epsilon) => (epsilon > 0 ? -Math.log(epsilon) : 0.06 - Math.log(last)));
}

/** What each run has to show where the playhead stands: the last step that begins there or before. */
async function inStep(page: Page, tables: Readonly<Record<'A' | 'B', readonly number[]>>): Promise<void> {
  const scale = Number(await data(film(page), 'scale'));
  // One axis: the playhead is one line through both diagrams.
  const lines = page.locator('#compared-film .playhead');
  await expect
    .poll(() => lines.evaluateAll((all) => new Set(all.map((line) => line.style.transform)).size))
    .toBe(1);
  await expect(lines).toHaveCount(2);
  for (const letter of ['A', 'B'] as const) {
    const begun = places(tables[letter]).filter((place) => place <= scale + 1e-12).length;
    const step = Math.max(1, begun);
    expect(Number(await data(run(page, letter), 'step')), `${letter} at ln(1/ε) ${scale}`).toBe(step);
    expect(Number(await data(run(page, letter), 'epsilon'))).toBe(tables[letter][step - 1]);
  }
}

test('one playhead: each run shows the step that it has at that ε', async ({ page }) => {
  const tables = {
    A: await epsilons(page, './?sample=torus&n=300'),
    B: await epsilons(page, './?sample=sphere&n=260'),
  };
  await openPaused(page, 'torus', 300);
  await page.getByRole('slider', { name: 'Step' }).fill('40');
  await compare(page, { 'Points of run B': 'sphere', 'How many': '260' });
  // It stands at the scale that the page was at.
  await expect(run(page, 'A')).toHaveAttribute('data-step', '40');
  await inStep(page, tables);
  // Dragged in either diagram, pressed, and by the slider.
  for (const [letter, part] of [
    ['A', 0.3],
    ['B', 0.55],
    ['B', 0.8],
    ['A', 0.12],
  ] as const) {
    const box = await page.getByRole('img', { name: `run ${letter}` }).boundingBox();
    if (!box) throw new Error('no diagram');
    await page.mouse.click(box.x + box.width * part, box.y + box.height / 2);
    await inStep(page, tables);
  }
  const slider = page.getByRole('slider', { name: 'Scale' });
  for (const place of [1, 77, 333, 559]) {
    await slider.fill(String(place));
    await inStep(page, tables);
  }
  // A key goes to the next scale at which one of them has a step, and back.
  await slider.fill('200');
  const scales = [...places(tables.A), ...places(tables.B)].sort((a, b) => a - b);
  for (const [key, by] of [
    ['ArrowRight', 1],
    ['ArrowRight', 2],
    ['ArrowLeft', 1],
    ['Shift+ArrowRight', 11],
  ] as const) {
    await page.keyboard.press(key);
    expect(Number(await data(film(page), 'scale'))).toBeCloseTo(scales[199 + by] ?? 0, 12);
    await inStep(page, tables);
  }
  // A card of either run goes to its middle.
  await page
    .getByRole('region', { name: 'Plateaus of run B' })
    .getByRole('button', { name: /^sphere-like/ })
    .first()
    .click();
  await expect(run(page, 'B')).toHaveAttribute('data-betti', '1,0,1');
  await inStep(page, tables);
  // The film moves both.
  await page.keyboard.press('Home');
  await inStep(page, tables);
  await page.getByRole('button', { name: 'Play' }).click();
  for (const letter of ['A', 'B'] as const)
    await expect.poll(async () => Number(await data(run(page, letter), 'step'))).toBeGreaterThan(4);
  await page.getByRole('button', { name: 'Pause' }).click();
  await inStep(page, tables);
  await page.keyboard.press('End');
  await expect(run(page, 'A')).toHaveAttribute('data-step', '300');
  await expect(run(page, 'B')).toHaveAttribute('data-step', '260');
});

test('the same points with another ν: equal landmarks, other answers, shapes that turn as one', async ({
  page,
}) => {
  await openPaused(page, 'torus', 300);
  await page.locator('.cards button[data-betti="1,2,1"]').first().click();
  const hash = await state(page, 'hash');
  const step = await state(page, 'step');
  await compare(page, { ν: '1, 2, 3, 4' });
  expect(await data(run(page, 'A'), 'hash')).toBe(hash);
  expect(await data(run(page, 'B'), 'hash')).not.toBe(hash);
  for (const key of ['step', 'epsilon'])
    expect(await data(run(page, 'B'), key)).toBe(await data(run(page, 'A'), key));
  await expect(run(page, 'A')).toHaveAttribute('data-betti', '1,2,1');
  await expect(run(page, 'A')).toContainText('ν 1, 6, 6, 4');
  await expect(run(page, 'B')).toContainText('ν 1, 2, 3, 4');
  await expect(run(page, 'B')).not.toHaveAttribute('data-betti', '1,2,1');
  await expect(run(page, 'B')).toContainText(/first landmark 0 · \d+\sMB in use/);
  await expect(page.getByRole('status')).toContainText(
    new RegExp(`^ε .* · A: step ${step} of 300 .* · B: step ${step} of 300 `),
  );
  // Both runs are in one worker.
  expect(page.workers()).toHaveLength(1);

  const second = page.getByRole('application', { name: 'Shape of run B' });
  const pictures = async (): Promise<string[]> => {
    await page.evaluate(
      () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))),
    );
    return Promise.all(
      [page.locator('#shape'), second].map(async (shape) => (await shape.screenshot()).toString('base64')),
    );
  };
  const [a0, b0] = await pictures();
  await second.focus();
  for (let i = 0; i < 3; ++i) await page.keyboard.press('ArrowRight');
  const [a1, b1] = await pictures();
  expect([a1 === a0, b1 === b0]).toEqual([false, false]);
  await page.getByRole('checkbox', { name: 'Turn both' }).uncheck();
  await second.focus();
  for (let i = 0; i < 3; ++i) await page.keyboard.press('ArrowRight');
  const [a2, b2] = await pictures();
  expect([a2 === a1, b2 === b1]).toEqual([true, false]);
  // Layers are those of both.
  await page.keyboard.press('4');
  const [a3, b3] = await pictures();
  expect([a3 === a2, b3 === b2]).toEqual([false, false]);
});

test('another first landmark; a dropped file; the page comes back with nothing lost', async ({ page }) => {
  await openPaused(page, 'torus', 200);
  await page.getByText('Settings', { exact: true }).click();
  await page.getByLabel('Stop at N').fill('150');
  await page.getByLabel('Stop at N').press('Enter');
  await expect(root(page)).toHaveAttribute('data-steps', '150');
  await expect(root(page)).toHaveAttribute('data-run-state', 'finished');
  await page.getByRole('slider', { name: 'Step' }).fill('60');
  const hash = await state(page, 'hash');
  const cards = await page.locator('#cards button').allTextContents();
  await compare(page, { 'First landmark': '7', ν: '' });
  await expect(run(page, 'B')).toContainText('first landmark 7');
  // What is not asked for is as in run A.
  await expect(run(page, 'B')).toHaveAttribute('data-steps', '150');
  expect(await data(run(page, 'B'), 'hash')).not.toBe(hash);
  await expect(page.getByRole('button', { name: 'Undo' })).toBeHidden();

  await drop(page, 'mine.xyz', torusText(180));
  await expect(run(page, 'B')).toContainText('mine.xyz · 180 points');
  await complete(page);
  expect(await data(run(page, 'A'), 'hash')).toBe(hash);
  const scale = await data(film(page), 'scale');
  await drop(page, 'ragged.xyz', '0 0 0\n1 1 1\n1 0\n');
  await expect(page.getByRole('alert')).toContainText(/line 3/i);
  await expect(run(page, 'B')).toContainText('mine.xyz');
  expect(await data(film(page), 'scale')).toBe(scale);
  // A question that the second file raises is answered for the second run.
  await drop(page, 'wide.csv', '1,0,0,9\n2,1,0,9\n3,1,1,8\n4,0,1,7\n5,0.5,0.5,3\n');
  await page.getByLabel('Which columns').fill('2, 3');
  await page.getByRole('button', { name: 'Open with these' }).click();
  await expect(run(page, 'B')).toContainText('wide.csv · 5 points');
  await complete(page);
  expect(await data(run(page, 'A'), 'hash')).toBe(hash);
  await drop(page, 'mine.xyz', torusText(180));
  await expect(run(page, 'B')).toContainText('mine.xyz · 180 points');
  await complete(page);

  await page.getByRole('slider', { name: 'Scale' }).fill('90');
  const step = await data(run(page, 'A'), 'step');
  await page.getByRole('button', { name: 'Close comparison' }).click();
  await expect(run(page, 'B')).toHaveCount(0);
  await expect(page.getByRole('button', { name: 'Compare', exact: true })).toBeFocused();
  expect(await state(page, 'hash')).toBe(hash);
  expect(await state(page, 'step')).toBe(step);
  expect(await page.locator('#cards button').allTextContents()).toEqual(cards);
  await expect(page.locator('.shape canvas')).toHaveCount(1);
  await page.getByRole('button', { name: 'Step', exact: true }).click();
  expect(await state(page, 'step')).toBe(String(Number(step) + 1));
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(root(page)).toHaveAttribute('data-steps', '200');
});

async function opened(browser: Browser, link: string): Promise<Page> {
  const page = await inFreshProfile(browser, link);
  await complete(page);
  return page;
}

const SHOWN = ['hash', 'step', 'epsilon', 'betti'] as const;
const shownIn = async (page: Page): Promise<string[]> =>
  Promise.all((['A', 'B'] as const).flatMap((letter) => SHOWN.map((key) => data(run(page, letter), key))));

test('a link opens the comparison again, with both hashes', async ({ page, browser }) => {
  await openPaused(page, 'torus', 240);
  await compare(page, { Family: 'delaunay', ν: '1, 2, 3, 4' });
  await page.getByRole('slider', { name: 'Scale' }).fill('131');
  await film(page).getByLabel('Axis of 1/ε').selectOption('linear');
  const seen = await shownIn(page);
  const link = await linkOf(page);
  expect(link).toContain('&b.same=1&b.family=delaunay&b.nu=1,2,3,4&b.scale=');
  expect(await page.getByRole('textbox', { name: 'Command' }).inputValue()).toMatch(
    / --hash; plateau sample torus .* --nu 1,2,3,4 --hash$/,
  );
  const other = await opened(browser, link);
  expect(await shownIn(other)).toEqual(seen);
  expect(await data(film(other), 'scale')).toBe(await data(film(page), 'scale'));
  await expect(film(other).getByLabel('Axis of 1/ε')).toHaveValue('linear');
  await expect(other.getByRole('checkbox', { name: 'Turn both' })).toBeChecked();

  // Points of one's own on the other side travel, too.
  await drop(other, 'mine.xyz', torusText(150));
  await expect(run(other, 'B')).toContainText('mine.xyz');
  await complete(other);
  const third = await opened(browser, await linkOf(other));
  await expect(run(third, 'B')).toContainText('mine.csv · 150 points');
  expect((await shownIn(third))[0]).toBe(seen[0]);
  // Rounded once, they are the same for good.
  const fourth = await opened(browser, await linkOf(third));
  expect(await shownIn(fourth)).toEqual(await shownIn(third));
  // A link to one run ends the comparison.
  await fourth.evaluate(() => (location.hash = '#v=1&shape=circle-noise&n=120'));
  await expect(root(fourth)).toHaveAttribute('data-source', 'circle-noise');
  await expect(run(fourth, 'B')).toHaveCount(0);
  for (const each of [other, third, fourth]) await each.context().close();
});

test('by keyboard alone: opened, changed, moved, closed', async ({ page }) => {
  await openPaused(page, 'torus', 150);
  const { keyboard } = page;
  await page.locator('h1').click();
  await keyboard.press('v');
  const sheet = page.getByRole('dialog', { name: 'Compare' });
  await expect(sheet).toBeVisible();
  await sheet.getByLabel('ν').focus();
  await keyboard.press('Control+a');
  await keyboard.type('1, x');
  await keyboard.press('Enter');
  await expect(sheet.getByRole('alert')).toContainText('whole numbers');
  await keyboard.press('Control+a');
  await keyboard.type('1, 3, 4, 4');
  await keyboard.press('Enter');
  await expect(sheet).toBeHidden();
  await complete(page);
  const scale = async (): Promise<number> => Number(await data(film(page), 'scale'));
  await keyboard.press('Home');
  const first = await scale();
  await keyboard.press('p');
  const plateau = await scale();
  expect(plateau).toBeGreaterThan(first);
  await keyboard.press('l');
  await expect(film(page).getByLabel('Axis of 1/ε')).toHaveValue('linear');
  await keyboard.press('Space');
  await expect(film(page)).toHaveAttribute('data-playing', 'true');
  await keyboard.press('Space');
  await expect(film(page)).toHaveAttribute('data-playing', 'false');
  await keyboard.press('Control+z');
  // Every control of the comparison is on the way of Tab.
  const names: string[] = [];
  await page.getByRole('button', { name: 'Compare', exact: true }).focus();
  for (let i = 0; i < 40; ++i) {
    await keyboard.press('Tab');
    names.push(
      await page.evaluate(() => {
        const at = document.activeElement;
        return at?.id || (at?.getAttribute('aria-label') ?? at?.textContent ?? '').slice(0, 24);
      }),
    );
  }
  for (const name of ['shape', 'Shape of run B: arrow key', 'Scale', 'Axis of 1/ε', 'close-compare'])
    expect(
      names.some((each) => name.startsWith(each) || each.startsWith(name)),
      name,
    ).toBe(true);
  await page.getByRole('button', { name: 'Close comparison' }).focus();
  await keyboard.press('Enter');
  await expect(run(page, 'B')).toHaveCount(0);
  await expect(page.getByLabel('Axis of 1/ε')).toHaveValue('linear');
  await keyboard.press('v');
  await sheet.getByRole('button', { name: 'Compare', exact: true }).focus();
  await keyboard.press('Enter');
  await complete(page);
  await keyboard.press('v');
  await expect(run(page, 'B')).toHaveCount(0);
});

/** How much of the right end of a diagram is hatched. */
async function hatching(page: Page, letter: 'A' | 'B'): Promise<number> {
  return page.getByRole('img', { name: `run ${letter}` }).evaluate((diagram) => {
    const canvas = diagram.querySelector('canvas');
    const hatch = getComputedStyle(diagram).getPropertyValue('--hatch').trim();
    const wanted = [1, 3, 5].map((at) => parseInt(hatch.slice(at, at + 2), 16));
    if (!canvas) return 0;
    const [from, width] = [Math.round(canvas.width * 0.9), Math.round(canvas.width * 0.07)];
    const pixels = canvas.getContext('2d')?.getImageData(from, 0, width, canvas.height).data ?? [];
    let count = 0;
    for (let i = 0; i + 3 < pixels.length; i += 4)
      if (wanted.every((value, k) => Math.abs(value - (pixels[i + k] ?? 0)) < 12)) count += 1;
    return count;
  });
}

test('what is not computed yet is hatched on both; what has ended is not', async ({ page }) => {
  await page.goto('./?sample=torus&n=60000');
  await expect.poll(async () => Number(await state(page, 'steps'))).toBeGreaterThan(100);
  await page.getByRole('button', { name: 'Compare', exact: true }).click();
  await page.getByRole('dialog').getByRole('button', { name: 'Compare', exact: true }).click();
  for (const letter of ['A', 'B'] as const)
    await expect.poll(() => hatching(page, letter), { message: letter }).toBeGreaterThan(40);
  for (const letter of ['A', 'B'] as const)
    await expect(run(page, letter)).toHaveAttribute('data-run-state', 'running');
  // A playhead beyond what is computed shows the last step that there is, and follows it.
  await page.keyboard.press('End');
  await expect.poll(async () => Number(await data(run(page, 'B'), 'step'))).toBeGreaterThan(20);
  await page.getByRole('button', { name: 'Close comparison' }).click();
  await expect.poll(async () => Number(await state(page, 'steps'))).toBeGreaterThan(400);

  await openPaused(page, 'torus', 150);
  await compare(page, { 'Points of run B': 'sphere', 'How many': '60' });
  await expect.poll(() => hatching(page, 'A')).toBeLessThan(10);
  await expect.poll(() => hatching(page, 'B')).toBeLessThan(10);
});

test('both runs share the memory: where none is left, a sentence says so', async ({ page }) => {
  await page.goto('./?sample=torus&n=150&memory=17');
  await expect(root(page)).toHaveAttribute('data-run-state', 'finished');
  await page.getByRole('button', { name: 'Compare', exact: true }).click();
  await page.getByRole('dialog').getByRole('button', { name: 'Compare', exact: true }).click();
  await expect(page.getByRole('alert')).toContainText(/takes the memory of this page \(17\sMB\)/);
  await expect(run(page, 'B')).toHaveCount(0);
  await expect(page.locator('#open-compare')).not.toHaveAttribute('aria-busy');
});

const SIZES = {
  desktop: { width: 1280, height: 800 },
  narrow: { width: 760, height: 560 },
  phone: { width: 390, height: 844 },
} as const;
const DEVICES = ['desktop', 'narrow', 'phone'] as const;
const FULL = process.env['PLATEAU_FULL'] === '1';

/** `npm run test:full` goes through all of them. */
const QUICKLY = { light: ['desktop', 'phone'], dark: ['narrow'] } as const;

for (const colorScheme of ['light', 'dark'] as const) {
  test(`axe finds nothing, and pictures to look at: ${colorScheme}`, async ({ page }) => {
    await page.emulateMedia({ colorScheme });
    for (const device of FULL ? DEVICES : QUICKLY[colorScheme]) {
      await page.setViewportSize(SIZES[device]);
      await openPaused(page, 'torus', 250);
      await page.locator('.cards button[data-betti="1,2,1"]').first().click();
      await page.getByRole('button', { name: 'Compare', exact: true }).click();
      expect(await complaints(page), `${device}: sheet`).toEqual([]);
      await page.screenshot({ path: `build/screens/${device}-${colorScheme}-compare-sheet.png` });
      await page.keyboard.press('Escape');
      await compare(page);
      expect(await complaints(page), device).toEqual([]);
      expect(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), device).toBe(
        true,
      );
      await page.screenshot({ path: `build/screens/${device}-${colorScheme}-side-by-side.png` });
    }
  });
}
