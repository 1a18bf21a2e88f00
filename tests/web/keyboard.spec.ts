import type { Page } from '@playwright/test';
import { drop, expect, openPaused, root, state, test } from './page.ts';

type Kind = 'file' | 'link' | 'checkbox' | 'range' | 'text' | 'select' | 'button' | 'term' | 'shape';
interface Control {
  readonly name: string;
  readonly kind: Kind;
}

declare global {
  interface Window {
    controls(): HTMLElement[];
    nameOf(element: Element): string;
    looks: Map<Element, string>;
    lookOf(element: Element): string;
  }
}

test.beforeEach(async ({ page }) => {
  await page.addInitScript(() => {
    window.nameOf = (element) =>
      element.id || (element.getAttribute('aria-label') ?? element.textContent).replace(/\s+/g, ' ').trim();
    /** Everything that takes the focus, by the rules of HTML and not by those of this page. */
    window.controls = () =>
      [
        ...document.querySelectorAll<HTMLElement>(
          'a[href], button, input, select, textarea, summary, [tabindex]',
        ),
      ].filter(
        (element) =>
          !element.matches(':disabled, [tabindex="-1"], [inert] *') &&
          element.checkVisibility({ visibilityProperty: true }) &&
          (document.querySelector('dialog[open]')?.contains(element) ?? true),
      );
    /** Outlines and shadows of the element and of what is drawn around it. */
    window.lookOf = (element) => {
      const looks: string[] = [];
      let at: Element | null = element;
      for (let i = 0; at && i < 2; ++i, at = at.parentElement) {
        const { outline, boxShadow } = getComputedStyle(at);
        looks.push(`${outline} ${boxShadow}`);
      }
      return looks.join(' | ');
    };
  });
});

async function controlsOf(page: Page): Promise<Control[]> {
  return page.evaluate(() =>
    window.controls().map((element) => {
      const type = element instanceof HTMLInputElement ? element.type : element.localName;
      const kinds: Record<string, Kind> = {
        a: 'link',
        button: 'button',
        summary: 'button',
        file: 'file',
        checkbox: 'checkbox',
        range: 'range',
        select: 'select',
        div: 'shape',
      };
      const kind = element.matches('.term') ? 'term' : kinds[type];
      return { name: window.nameOf(element), kind: kind ?? 'text' };
    }),
  );
}

/** Tab from the beginning of the page to its end: every control is reached, and is seen to be. */
async function walk(page: Page): Promise<void> {
  const names = (await controlsOf(page)).map(({ name }) => name);
  const inDialog = (await page.getByRole('dialog').count()) > 0;
  await page.evaluate(() => {
    if (!document.querySelector('dialog[open]')) {
      // Where the next Tab begins: before everything.
      document.body.tabIndex = -1;
      document.body.focus();
      document.body.removeAttribute('tabindex');
    }
    const focused = document.activeElement;
    if (focused instanceof HTMLElement && focused !== document.body) focused.blur();
    window.looks = new Map(window.controls().map((element) => [element, window.lookOf(element)]));
  });
  const reached = new Set<string>();
  let left = false;
  for (let presses = 0; presses < names.length + 3 && !left; ++presses) {
    await page.keyboard.press('Tab');
    const at = await page.evaluate(() => {
      const element = document.activeElement;
      if (!element || element.matches('body, dialog')) return undefined;
      return {
        name: window.nameOf(element),
        seen: window.lookOf(element) !== window.looks.get(element),
        inside: document.querySelector('dialog[open]')?.contains(element) ?? true,
      };
    });
    if (!at) {
      // From a sheet the focus goes to the browser and comes back.
      left = reached.size > 0 && !inDialog;
      continue;
    }
    expect(at.inside, `${at.name} is behind an open sheet`).toBe(true);
    expect(at.seen, `the focus on ${at.name} is seen`).toBe(true);
    reached.add(at.name);
  }
  expect([...reached].sort()).toEqual([...new Set(names)].sort());
  if (!inDialog) expect(left, 'Tab leaves the page at its end').toBe(true);
}

