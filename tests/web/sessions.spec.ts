import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { viewOf } from '../../web/src/model/view-state.ts';
import type { Page } from '@playwright/test';
import { drop, expect, openPaused, root, shown, state, test, torusText } from './page.ts';
import { torusFile } from './scan-files.ts';

const command = fileURLToPath(new URL('../../build/native/bin/plateau', import.meta.url));

test('a session that the command saved is dropped and runs with its own options', async ({ page }) => {
  const folder = mkdtempSync(join(tmpdir(), 'plateau-'));
  const [points, session] = [join(folder, 'points.xyz'), join(folder, 'torus.plateau')];
  writeFileSync(points, torusText(200));
  execFileSync(command, ['run', points, '--family', 'delaunay', '--steps', '70', '--session', session]);
  await openPaused(page, 'torus', 120);
  await drop(page, 'torus.plateau', readFileSync(session));
  await shown(page, 'torus.plateau');
  expect(await state(page, 'steps')).toBe('70');
});

test('a session that the page saved comes back at its step, as it was looked at', async ({ page }) => {
  await openPaused(page, 'torus', 200);
  await page.getByRole('slider', { name: 'Step' }).fill('60');
  await page.getByLabel('Axis of 1/ε').selectOption('linear');
  await page.locator('#shape').focus();
  await page.keyboard.press('ArrowRight');
  const hash = await state(page, 'hash');
  await page.getByText('More formats').click();
  const download = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Session' }).click();
  const file = await download;
  expect(file.suggestedFilename()).toBe('torus.plateau');
  const bytes = readFileSync(await file.path());

  await page.goto('./?sample=none');
  await drop(page, 'torus.plateau', bytes);
  await shown(page, 'torus.plateau');
  expect(await state(page, 'hash')).toBe(hash);
  expect(await state(page, 'step')).toBe('60');
  await expect(page.getByLabel('Axis of 1/ε')).toHaveValue('linear');
  // Its settings can be changed as those of any points.
  await page.getByText('Settings', { exact: true }).click();
  await page.getByRole('combobox', { name: 'Family' }).selectOption('delaunay');
  await expect(page.locator('main')).toHaveAttribute('data-family', 'delaunay');
  await shown(page, 'torus.plateau');
  expect(await state(page, 'hash')).not.toBe(hash);
});

/** The file that the page saves. */
async function saved(page: Page): Promise<Buffer> {
  const more = page.getByText('More formats');
  if (!(await page.getByRole('button', { name: 'Session' }).isVisible())) await more.click();
  const download = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Session' }).click();
  return readFileSync(await (await download).path());
}

/** The full tests take a scan to its noise. */
const FULL = process.env['PLATEAU_FULL'] === '1';
const SCAN = FULL ? { points: 100_000, steps: '' } : { points: 20_000, steps: '1500' };

test(`a scan of ${SCAN.points} points comes back in a fresh profile: hash, step and camera`, async ({
  page,
  browser,
}) => {
  test.setTimeout(FULL ? 3_600_000 : 240_000);
  const ended = { timeout: FULL ? 1_500_000 : 90_000 };
  await page.goto('./?sample=none');
  await page.getByLabel('Open point cloud').setInputFiles(torusFile(SCAN.points));
  await expect(root(page)).toHaveAttribute('data-source', `torus-${SCAN.points}.ply`);
  if (SCAN.steps !== '') {
    await page.getByText('Settings', { exact: true }).click();
    await page.getByLabel('Stop at N').fill(SCAN.steps);
    await page.getByLabel('Stop at N').press('Enter');
    await expect(root(page)).toHaveAttribute('data-steps', SCAN.steps);
  }
  await expect(root(page)).toHaveAttribute('data-run-state', 'finished', ended);
  await page.getByRole('slider', { name: 'Step' }).fill('777');
  await page.locator('#shape').focus();
  for (const key of ['ArrowRight', 'ArrowRight', 'ArrowUp', '+']) await page.keyboard.press(key);
  const session = await saved(page);
  // Twelve bytes a point: single precision loses nothing of it.
  expect(session.length).toBeLessThan(12 * SCAN.points + 2_000);

  const context = await browser.newContext({ viewport: { width: 760, height: 560 } });
  const other = await context.newPage();
  await other.goto('./?sample=none');
  await drop(other, 'scan.plateau', session);
  await expect(root(other)).toHaveAttribute('data-source', 'scan.plateau');
  await expect(root(other)).toHaveAttribute('data-run-state', 'finished', ended);
  for (const key of ['hash', 'steps', 'step']) expect(await state(other, key)).toBe(await state(page, key));
  expect(await state(other, 'step')).toBe('777');
  // Saved once more it is the same file: its points, settings, step and camera.
  expect((await saved(other)).equals(session)).toBe(true);
  await context.close();
});

test('a view that makes no sense is left out', () => {
  expect(viewOf('{"version":1,"axis":"linear","pose":[1,2,3,4,5,6]}')).toEqual({
    axis: 'linear',
    pose: [1, 2, 3, 4, 5, 6],
  });
  for (const text of ['', 'x', '[]', 'null', '{"pose":[1,2],"axis":7}', '{"pose":[1,2,3,4,5,"6"]}'])
    expect(viewOf(text)).toEqual({ axis: 'log' });
});

test('a session beside another run: what the sheet asks for goes before its own settings', async ({
  page,
}) => {
  const folder = mkdtempSync(join(tmpdir(), 'plateau-'));
  const [points, session] = [join(folder, 'points.xyz'), join(folder, 'mine.plateau')];
  writeFileSync(points, torusText(200));
  execFileSync(command, ['run', points, '--family', 'delaunay', '--steps', '70', '--session', session]);
  await openPaused(page, 'torus', 120);
  const second = page.getByRole('group', { name: 'Run B' });
  const compareWith = async (fields: Readonly<Record<string, string>>): Promise<void> => {
    await page.getByRole('button', { name: 'Compare', exact: true }).click();
    const sheet = page.getByRole('dialog', { name: 'Compare' });
    await drop(page, 'mine.plateau', readFileSync(session));
    for (const [label, value] of Object.entries(fields)) {
      const field = sheet.getByLabel(label);
      if ((await field.evaluate((element) => element.localName)) === 'select')
        await field.selectOption(value);
      else await field.fill(value);
    }
    await sheet.getByRole('button', { name: 'Compare', exact: true }).click();
    await expect(second).toHaveAttribute('data-run-state', 'finished');
    await expect(second).toHaveAttribute('data-steps', '70');
  };
  await compareWith({});
  await expect(second).toContainText('family delaunay');
  await page.getByRole('button', { name: 'Share' }).click();
  const sheet = page.getByRole('dialog', { name: 'Share' });
  await expect(sheet).toContainText('The link holds both runs');
  await expect(sheet).toContainText(/They print the same numbers, and the same hashes: \w{16} and \w{16}\./);
  const commands = await sheet.getByRole('textbox', { name: 'Command' }).inputValue();
  expect(commands).toContain("plateau run 'mine.plateau' --hash");
  await page.keyboard.press('Escape');
  await page.getByRole('button', { name: 'Close comparison' }).click();
  await compareWith({ Family: 'witness', 'First landmark': '5' });
  await expect(second).toContainText('family witness · ν 1, 6, 6, 4 · first landmark 5');
});
