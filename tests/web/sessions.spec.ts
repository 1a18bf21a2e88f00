import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { viewOf } from '../../web/src/model/view-state.ts';
import { drop, expect, openPaused, shown, state, test, torusText } from './page.ts';

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

test('a view that makes no sense is left out', () => {
  expect(viewOf('{"version":1,"axis":"linear","pose":[1,2,3,4,5,6]}')).toEqual({
    axis: 'linear',
    pose: [1, 2, 3, 4, 5, 6],
  });
  for (const text of ['', 'x', '[]', 'null', '{"pose":[1,2],"axis":7}', '{"pose":[1,2,3,4,5,"6"]}'])
    expect(viewOf(text)).toEqual({ axis: 'log' });
});