/** What a visitor could notice, but for the tips, which the focus alone shows. */
async function appearance(page: Page): Promise<string> {
  return root(page).evaluate((main) => {
    const copy = main.cloneNode(true) as Element;
    for (const passing of copy.querySelectorAll('#tip, #spoken')) passing.remove();
    return copy.outerHTML;
  });
}

async function focusOn(page: Page, name: string): Promise<void> {
  await page.evaluate((wanted) => {
    window
      .controls()
      .find((element) => window.nameOf(element) === wanted)
      ?.focus();
  }, name);
}

async function valueOf(page: Page): Promise<string> {
  return page.evaluate(() => {
    const { activeElement: at } = document;
    if (at instanceof HTMLInputElement) return at.type === 'checkbox' ? String(at.checked) : at.value;
    return at instanceof HTMLSelectElement ? at.value : '';
  });
}

/** What is typed into fields: something other than what they hold. */
const ENTRIES: Readonly<Record<string, string>> = {
  nu: '1, 3, 4, 4',
  first: '20',
  until: '0.9',
  noise: '0.02',
  rho: '1',
};
const DOWNLOADS = ['export-csv', 'export-ply', 'export-svg'];

/** Works the control with keys alone; something must come of it. */
async function operate(page: Page, { name, kind }: Control): Promise<void> {
  await expect(root(page)).not.toHaveAttribute('aria-busy');
  await expect(root(page)).toHaveAttribute('data-run-state', /finished|empty/);
  await focusOn(page, name);
  const { keyboard } = page;
  if (name === 'licences') {
    await keyboard.press('Enter');
    await page.waitForURL(/licences\.txt$/);
    await page.goBack();
  } else if (kind === 'link' || DOWNLOADS.includes(name)) {
    const download = page.waitForEvent('download', { timeout: 10_000 });
    await keyboard.press('Enter');
    await download;
  } else if (kind === 'checkbox' || kind === 'range' || kind === 'select') {
    const before = await valueOf(page);
    const [there, back] = kind === 'checkbox' ? ['Space', 'Space'] : ['ArrowDown', 'ArrowUp'];
    await keyboard.press(there);
    if ((await valueOf(page)) === before) await keyboard.press(back);
    expect(await valueOf(page), name).not.toBe(before);
    if (kind === 'checkbox') await keyboard.press(back);
  } else if (kind === 'text') {
    const opened = page.evaluate(
      () =>
        new Promise((done) => {
          const main = document.querySelector('main');
          if (main) new MutationObserver(done).observe(main, { attributeFilter: ['aria-busy'] });
        }),
    );
    await keyboard.press('Control+a');
    await keyboard.type(ENTRIES[name] ?? '40');
    await keyboard.press('Enter');
    await opened;
    await expect(root(page)).not.toHaveAttribute('aria-busy');
    await expect(page.getByRole('alert'), name).toBeHidden();
  } else if (kind === 'shape') {
    const picture = async (): Promise<string> => {
      await page.evaluate(
        () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))),
      );
      return (await page.locator('#shape').screenshot()).toString('base64');
    };
    const pictures = new Set([await picture()]);
    const step = await state(page, 'step');
    for (const key of ['ArrowRight', 'ArrowUp', '+', '-', '-']) {
      await keyboard.press(key);
      pictures.add(await picture());
    }
    expect(pictures.size).toBeGreaterThanOrEqual(5);
    expect(await state(page, 'step')).toBe(step);
  } else if (kind === 'term') {
    await expect(page.getByRole('tooltip')).toBeVisible();
    await keyboard.press('Escape');
    await expect(page.getByRole('tooltip')).toBeHidden();
    await keyboard.press('Enter');
    await expect(page.getByRole('tooltip')).toBeVisible();
  } else {
    const before = await appearance(page);
    await keyboard.press('Enter');
    await expect.poll(async () => (await appearance(page)) !== before, { message: name }).toBe(true);
    if ((await page.getByRole('dialog').count()) > 0) {
      await keyboard.press('Escape');
      await expect(page.getByRole('dialog')).toHaveCount(0);
      expect(await page.evaluate(() => document.activeElement?.id), 'the focus comes back').toBe(name);
    }
    if (name === 'play') await keyboard.press('Space');
  }
}

