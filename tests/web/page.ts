import { expect, test as base, type Browser, type Locator, type Page } from '@playwright/test';

/** Every test fails on an error that the page did not mean: console, uncaught, or against the policy. */
export const test = base.extend<{ quiet: void }>({
  quiet: [
    async ({ page }, use) => {
      const complaints: string[] = [];
      page.on('console', (message) => {
        if (message.type() === 'error') complaints.push(message.text());
      });
      page.on('pageerror', (error) => complaints.push(error.message));
      await page.addInitScript(() => {
        document.addEventListener('securitypolicyviolation', (event) => {
          console.error(`policy: ${event.violatedDirective} ${event.blockedURI}`);
        });
      });
      await use();
      expect(complaints).toEqual([]);
    },
    { auto: true },
  ],
});

export { expect };

/** Where the page keeps its state for tests. */
export function root(page: Page): Locator {
  return page.locator('main');
}

export async function state(page: Page, key: string): Promise<string> {
  return (await root(page).getAttribute(`data-${key}`)) ?? '';
}

/** Opens a sample with few points and waits for its end. */
export async function openSample(page: Page, shape: string, size: number, more = ''): Promise<void> {
  await page.goto(`./?sample=${shape}&n=${size}${more}`);
  await expect(root(page)).toHaveAttribute('data-run-state', 'finished');
}

/** The same with the film standing still. */
export async function openPaused(page: Page, shape: string, size: number): Promise<void> {
  await openSample(page, shape, size);
  const pause = page.getByRole('button', { name: 'Pause' });
  if (await pause.isVisible()) await pause.click();
  await expect(root(page)).toHaveAttribute('data-playing', 'false');
}

/** Waits until the page shows what came from a file of this name, to the end. */
export async function shown(page: Page, name: string): Promise<void> {
  await expect(root(page)).toHaveAttribute('data-source', name);
  await expect(root(page)).toHaveAttribute('data-run-state', 'finished');
}

/** Points on a torus as text, from a fixed sequence. */
export function torusText(size: number): string {
  let seed = 12345;
  const unit = (): number => {
    seed = (seed * 1103515245 + 12345) % 2147483648;
    return seed / 2147483648;
  };
  const lines = ['# points on a torus'];
  for (let i = 0; i < size; ++i) {
    const [u, v] = [2 * Math.PI * unit(), 2 * Math.PI * unit()];
    const r = 1 + 0.4 * Math.cos(v);
    lines.push([r * Math.cos(u), r * Math.sin(u), 0.4 * Math.sin(v)].map((x) => x.toFixed(9)).join(' '));
  }
  return lines.join('\n') + '\n';
}

export function fileOf(name: string, content: string | Uint8Array) {
  return { name, mimeType: 'application/octet-stream', buffer: Buffer.from(content) };
}

/** Lets a file fall onto the page, as from a file manager. */
export async function drop(page: Page, name: string, content: string | Uint8Array): Promise<void> {
  const dataTransfer = await page.evaluateHandle(
    ({ fileName, bytes }) => {
      const transfer = new DataTransfer();
      transfer.items.add(new File([Uint8Array.from(bytes)], fileName));
      return transfer;
    },
    { fileName: name, bytes: [...Buffer.from(content)] },
  );
  await page.dispatchEvent('body', 'drop', { dataTransfer });
}

/** The link that the page offers for what it shows. */
export async function linkOf(page: Page): Promise<string> {
  await page.getByRole('button', { name: 'Share' }).click();
  await expect(page.getByRole('dialog', { name: 'Share' })).toBeVisible();
  return page.getByRole('textbox', { name: 'Link' }).inputValue();
}

/** The link in a browser that has never been here. */
export async function inFreshProfile(browser: Browser, link: string): Promise<Page> {
  const context = await browser.newContext({ viewport: { width: 1000, height: 700 } });
  const page = await context.newPage();
  await page.goto(link);
  return page;
}
