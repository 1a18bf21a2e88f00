// Family dilated from the form of the page, its pumping in bars, and the way from one long plateau to the next.
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import type { Page } from '@playwright/test';
import { complaints } from './axe.ts';
import { drop, expect, inFreshProfile, openPaused, root, shown, state, test } from './page.ts';

const bin = fileURLToPath(new URL('../../build/native/bin', import.meta.url));

async function openSettings(page: Page): Promise<void> {
  const settings = page.locator('#settings-fold');
  if ((await settings.getAttribute('open')) === null)
    await page.getByText('Settings', { exact: true }).click();
}

async function fill(page: Page, label: string, text: string): Promise<void> {
  const before = await state(page, 'hash');
  const field = page.locator('.settings').getByLabel(label, { exact: true });
  await field.fill(text);
  await field.press('Enter');
  await expect(root(page)).not.toHaveAttribute('data-hash', before);
  await expect(root(page)).toHaveAttribute('data-run-state', 'finished');
}

/** A torus with the settings open and family dilated chosen, over so many landmarks. */
async function openDilated(page: Page, size: number, steps: number): Promise<void> {
  await openPaused(page, 'torus', size);
  await openSettings(page);
  await fill(page, 'Stop at N', String(steps));
  await page.getByRole('combobox', { name: 'Family', exact: true }).selectOption('dilated');
  await expect(root(page)).toHaveAttribute('data-family', 'dilated');
  await shown(page, 'torus');
}

interface Shared {
  readonly link: string;
  /** The hash that the command of the sheet prints. */
  readonly hash: string;
  readonly command: string;
}

async function shared(page: Page): Promise<Shared> {
  await page.getByRole('button', { name: 'Share' }).click();
  const link = await page.getByRole('textbox', { name: 'Link' }).inputValue();
  const command = await page.getByRole('textbox', { name: 'Command' }).inputValue();
  await page.keyboard.press('Escape');
  const env = { ...process.env, PATH: `${bin}:${process.env['PATH'] ?? ''}` };
  const printed = execFileSync('sh', ['-c', command], { encoding: 'utf8', env, stdio: 'pipe' });
  return { link, command, hash: /^hash ([0-9a-f]{16})$/m.exec(printed)?.[1] ?? printed };
}

test('a cloud in space is followed by family dilated with its settings, which link and session keep', async ({
  page,
}) => {
  await openDilated(page, 900, 60);
  await expect(page.getByRole('status')).toContainText('· dilated');
  await expect(page.getByRole('textbox', { name: 'ν' })).toBeHidden();
  await expect(page.getByLabel('Field')).toBeVisible();
  await expect(page.getByRole('combobox', { name: 'Constants', exact: true })).toHaveValue('usual');
  await expect(page.getByText('Before: automatic family')).toBeVisible();
  const plain = await state(page, 'hash');
  await expect(page.getByRole('textbox', { name: 'ω̄' })).toBeHidden();
  await page.getByLabel('Pumping', { exact: true }).check();
  await expect(page.getByText(/^\d+ of 60 landmarks got a weight/)).toBeVisible();
  await shown(page, 'torus');
  await fill(page, 'ω̄', '0.5');
  await page.getByRole('combobox', { name: 'Slivers', exact: true }).selectOption('normalized');
  await expect(page.getByText('Before: pumping ω̄ 0.5')).toBeVisible();
  await shown(page, 'torus');
  await page.getByRole('combobox', { name: 'Constants', exact: true }).selectOption('theory');
  await expect(page.getByText('Before: dilation 0.2')).toBeVisible();
  await shown(page, 'torus');
  await expect(page.getByRole('textbox', { name: 'Dilation' })).toHaveValue('0.036756427623585226');
  await expect(page.getByRole('textbox', { name: 'ω̄' })).toHaveValue('');
  await fill(page, 'ζ₂', '0.4');
  await expect(page.getByRole('combobox', { name: 'Constants', exact: true })).toHaveValue('own');

  const hash = await state(page, 'hash');
  expect(hash).not.toBe(plain);
  const { link, command, hash: printed } = await shared(page);
  expect(command).toContain(
    '--family dilated --first 0 --steps 60 --dilation 0.036756427623585226 --pump --zeta2 0.4',
  );
  expect(printed).toBe(hash);
  await page.getByText('More formats').click();
  const download = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Session' }).click();
  const bytes = readFileSync(await (await download).path());

  await page.goto('./?sample=none');
  await page.goto(link);
  await shown(page, 'torus');
  expect(await state(page, 'hash')).toBe(hash);
  await expect(page.locator('#zeta2')).toHaveValue('0.4');
  await expect(page.locator('#sliver')).toHaveValue('literal');

  await drop(page, 'torus.plateau', bytes);
  await shown(page, 'torus.plateau');
  expect(await state(page, 'hash')).toBe(hash);
  await expect(page.locator('#constants')).toHaveValue('own');
  await expect(page.locator('#pump')).toBeChecked();
  await openSettings(page);
  await page.getByRole('combobox', { name: 'Constants', exact: true }).selectOption('usual');
  await expect(page.getByLabel('Pumping', { exact: true })).not.toBeChecked();
  await expect(page.locator('#pumps')).toBeHidden();
  await expect(page.getByRole('textbox', { name: 'ω̄' })).toBeHidden();
});