async function rerun(page: Page, most: string): Promise<void> {
  const before = await state(page, 'hash');
  await page.getByLabel('Stop at N').fill(most);
  await page.getByLabel('Stop at N').press('Enter');
  await expect.poll(() => state(page, 'hash')).not.toBe(before);
  await expect(root(page)).toHaveAttribute('data-run-state', 'finished');
}

test('every control of the page by keyboard alone', async ({ page }) => {
  test.setTimeout(150_000);
  // The browser has to be told early that it hands choosers over.
  const chooser = page.waitForEvent('filechooser');
  await openPaused(page, 'torus', 150);
  await page.getByText('Settings', { exact: true }).click();
  await rerun(page, '120');
  await rerun(page, '110');
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(page.getByRole('button', { name: 'Redo' })).toBeEnabled();
  await page.getByRole('checkbox', { name: 'Section' }).check();
  await expect(root(page)).toHaveAttribute('data-run-state', 'finished');
  await page.getByRole('slider', { name: 'Step' }).fill('20');
  await walk(page);
  const controls = await controlsOf(page);
  expect(controls.length).toBeGreaterThan(35);
  // Another sample is another page: at the end. Undo is, too: it takes back what was typed.
  const order = (name: string): number => ['undo', 'redo', 'sample'].indexOf(name);
  // Folding the settings away hides their fields; the licences are another page.
  const settled = controls.filter(
    ({ name, kind }) => !['settings-title', 'licences'].includes(name) && kind !== 'file',
  );
  for (const control of settled.sort((a, b) => order(a.name) - order(b.name))) await operate(page, control);
  await operate(page, { name: 'settings-title', kind: 'button' });
  await focusOn(page, 'file');
  await page.keyboard.press('Enter');
  await chooser;
  await operate(page, { name: 'licences', kind: 'link' });
});

test('the question for columns, and its error, by keyboard alone', async ({ page }) => {
  await openPaused(page, 'torus', 60);
  await drop(page, 'wide.csv', '1,0,0,9\n2,1,0,9\n3,1,1,8\n4,0,1,7\n5,0.5,0.5,3\n');
  await expect(page.getByLabel('Which columns')).toBeVisible();
  await walk(page);
  await focusOn(page, 'columns');
  await page.keyboard.press('Control+a');
  await page.keyboard.type('2, 3');
  await page.keyboard.press('Tab');
  await page.keyboard.press('Space');
  await expect(root(page)).toHaveAttribute('data-source', 'wide.csv');
  await drop(page, 'bad.csv', '1,2,3\n1,2\n');
  await expect(page.getByRole('alert')).toBeVisible();
  await operate(page, { name: 'dismiss', kind: 'button' });
  await expect(page.getByRole('alert')).toBeHidden();
});

for (const [sheet, key, opener] of [
  ['Gallery', 'g', 'Gallery'],
  ['Help', '?', 'Help'],
  ['Share', 's', 'Share'],
] as const) {
  test(`the sheet ${sheet}: reached, closed and left by keyboard alone`, async ({ page }) => {
    await openPaused(page, 'torus', 60);
    const dialog = page.getByRole('dialog', { name: sheet });
    const button = page.getByRole('button', { name: opener, exact: true });
    await button.focus();
    await page.keyboard.press('Enter');
    await expect(dialog).toBeVisible();
    await walk(page);
    await dialog.getByRole('button', { name: /^Close/ }).focus();
    await page.keyboard.press('Enter');
    await expect(dialog).toBeHidden();
    await expect(button).toBeFocused();
    await page.getByRole('button', { name: 'Step', exact: true }).focus();
    await page.keyboard.press(key);
    await expect(dialog).toBeVisible();
    await page.keyboard.press('Escape');
    await expect(dialog).toBeHidden();
    await expect(page.getByRole('button', { name: 'Step', exact: true })).toBeFocused();
  });
}

test('an empty page by keyboard alone', async ({ page }) => {
  await page.goto('./?sample=none');
  await expect(root(page)).toHaveAttribute('data-run-state', 'empty');
  await walk(page);
  await operate(page, { name: 'empty-gallery', kind: 'button' });
});

