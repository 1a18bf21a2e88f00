// Links hold what is shown; whoever opens one sees it, in a browser that has never been here.
import type { Page } from '@playwright/test';
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

/** What a shell says to the command. */
function printedBy(command: string, folder = '.'): string {
  return execFileSync('sh', ['-c', command], {
    cwd: folder,
    encoding: 'utf8',
    env: { ...process.env, PATH: `${bin}:${process.env['PATH'] ?? ''}` },
  });
}

/** The command that the sheet offers; none: it is not shown. */
async function commandOf(page: Page): Promise<string | undefined> {
  await page.getByRole('button', { name: 'Share' }).click();
  await expect(page.getByRole('dialog', { name: 'Share' })).toBeVisible();
  const field = page.getByRole('textbox', { name: 'Command' });
  const command = (await field.isVisible()) ? await field.inputValue() : undefined;
  await page.keyboard.press('Escape');
  return command;
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
  expect(hashOf(printedBy(command))).toBe(hash);

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
  // Its file is on no disk.
  expect(await commandOf(other)).toBeUndefined();
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

test('a scan that ended at its noise, and one that was let go on: the command ends there, too', async ({
  page,
}) => {
  let seed = 7;
  const unit = (): number => (seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0) / 2 ** 32;
  const ring = Array.from({ length: 20_000 }, () => 2 * Math.PI * unit())
    .map((angle) => `${Math.cos(angle)} ${Math.sin(angle)}\n`)
    .join('');
  const folder = mkdtempSync(join(tmpdir(), 'plateau-'));
  writeFileSync(join(folder, 'ring.xyz'), ring);
  await openPaused(page, 'torus', 60);
  await drop(page, 'ring.xyz', ring);
  await shown(page, 'ring.xyz');
  expect(Number(await state(page, 'steps'))).toBeLessThan(20_000);
  const command = (await commandOf(page)) ?? '';
  expect(command).toContain('--until noise');
  expect(hashOf(printedBy(command, folder))).toBe(await state(page, 'hash'));
  await page.locator('#run-to-end').click();
  await expect(page.locator('main')).toHaveAttribute('data-steps', '20000');
  await shown(page, 'ring.xyz');
  const whole = (await commandOf(page)) ?? '';
  expect(whole).not.toContain('--until');
  expect(hashOf(printedBy(whole, folder))).toBe(await state(page, 'hash'));
});

test('a session: the command runs it as it was saved; with settings that were cleared there is none', async ({
  page,
}) => {
  const folder = mkdtempSync(join(tmpdir(), 'plateau-'));
  const [points, session] = [join(folder, 'points.xyz'), join(folder, 'mine.plateau')];
  writeFileSync(points, torusText(200));
  const saving = ['--family', 'delaunay', '--nu', '1,5,6,4', '--steps', '70', '--session', session];
  execFileSync(join(bin, 'plateau'), ['run', points, ...saving]);
  await openPaused(page, 'torus', 60);
  await drop(page, 'mine.plateau', readFileSync(session));
  await shown(page, 'mine.plateau');
  const hash = await state(page, 'hash');
  expect(hashOf(printedBy((await commandOf(page)) ?? '', folder))).toBe(hash);
  await page.getByText('Settings', { exact: true }).click();
  await page.locator('#max-steps').fill('');
  await page.locator('#max-steps').press('Enter');
  await expect(page.locator('main')).toHaveAttribute('data-steps', '200');
  await shown(page, 'mine.plateau');
  expect(await state(page, 'hash')).not.toBe(hash);
  expect(await commandOf(page)).toBeUndefined();
});

test('a run that was lost, and pasted points, have no command', async ({ page }) => {
  await openPaused(page, 'torus', 60);
  expect(await commandOf(page)).toBeDefined();
  await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
  await page.evaluate((text) => navigator.clipboard.writeText(text), torusText(80));
  await page.keyboard.press('Control+V');
  await shown(page, 'Pasted points');
  expect(await commandOf(page)).toBeUndefined();
  await page.goto('./?sample=torus&n=40000');
  await expect.poll(async () => Number(await state(page, 'steps'))).toBeGreaterThan(50);
  await page.workers()[0]?.evaluate(() =>
    setTimeout(() => {
      throw new Error('out of bounds');
    }),
  );
  await expect(page.getByRole('alert')).toContainText('out of bounds');
  await expect(page.getByText('Open the points again to go on.')).toBeVisible();
  expect(await commandOf(page)).toBeUndefined();
});

test('of two links in quick succession the later one is followed', async ({ page, browser }) => {
  await openPaused(page, 'torus', 60);
  await drop(page, 'large.xyz', torusText(2000));
  await shown(page, 'large.xyz');
  const link = await linkOf(page);
  const other = await inFreshProfile(browser, `${new URL(link).origin}/#v=1&shape=circle-noise&n=50`);
  await shown(other, 'circle-noise');
  await other.evaluate((hash) => {
    // Unpacking takes its time.
    const { prototype } = ReadableStreamDefaultReader;
    // eslint-disable-next-line @typescript-eslint/unbound-method -- it is called with its reader
    const { read } = prototype;
    Object.assign(prototype, {
      async read(this: ReadableStreamDefaultReader) {
        await new Promise((done) => setTimeout(done, 300));
        return read.call(this);
      },
    });
    location.hash = hash;
    setTimeout(() => (location.hash = '#v=1&shape=sphere&n=70'), 50);
  }, new URL(link).hash);
  await shown(other, 'sphere');
  await other.waitForTimeout(700);
  await shown(other, 'sphere');
  await other.context().close();
});