test('constants are named what they are, and what pumping was told waits for it to be on again', async ({
  page,
}) => {
  await openDilated(page, 900, 40);
  const constants = page.getByRole('combobox', { name: 'Constants', exact: true });
  const pumping = page.getByLabel('Pumping', { exact: true });
  const slivers = page.getByRole('combobox', { name: 'Slivers', exact: true });
  await expect(page.getByRole('textbox', { name: 'ρ' })).toBeHidden();
  await constants.selectOption('theory');
  await expect(pumping).toBeChecked();
  await shown(page, 'torus');
  await expect(constants).toHaveValue('theory');
  await slivers.selectOption('normalized');
  await expect(constants).toHaveValue('own');
  await slivers.selectOption('literal');
  await expect(constants).toHaveValue('theory');
  await fill(page, 'ω̄', '0.125');
  await fill(page, 'ζ₂', '0.4');
  await expect(constants).toHaveValue('own');
  await shown(page, 'torus');
  await pumping.uncheck();
  await expect(page.locator('#pumps')).toBeHidden();
  await expect(constants).toHaveValue('own');
  await pumping.check();
  await expect(page.getByRole('textbox', { name: 'ω̄' })).toHaveValue('0.125');
  await expect(page.getByRole('textbox', { name: 'ζ₂' })).toHaveValue('0.4');
  await slivers.selectOption('normalized');
  await constants.selectOption('usual');
  await expect(pumping).not.toBeChecked();
  await shown(page, 'torus');
  await expect(constants).toHaveValue('usual');
  await pumping.check();
  await expect(slivers).toHaveValue('literal');
  await expect(page.getByRole('textbox', { name: 'ω̄' })).toHaveValue('');
});

test('what is wrong with a setting is said beside it, and what was shown stays', async ({ page }) => {
  await openDilated(page, 300, 30);
  const hash = await state(page, 'hash');
  const alert = page.getByRole('alert');
  for (const [label, text, sentence] of [
    ['Dilation', '7', /The dilation must be from 0 to 1/],
    ['Dilation', '-1', /The dilation takes a number from 0 on/],
    ['Stop at length', '99', /least length of a plateau must be from 0 to 50/],
  ] as const) {
    const field = page.getByRole('textbox', { name: label, exact: true });
    await field.fill(text);
    await field.press('Enter');
    await expect(alert).toContainText(sentence);
    // Right behind the setting.
    const beside = page.locator('.setting', { has: field }).locator('+ #trouble');
    await expect(beside).toBeVisible();
    expect(await state(page, 'hash')).toBe(hash);
    await field.fill('');
    await field.press('Enter');
    await expect(alert).toBeHidden();
    await expect(root(page)).not.toHaveAttribute('aria-busy');
    await shown(page, 'torus');
  }
  expect(await state(page, 'hash')).toBe(hash);
  // What is wrong elsewhere is said above.
  await drop(page, 'ragged.xyz', '0 0 0\n1 1\n');
  await expect(page.locator('.notices').getByRole('alert')).toContainText(/line 2/i);
});

test('families that a cloud cannot have are not offered', async ({ page }) => {
  const offered = (): Promise<string[]> => page.locator('#family option:enabled').allTextContents();
  await openPaused(page, 'circle-noise', 60);
  expect(await offered()).toEqual(['Automatic', 'Delaunay', 'Witness', 'Dilated']);
  await openPaused(page, 'clifford', 300);
  expect(await offered()).toEqual(['Automatic', 'Witness', 'Dilated']);
  // Automatic is dilated there, and has its settings.
  await openSettings(page);
  await page.getByLabel('Pumping', { exact: true }).check();
  await expect(page.locator('#pump-words')).toContainText('landmarks got a weight');
  await page.getByRole('combobox', { name: 'Family', exact: true }).selectOption('witness');
  await expect(root(page)).toHaveAttribute('data-family', 'witness');
  await expect(page.getByRole('textbox', { name: 'Dilation' })).toBeHidden();
  await expect(page.locator('#pumps')).toBeHidden();
  await page.getByRole('combobox', { name: 'Distances', exact: true }).selectOption('l1');
  await expect.poll(offered).toEqual(['Automatic', 'Witness']);
});

