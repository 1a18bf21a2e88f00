import { expect, root, state, test } from './page.ts';

test('the page opens on the helix, playing, and computes it to the end', async ({ page }) => {
  test.setTimeout(240_000);
  await page.goto('./');
  await expect(page.getByRole('button', { name: 'Pause' })).toBeVisible();
  await expect(root(page)).toHaveAttribute('data-source', 'helix');
  await expect(page.getByRole('status')).toContainText('of 3,000');
  const before = Number(await state(page, 'step'));
  await expect.poll(async () => Number(await state(page, 'step'))).toBeGreaterThan(before + 1);
  await expect(root(page)).toHaveAttribute('data-run-state', 'finished', { timeout: 200_000 });
  expect(await state(page, 'steps')).toBe('3000');
  const cards = page.locator('.cards button');
  await expect(
    cards.filter({ hasText: 'torus-like closed surface: 1 component, 2 loops, 1 void' }),
  ).toHaveCount(1);
  await expect(cards.filter({ hasText: 'closed curve: 1 component, 1 loop' }).first()).toBeVisible();
});

test('with reduced motion the film waits', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await page.goto('./?sample=torus&n=150');
  await expect(root(page)).toHaveAttribute('data-run-state', 'finished');
  await expect(page.getByRole('button', { name: 'Play' })).toBeVisible();
  expect(await state(page, 'step')).toBe('1');
});
