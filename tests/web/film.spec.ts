import { expect, openPaused, root, state, test } from './page.ts';

test.describe('the film', () => {
  test.beforeEach(async ({ page }) => {
    await openPaused(page, 'torus', 250);
  });

  test('goes step by step, forwards and back', async ({ page }) => {
    await page.getByRole('slider', { name: 'Step' }).fill('40');
    await expect(root(page)).toHaveAttribute('data-step', '40');
    await page.getByRole('button', { name: 'Step' }).click();
    await expect(root(page)).toHaveAttribute('data-step', '41');
    await page.getByRole('button', { name: 'Back' }).click();
    await page.getByRole('button', { name: 'Back' }).click();
    await expect(root(page)).toHaveAttribute('data-step', '39');
  });

  test('plays and pauses', async ({ page }) => {
    await page.getByRole('slider', { name: 'Step' }).fill('1');
    await page.getByRole('button', { name: 'Play' }).click();
    await expect.poll(async () => Number(await state(page, 'step'))).toBeGreaterThan(2);
    await page.getByRole('button', { name: 'Pause' }).click();
    const stopped = await state(page, 'step');
    await page.waitForFunction(
      (from) => performance.now() > from + 700,
      await page.evaluate(() => performance.now()),
    );
    expect(await state(page, 'step')).toBe(stopped);
    await expect(page.getByRole('button', { name: 'Play' })).toBeVisible();
  });

  test('begins anew when it is played at its end', async ({ page }) => {
    await page.keyboard.press('End');
    await expect(root(page)).toHaveAttribute('data-step', '250');
    await page.getByRole('button', { name: 'Play' }).click();
    await expect.poll(async () => Number(await state(page, 'step'))).toBeLessThan(20);
  });

  test('is dragged along the diagram', async ({ page }) => {
    const diagram = page.getByRole('img', { name: /Betti numbers/ });
    await diagram.scrollIntoViewIfNeeded();
    const box = await diagram.boundingBox();
    if (!box) throw new Error('no diagram');
    const at = (share: number): [number, number] => [box.x + box.width * share, box.y + box.height / 2];
    await page.mouse.move(...at(0.3));
    await page.mouse.down();
    const first = Number(await state(page, 'step'));
    await page.mouse.move(...at(0.6), { steps: 4 });
    const second = Number(await state(page, 'step'));
    await page.mouse.move(...at(2), { steps: 2 });
    await page.mouse.up();
    expect(first).toBeGreaterThan(1);
    expect(second).toBeGreaterThan(first);
    await expect(root(page)).toHaveAttribute('data-step', '250');
    await page.mouse.move(...at(0.3));
    await expect(root(page)).toHaveAttribute('data-step', '250');
  });

  test('goes to the middle of a plateau by its card', async ({ page }) => {
    const card = page.locator('.cards button[data-betti="1,2,1"]').first();
    await card.click();
    const step = Number(await state(page, 'step'));
    expect(step).toBeGreaterThanOrEqual(Number(await card.getAttribute('data-first')));
    expect(step).toBeLessThanOrEqual(Number(await card.getAttribute('data-last')));
    expect(await state(page, 'betti')).toBe('1,2,1');
    expect(await state(page, 'family')).toBe('surface');
    await expect(card).toHaveAttribute('aria-current', 'step');
    await expect(page.getByRole('status')).toContainText('β 1, 2, 1');
  });

  test('goes by keyboard', async ({ page }) => {
    // Asked for early: the browser is told to hand the chooser over, and that takes its time.
    const chooser = page.waitForEvent('filechooser');
    const at = async (step: number) => expect(root(page)).toHaveAttribute('data-step', String(step));
    await page.keyboard.press('Home');
    await at(1);
    await page.keyboard.press('ArrowRight');
    await at(2);
    await page.keyboard.press('Shift+ArrowRight');
    await at(12);
    await page.keyboard.press('Shift+ArrowLeft');
    await at(2);
    await page.keyboard.press('ArrowLeft');
    await at(1);
    await page.keyboard.press('p');
    expect(Number(await state(page, 'step'))).toBeGreaterThan(1);
    await page.keyboard.press('Home');
    await page.keyboard.press('Space');
    await expect(page.getByRole('button', { name: 'Pause' })).toBeVisible();
    await page.keyboard.press('Space');
    await expect(page.getByRole('button', { name: 'Play' })).toBeVisible();
    await page.keyboard.press('o');
    await chooser;
    // In a text field keys are text; on a focused slider arrows act once.
    await page.getByText('Settings', { exact: true }).click();
    await page.getByRole('textbox', { name: 'ν' }).press('p');
    const slider = page.getByRole('slider', { name: 'Step' });
    await slider.fill('30');
    await slider.press('ArrowRight');
    await at(31);
  });
});

test('the status always tells step, ε and Betti numbers, at most once a second while playing', async ({
  page,
}) => {
  await page.goto('./?sample=torus&n=250');
  const status = page.getByRole('status');
  await expect(page.getByRole('button', { name: 'Pause' })).toBeVisible();
  const whole = /^step [\d,]+ of 250 · ε \S+ · β \d+, \d+, \d+ · (surface|delaunay)$/;
  await expect(status).toHaveText(whole);
  const changes = await status.evaluate(
    (element) =>
      new Promise<{ count: number; texts: string[] }>((resolve) => {
        const texts: string[] = [];
        const observer = new MutationObserver(() => texts.push(element.textContent));
        observer.observe(element, { childList: true, characterData: true, subtree: true });
        setTimeout(() => {
          observer.disconnect();
          resolve({ count: texts.length, texts });
        }, 3500);
      }),
  );
  expect(changes.count).toBeGreaterThan(0);
  expect(changes.count).toBeLessThanOrEqual(4);
  for (const text of changes.texts) expect(text).toMatch(whole);
  await page.keyboard.press('Space');
  await expect(status).toContainText(`step ${await state(page, 'step')} of`);
  await page.keyboard.press('End');
  await expect(root(page)).toHaveAttribute('data-step', await state(page, 'steps'));
  await expect(status).toContainText(`step ${await state(page, 'steps')} of`);
});
