import { readFile } from 'node:fs/promises';
import { drop, expect, fileOf, test, torusText } from './page.ts';

/** What a visitor comes to do, by what can be read on the page alone; each takes a few actions and under a minute. */
test.describe('a new visitor', () => {
  test.use({ viewport: { width: 1280, height: 800 } });
  test.setTimeout(60_000);

  test('finds the curve on the torus', async ({ page }) => {
    await page.goto('./');
    const side = page.getByRole('region', { name: 'What it sees' });
    const curve = side.getByRole('button', {
      name: /^closed curve.*1 component, 1 loop.*ε 0\.11\S* → 0\.0/,
    });
    await curve.click();
    await expect(page.getByRole('status')).toContainText('β 1, 1, 0');
    await expect(curve).toHaveAttribute('aria-current', 'step');
  });

  test('reads at which scales the double torus has genus 2', async ({ page }) => {
    await page.goto('./');
    await page.getByRole('button', { name: 'Gallery' }).click();
    const gallery = page.getByRole('dialog', { name: 'Gallery' });
    await gallery.getByRole('button', { name: /^Double torus.*genus 2/ }).click();
    const side = page.getByRole('region', { name: 'What it sees' });
    const card = side.getByRole('button', {
      name: /^double-torus-like closed surface.*1 component, 4 loops/,
    });
    await expect(card).toHaveAccessibleName(/ε 0\.1[34]\d? → 0\.0\d+/);
  });

  test('loads a scan and saves its surface', async ({ page }) => {
    await page.goto('./');
    await page.getByLabel('Open point cloud').setInputFiles(fileOf('scan.xyz', torusText(1500)));
    // Nothing more to choose: the page goes to the longest plateau itself.
    await expect(page.getByRole('status')).toContainText(/of 1,500 .* β 1, 2, 1 · surface/);
    const download = page.waitForEvent('download');
    await page.getByRole('button', { name: 'Mesh (PLY)' }).click();
    const file = await download;
    expect(file.suggestedFilename()).toMatch(/^scan-step-\d+\.ply$/);
    expect(await readFile(await file.path(), 'utf8')).toMatch(
      /^ply\nformat ascii 1\.0\n[^]*element face [1-9]/,
    );
  });

  test('compares two ν at the same scale, with both answers in sight', async ({ page }) => {
    await page.goto('./?sample=helix&n=800');
    const side = page.getByRole('region', { name: 'What it sees' });
    await side.getByRole('button', { name: /^torus-like closed surface/ }).click();
    const status = page.getByRole('status');
    const epsilon = async (): Promise<string> => /ε \S+/.exec((await status.textContent()) ?? '')?.[0] ?? '';
    const before = await epsilon();
    await page.getByText('Settings', { exact: true }).click();
    const nu = page.getByRole('textbox', { name: 'ν' });
    await nu.fill('1,2,3,4');
    await nu.press('Enter');
    const earlier = page.getByRole('region', { name: 'Before: ν 1, 6, 6, 4' });
    await expect(earlier).toContainText(/torus-like closed surface, ε 0\.4\S* → 0\.1/);
    await expect(status).toContainText('delaunay');
    await expect.poll(epsilon).toBe(before);
    await expect(side.getByRole('button', { name: /^torus-like closed surface/ })).toHaveCount(0);
    // And back: what was now is before.
    await page.getByRole('button', { name: 'Undo' }).click();
    await expect(page.getByRole('region', { name: 'Before: ν 1, 2, 3, 4' })).toBeVisible();
    await expect(status).toContainText('β 1, 2, 1 · surface');
    await expect.poll(epsilon).toBe(before);
    // Other points are no settings: there is nothing to compare.
    await drop(page, 'points.xyz', torusText(60));
    await expect(status).toContainText('of 60');
    await expect(page.getByText(/^Before: /)).toBeHidden();
  });

  test('recovers from a bad file', async ({ page }) => {
    await page.goto('./?sample=torus&n=200');
    await expect(page.getByRole('status')).toContainText('of 200');
    await drop(page, 'scan.xyz', '0 0 0\n1 0 0\n0 1\n');
    await expect(page.getByRole('alert')).toHaveText('scan.xyz: Line 3 has 2 columns, but line 1 has 3.');
    await expect(page.getByText('Nothing was changed here. Mend the file')).toBeVisible();
    await expect(page.getByRole('status')).toContainText('of 200');
    await drop(page, 'scan.xyz', torusText(90));
    await expect(page.getByRole('status')).toContainText('of 90');
    await expect(page.getByRole('alert')).toBeHidden();
  });
});