test('pumping is drawn: bars, numbers on the axis, a table, and a warning', async ({ page }) => {
  await openDilated(page, 600, 80);
  await page.getByLabel('Pumping', { exact: true }).check();
  await shown(page, 'torus');
  const panel = page.locator('#pumps');
  await expect(panel.locator('#pump-words')).toContainText(/^\d+ of 80 landmarks got a weight/);
  const chart = panel.getByRole('img', { name: /before and after pumping/ });
  await expect(chart.locator('rect')).toHaveCount(24);
  const numbers = await chart.locator('text').allTextContents();
  expect(numbers.length).toBeGreaterThanOrEqual(5);
  for (const number of numbers) expect(number).toMatch(/^[\d.]+( \+)?$/);
  await panel.getByRole('button', { name: 'sliver measure' }).hover();
  await expect(page.getByRole('tooltip')).toContainText('Flat ones, near 0');
  await page.mouse.move(0, 0);
  await expect(panel.getByText('As a table')).toBeVisible();
  await panel.getByText('As a table').focus();
  await page.keyboard.press('Enter');
  const cells = (await panel.locator('tbody td').allTextContents()).map(Number);
  expect(cells).toHaveLength(24);
  for (const place of [0, 1]) {
    const counts = cells.filter((_, i) => i % 2 === place);
    expect(counts.reduce((sum, count) => sum + count)).toBe(80);
  }
  await expect(panel.getByRole('row', { name: /^thresholds found [1-9]/ })).toBeVisible();
  // A bar is as high as its number of the highest one's.
  const heights = await chart
    .locator('rect')
    .evaluateAll((bars) => bars.map((bar) => Number(bar.getAttribute('height'))));
  const most = Math.max(...cells);
  const tallest = Math.max(...heights);
  heights.forEach((height, i) => expect(height).toBeCloseTo((tallest * (cells[i] ?? NaN)) / most, 6));
  const said = await panel.locator('#pump-words').textContent();
  const amplitude = Number(/amplitude is ([\d.]+)\.$/.exec(said ?? '')?.[1]);
  const warning = panel.getByText(/on a weight is more than half of the distance/);
  if (amplitude > 0.5) await expect(warning).toBeVisible();
  else await expect(warning).toBeHidden();
  for (const colorScheme of ['light', 'dark'] as const) {
    await page.emulateMedia({ colorScheme });
    expect(await complaints(page)).toEqual([]);
  }
});

test('a run stops at a long plateau, goes on to the next by button and key, and says when there is none', async ({
  page,
  browser,
}) => {
  await openPaused(page, 'torus', 400);
  const whole = await state(page, 'hash');
  await openSettings(page);
  await fill(page, 'Stop at length', '0.4');
  await expect(page.getByText('Stopped at a plateau of length 0.400.')).toBeVisible();
  const first = Number(await state(page, 'steps'));
  expect(first).toBeLessThan(400);
  const next = page.getByRole('button', { name: 'Next significant plateau' });
  // The plateau at which it ended is behind once it was looked at.
  const ended = async (before: number): Promise<number> => {
    await expect(root(page)).toHaveAttribute('data-run-state', 'finished');
    await expect.poll(async () => Number(await state(page, 'steps'))).toBeGreaterThan(before);
    await expect(root(page)).toHaveAttribute('data-run-state', 'finished');
    return Number(await state(page, 'steps'));
  };
  await page.getByRole('slider', { name: 'Step' }).fill(String(first));
  await next.click();
  const second = await ended(first);
  const spoken = page.locator('#spoken');
  await expect(spoken).toContainText(/^Plateau: /);
  await expect(page.locator('.cards button[aria-current]')).toBeVisible();

  const { link, command, hash } = await shared(page);
  expect(command).toContain('--min-length 0.4 --nth 2');
  expect(hash).toBe(await state(page, 'hash'));
  const other = await inFreshProfile(browser, link);
  await shown(other, 'torus');
  expect(await state(other, 'steps')).toBe(String(second));
  expect(await state(other, 'hash')).toBe(hash);
  await other.context().close();

  await page.locator('h1').click();
  const words = page.locator('#walk-words');
  for (let presses = 0; presses < 20; ++presses) {
    await page.keyboard.press('n');
    // The words stand there until the next one is found, and stay where there is none.
    await expect(words).not.toContainText('Computing on');
    if (await words.isVisible()) break;
  }
  const none = 'No further plateau of length 0.400 or more: the run has come to its end.';
  await expect(words).toHaveText(none);
  await expect(spoken).toHaveText(none);
  expect(await state(page, 'steps')).toBe('400');
  expect(await state(page, 'hash')).toBe(whole);
  // Another way leaves it.
  await page.keyboard.press('Home');
  await expect(words).toBeHidden();
  await next.click();
  await expect(page.locator('.cards button[aria-current]')).toBeVisible();
});

test('the way on is left by playing, and a run that stops nowhere is walked along', async ({ page }) => {
  await page.goto('./?sample=torus&n=4000');
  await expect(root(page)).toHaveAttribute('data-run-state', 'running');
  const next = page.getByRole('button', { name: 'Next significant plateau' });
  await next.click();
  await expect(root(page)).toHaveAttribute('data-playing', 'false');
  await expect(page.locator('.cards button[aria-current]').first()).toBeVisible();
  const step = Number(await state(page, 'step'));
  await page.getByRole('button', { name: 'Play' }).click();
  await expect(root(page)).toHaveAttribute('data-playing', 'true');
  await expect.poll(async () => Number(await state(page, 'step'))).toBeGreaterThan(step);
  await expect(page.locator('#walk-words')).toBeHidden();
});
