import type { Page } from '@playwright/test';
import { cloudFiles, scatteredPoints } from './cloud-files.ts';
import { drop, expect, fileOf, openPaused, root, shown, state, test, torusText } from './page.ts';

/** That of the command for the same points: tests/core/formats_test.cpp. */
const HASH = 'b02b080a890c8b85';
const files = cloudFiles(scatteredPoints(150));

test.beforeEach(async ({ page }) => {
  await openPaused(page, 'torus', 60);
});

test('every format gives the same hash as the command, by drop and by file', async ({ page }) => {
  for (const { what, name, bytes } of files) {
    await test.step(what, async () => {
      await drop(page, `dropped-${name}`, bytes);
      await shown(page, `dropped-${name}`);
      expect(await state(page, 'hash')).toBe(HASH);
      await page.getByLabel('Open point cloud').setInputFiles(fileOf(name, bytes));
      await shown(page, name);
      expect(await state(page, 'hash')).toBe(HASH);
      await expect(page.getByRole('alert')).toBeHidden();
    });
  }
});

test('the file dialog offers what can be read', async ({ page }) => {
  const accepted = (await page.getByLabel('Open point cloud').getAttribute('accept'))?.split(',') ?? [];
  for (const { name } of files) expect(accepted).toContain(name.replace(/.*\./, '.'));
});

test('points without coordinates are left out, and the page says how many', async ({ page }) => {
  const rows = torusText(60).split('\n').slice(1);
  const header =
    'VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 31\nHEIGHT 2\nDATA ascii\n';
  await drop(page, 'organized.pcd', `${header}nan nan nan\nnan nan nan\n${rows.join('\n')}`);
  await shown(page, 'organized.pcd');
  expect(await state(page, 'steps')).toBe('60');
  await expect(page.getByText('Left out 2 of 62 points')).toBeVisible();
});

test('an array with more columns asks which are the coordinates', async ({ page }) => {
  const header = "{'descr': '|u1', 'fortran_order': False, 'shape': (3, 4), }".padEnd(117) + '\n';
  const values = '\x00\x01\x02\x09\x03\x01\x02\x09\x00\x05\x02\x09';
  const bytes = Uint8Array.from(Buffer.from(`\x93NUMPY\x01\x00\x76\x00${header}${values}`, 'latin1'));
  await drop(page, 'wide.npy', bytes);
  await expect(page.getByRole('alert')).toContainText('4 columns');
  await page.getByRole('button', { name: 'Open with these' }).click();
  await shown(page, 'wide.npy');
  expect(await state(page, 'steps')).toBe('3');
});

/** Through the browser's own clipboard and keyboard. */
async function pasteText(page: Page, text: string): Promise<void> {
  await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
  await page.evaluate((content) => navigator.clipboard.writeText(content), text);
  await page.keyboard.press('Control+V');
}

test('pasted text is opened like a file', async ({ page }) => {
  await pasteText(page, torusText(80));
  await shown(page, 'Pasted points');
  expect(await state(page, 'steps')).toBe('80');
  // Its content tells the format.
  const off = files.find(({ what }) => what === 'off');
  await pasteText(page, Buffer.from(off?.bytes ?? []).toString());
  await expect(root(page)).toHaveAttribute('data-steps', '150');
  await expect(root(page)).toHaveAttribute('data-run-state', 'finished');
  expect(await state(page, 'hash')).toBe(HASH);
});

test('pasted words are told to be none, and what was there stays', async ({ page }) => {
  await pasteText(page, 'Dear reader,\nthis is no point cloud.\n');
  await expect(page.getByRole('alert')).toContainText('Pasted points');
  expect(await state(page, 'source')).toBe('torus');
});

test('a pasted file is opened', async ({ page }) => {
  const found = files.find(({ what }) => what === 'npy by rows');
  await page.evaluate(
    (bytes) => {
      const clipboardData = new DataTransfer();
      clipboardData.items.add(new File([Uint8Array.from(bytes)], 'copied.npy'));
      document.body.dispatchEvent(new ClipboardEvent('paste', { clipboardData, bubbles: true }));
    },
    [...(found?.bytes ?? [])],
  );
  await shown(page, 'copied.npy');
  expect(await state(page, 'hash')).toBe(HASH);
});

test('a field for text keeps what is pasted into it', async ({ page }) => {
  await page.getByText('Settings', { exact: true }).click();
  const field = page.getByRole('textbox', { name: 'ν' });
  await field.focus();
  await pasteText(page, '1, 3, 4, 4');
  await expect(field).toHaveValue('1, 3, 4, 4');
  await expect(root(page)).not.toHaveAttribute('aria-busy');
  expect(await state(page, 'source')).toBe('torus');
  await expect(page.getByRole('alert')).toBeHidden();
});