/** Each key of the help sheet, and what it does to a page that stands at step 30 of 60. */
const KEYS: Readonly<
  Record<string, { readonly press: string; readonly single: boolean; readonly seen: string }>
> = {
  space: { press: 'Space', single: false, seen: 'playing' },
  '←': { press: 'ArrowLeft', single: false, seen: 'step' },
  '→': { press: 'ArrowRight', single: false, seen: 'step' },
  Home: { press: 'Home', single: false, seen: 'step' },
  End: { press: 'End', single: false, seen: 'step' },
  Ctrl: { press: 'Control+z', single: false, seen: 'hash' },
  Z: { press: 'Control+z', single: false, seen: 'hash' },
  P: { press: 'p', single: true, seen: 'step' },
  G: { press: 'g', single: true, seen: 'gallery' },
  '1': { press: '1', single: true, seen: 'layer-witnesses' },
  '2': { press: '2', single: true, seen: 'layer-landmarks' },
  '3': { press: '3', single: true, seen: 'layer-edges' },
  '4': { press: '4', single: true, seen: 'layer-faces' },
  C: { press: 'c', single: true, seen: 'color-by' },
  X: { press: 'x', single: true, seen: 'section' },
  L: { press: 'l', single: true, seen: 'axis' },
  S: { press: 's', single: true, seen: 'share' },
  I: { press: 'i', single: true, seen: 'why' },
  '?': { press: '?', single: true, seen: 'help' },
};
/** These show in the chooser of the browser and in the picture, and have tests of their own. */
const ELSEWHERE = ['O', 'F', 'D', '+', '−', '↑', '↓'];

async function seen(page: Page, what: string): Promise<string> {
  return page.evaluate((key) => {
    const element = document.getElementById(key);
    if (element instanceof HTMLDialogElement) return String(element.open);
    if (element instanceof HTMLSelectElement) return element.value;
    if (element instanceof HTMLInputElement && element.type === 'checkbox') return String(element.checked);
    return document.querySelector<HTMLElement>('main')?.dataset[key] ?? '';
  }, what);
}

test('each key of the help sheet has its effect, and single ones have none when they are off', async ({
  page,
}) => {
  test.setTimeout(180_000);
  await openPaused(page, 'torus', 60);
  await page.getByRole('button', { name: 'Help' }).click();
  const listed = await page.locator('#help kbd').allTextContents();
  const known = [...Object.keys(KEYS), ...ELSEWHERE];
  expect(listed.filter((key) => !known.includes(key))).toEqual([]);
  expect(Object.keys(KEYS).filter((key) => !listed.includes(key))).toEqual([]);
  await page.keyboard.press('Escape');
  await page.getByText('Settings', { exact: true }).click();
  await rerun(page, '59');
  await page.evaluate(() => {
    const { activeElement } = document;
    if (activeElement instanceof HTMLElement) activeElement.blur();
  });
  const pressed = async (key: string): Promise<boolean> => {
    const { press, seen: what } = KEYS[key] ?? { press: key, seen: 'step' };
    await expect(root(page)).toHaveAttribute('data-run-state', 'finished');
    await page.getByRole('slider', { name: 'Step' }).fill('30');
    await page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur());
    const before = await seen(page, what);
    await page.keyboard.press(press);
    if (what === 'hash') await expect.poll(() => seen(page, what), { message: key }).not.toBe(before);
    const changed = (await seen(page, what)) !== before;
    if (what === 'playing') await page.keyboard.press(press);
    if ((await page.getByRole('dialog').count()) > 0) await page.keyboard.press('Escape');
    return changed;
  };
  for (const key of Object.keys(KEYS).filter((each) => each !== 'Ctrl')) {
    expect(await pressed(key), key).toBe(true);
  }
  await page.getByRole('button', { name: 'Help' }).click();
  await page.getByRole('dialog').getByRole('checkbox').uncheck();
  await page.keyboard.press('Escape');
  for (const [key, { single }] of Object.entries(KEYS)) {
    if (single) expect(await pressed(key), `${key} is off`).toBe(false);
  }
  expect(await pressed('→')).toBe(true);
});
