// Links hold what is shown; whoever opens one sees it, in a browser that has never been here.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { drop, expect, inFreshProfile, linkOf, openPaused, shown, state, test, torusText } from './page.ts';

const bin = fileURLToPath(new URL('../../build/native/bin', import.meta.url));

function hashOf(printed: string): string {
  return /^hash ([0-9a-f]{16})$/m.exec(printed)?.[1] ?? printed;
}

test('a shape: link and command give the same hash, the link the same step and view', async ({
  page,
  browser,
}) => {
  await openPaused(page, 'torus', 240);
  await page.getByText('Settings', { exact: true }).click();
  await page.getByRole('combobox', { name: 'Family' }).selectOption('delaunay');
  await page.getByRole('textbox', { name: 'ν' }).fill('1, 5, 6, 4');
  await page.getByRole('textbox', { name: 'ν' }).press('Enter');
  await expect(page.locator('main')).toHaveAttribute('data-family', 'delaunay');
  await shown(page, 'torus');
  await page.getByRole('slider', { name: 'Step' }).fill('77');
  await page.getByLabel('Axis of 1/ε').selectOption('linear');
  const hash = await state(page, 'hash');
  const link = await linkOf(page);
  expect(link).toContain('#v=1&shape=torus&n=240&family=delaunay&nu=1,5,6,4');
  const command = await page.getByRole('textbox', { name: 'Command' }).inputValue();
  const printed = execFileSync('sh', ['-c', command], {
    encoding: 'utf8',
    env: { ...process.env, PATH: `${bin}:${process.env['PATH'] ?? ''}` },
  });
  expect(hashOf(printed)).toBe(hash);

  const other = await inFreshProfile(browser, link);
  await shown(other, 'torus');
  expect(await state(other, 'hash')).toBe(hash);
  expect(await state(other, 'step')).toBe('77');
  await expect(other.getByLabel('Axis of 1/ε')).toHaveValue('linear');
  await expect(other.locator('#nu')).toHaveValue('1, 5, 6, 4');
  // A link to the same page is followed without loading it again.
  await other.evaluate(() => (location.hash = '#v=1&shape=circle-noise&n=120'));
  await shown(other, 'circle-noise');
  await other.context().close();
});

test('dropped points travel in the link, rounded, and it says so', async ({ page, browser }) => {
  await openPaused(page, 'torus', 60);
  await drop(page, 'mine.xyz', torusText(400));
  await shown(page, 'mine.xyz');
  const link = await linkOf(page);
  await expect(page.getByText(/400 points travel inside it, rounded to steps of [\d.]+/)).toBeVisible();
  expect(link.length).toBeLessThan(32_768);

  const other = await inFreshProfile(browser, link);
  await shown(other, 'mine.csv');
  const hash = await state(other, 'hash');
  expect(hash).not.toBe(await state(page, 'hash'));
  // Shared once more, nothing is rounded again; as a session the command computes the same.
  expect(new URL(await linkOf(other)).hash).toContain(/points=.*/.exec(link)?.[0] ?? 'no points');
  await other.keyboard.press('Escape');
  await other.getByText('More formats').click();
  const download = other.waitForEvent('download');
  await other.getByRole('button', { name: 'Session' }).click();
  const session = join(mkdtempSync(join(tmpdir(), 'plateau-')), 'mine.plateau');
  writeFileSync(session, readFileSync(await (await download).path()));
  const printed = execFileSync(join(bin, 'plateau'), ['run', session, '--hash'], { encoding: 'utf8' });
  expect(hashOf(printed)).toBe(hash);
  await other.context().close();
});

test('too many points are a session; a link that was cut off is a sentence', async ({ page, browser }) => {
  await openPaused(page, 'torus', 60);
  await drop(page, 'many.xyz', torusText(7000));
  await expect(page.locator('main')).toHaveAttribute('data-source', 'many.xyz');
  await page.getByRole('button', { name: 'Share' }).click();
  await expect(page.getByText('7,000 points do not fit into a link')).toBeVisible();
  await expect(page.getByRole('textbox', { name: 'Link' })).toBeHidden();
  const download = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Save the session' }).click();
  expect((await download).suggestedFilename()).toBe('many.plateau');

  const base = new URL(page.url());
  base.search = '';
  const broken = await inFreshProfile(browser, `${base.href}#v=1&name=mine&points=3.-14.0.0.0.AAAA`);
  await expect(broken.getByRole('alert')).toContainText('damaged');
  await expect(broken.locator('main')).toHaveAttribute('data-run-state', 'empty');
  const odd = await inFreshProfile(browser, `${base.href}#v=1&shape=torus&n=100&field=6`);
  await expect(odd.getByRole('alert')).toContainText('prime');
  await broken.context().close();
  await odd.context().close();
});
