import { BAD_FILES } from './bad-files.ts';
import { drop, expect, fileOf, openPaused, root, state, test } from './page.ts';

test('every bad file is answered by a sentence, and the film plays on', async ({ page }) => {
  await openPaused(page, 'torus', 400);
  await page.getByLabel('Speed').selectOption('0.25');
  await page.getByRole('slider', { name: 'Step' }).fill('1');
  await page.getByRole('button', { name: 'Play' }).click();
  const alert = page.getByRole('alert');
  const { source, hash, steps } = await root(page).evaluate((element) => ({ ...element.dataset }));
  for (const [index, { what, name, content, told }] of BAD_FILES.entries()) {
    await test.step(what, async () => {
      const before = Number(await state(page, 'step'));
      if (index % 2 === 0) await drop(page, name, content);
      else await page.getByLabel('Open point cloud').setInputFiles(fileOf(name, content));
      await expect(alert).toContainText(`${name}: `);
      await expect(root(page)).not.toHaveAttribute('aria-busy');
      const sentence = ((await alert.textContent()) ?? '').slice(name.length + 2);
      expect(sentence).toMatch(told);
      expect(sentence).toMatch(/^[A-Z0-9].+\.$/);
      expect(await root(page).evaluate((element) => ({ ...element.dataset }))).toMatchObject({
        source,
        hash,
        steps,
        runState: 'finished',
        playing: 'true',
      });
      expect(Number(await state(page, 'step'))).toBeGreaterThanOrEqual(before);
      await page.getByRole('button', { name: 'Dismiss' }).click();
      await expect(alert).toBeHidden();
    });
  }
  expect(Number(await state(page, 'step'))).toBeGreaterThan(1);
  await page.getByRole('slider', { name: 'Step' }).fill('50');
  await expect(root(page)).toHaveAttribute('data-step', '50');
});
