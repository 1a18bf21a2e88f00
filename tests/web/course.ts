// What all tests of the course do: open a page, answer by keyboard, read what is said.
import type { Locator, Page } from '@playwright/test';
import { expect } from './page.ts';

export async function openPage(page: Page, file: string): Promise<void> {
  await page.goto(`./course/${file}.html`);
  for (const sketch of await page.locator('plane-sketch').all()) await settled(sketch);
}

/** Until the core has said all about the sketch. */
export async function settled(sketch: Locator): Promise<void> {
  await expect(sketch).toHaveAttribute('data-betti', /^\d/);
  await expect(sketch).not.toHaveAttribute('data-busy', '');
}

/** Scrolls to a view, which then computes, and waits for its end. */
export async function finished(page: Page, id: string): Promise<void> {
  const view = page.locator(`plateau-view#${id}`);
  await view.scrollIntoViewIfNeeded();
  await expect(view.locator('.view')).toHaveAttribute('data-run-state', 'finished');
}

export const task = (page: Page, name: string): Locator => page.locator(`form[data-task="${name}"]`);
export const board = (page: Page, id: string): Locator => page.locator(`#${id} svg.board`);

/** Answers by keyboard alone and presses Check; '' where the figure is the answer. */
export async function answer(page: Page, name: string, text: string): Promise<void> {
  const form = task(page, name);
  const radio = form.locator(`input[type=radio][value="${text}"]`);
  if ((await radio.count()) > 0) {
    await radio.focus();
    await page.keyboard.press('Space');
  } else if (text !== '') {
    await form.getByRole('textbox').last().focus();
    await page.keyboard.press('ControlOrMeta+a');
    await page.keyboard.type(text);
  }
  await form.getByRole('button', { name: 'Check' }).focus();
  await page.keyboard.press('Enter');
}

export async function verdict(
  page: Page,
  name: string,
  kind: 'right' | 'wrong' | 'open',
  reason: RegExp,
): Promise<void> {
  await expect(task(page, name).locator('.verdict')).toHaveText(reason);
  await expect(task(page, name)).toHaveAttribute('data-verdict', kind);
}

export async function press(page: Page, target: Locator, ...keys: string[]): Promise<void> {
  await target.focus();
  for (const key of keys) await page.keyboard.press(key);
}

export const times = (count: number, key: string): string[] => Array.from({ length: count }, () => key);

/** Keeps the core from the page until the answer is called. */
export async function holdCore(page: Page): Promise<() => void> {
  let release = (): void => undefined;
  const held = new Promise<void>((resolve) => (release = resolve));
  await page.route('**/*.wasm', async (route) => {
    await held;
    await route.continue();
  });
  return release;
}
