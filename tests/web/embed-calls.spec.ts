// What scripts of a page call and set, at any time: before the points can be watched, while others are opened, twice.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { expect, test, type Locator, type Page } from '@playwright/test';
import type { PlateauViewElement } from '../../web/src/embed/plateau-view.ts';
import { ForeignServer, rememberEvents } from './foreign-page.ts';
import { torusText } from './page.ts';

const command = fileURLToPath(new URL('../../build/native/bin/plateau', import.meta.url));

let foreign: ForeignServer;

test.beforeAll(async ({ baseURL }) => {
  foreign = await ForeignServer.start(baseURL ?? '');
});
test.afterAll(() => foreign.stop());

const far = '<br>'.repeat(80);
const view = (page: Page): Locator => page.locator('#a .view');
const finished = (page: Page): Promise<void> =>
  expect(view(page)).toHaveAttribute('data-run-state', 'finished');
const at = (page: Page, step: number): Promise<void> =>
  expect(view(page)).toHaveAttribute('data-step', String(step));

function call<T>(page: Page, script: (element: PlateauViewElement) => T | Promise<T>): Promise<T> {
  return page.locator('#a').evaluate(script);
}

async function open(page: Page, path: string, body: string): Promise<void> {
  await page.goto(foreign.page(path, body));
  await page.waitForFunction(() => customElements.get('plateau-view') !== undefined);
}

test('calls in the handler of `ready` count: the first code that a teacher writes', async ({ page }) => {
  await page.addInitScript(() => {
    document.addEventListener('ready', ({ target }) => {
      const element = target as PlateauViewElement;
      if (element.id !== 'a') return;
      element.play();
      const afterPlay = element.playing;
      element.goTo(20);
      Object.assign(window, { playing: [afterPlay, element.playing] });
    });
  });
  await open(
    page,
    '/ready',
    '<plateau-view id="a" shape="torus" size="200" panels="diagram"></plateau-view>',
  );
  await finished(page);
  await at(page, 20);
  expect(await page.evaluate(() => Reflect.get(window, 'playing') as unknown)).toEqual([true, false]);
});

test('play in the handler of `ready` lets the film run', async ({ page }) => {
  await page.addInitScript(() => {
    document.addEventListener('ready', ({ target }) => (target as PlateauViewElement).play());
  });
  await open(page, '/play', '<plateau-view id="a" shape="torus" size="900" panels="diagram"></plateau-view>');
  await expect(view(page)).toHaveAttribute('data-playing', 'true');
  expect(await call(page, (element) => element.playing)).toBe(true);
});

test('what is called before anything is open waits for it', async ({ page }) => {
  await open(page, '/early', `${far}<plateau-view id="a" panels="diagram"></plateau-view>`);
  const early = await call(page, (element) => {
    const playing = [element.playing];
    Object.assign(element, { shape: 'torus', size: 200, autoplay: true });
    playing.push(element.playing);
    element.pause();
    playing.push(element.playing);
    element.play();
    playing.push(element.playing);
    element.goTo(33.3);
    playing.push(element.playing);
    return playing;
  });
  expect(early).toEqual([false, true, false, true, false]);
  await page.locator('#a').scrollIntoViewIfNeeded();
  await finished(page);
  await at(page, 33);
  // A change of the points and a call at once: the call is meant for what comes.
  await call(page, (element) => {
    element.autoplay = false;
    element.seed = 2;
    element.goTo(44);
  });
  await expect.poll(() => call(page, (element) => element.currentStep)).toBe(44);
  await finished(page);
  await at(page, 44);
});

test('`step` and `plateau` written once more send the playhead once more', async ({ page }) => {
  await open(
    page,
    '/again',
    '<plateau-view id="a" shape="torus" size="200" panels="diagram"></plateau-view>',
  );
  await finished(page);
  const longest = await call(page, (element) => element.plateaus[0]?.middleStep ?? 0);
  await call(page, (element) => (element.step = 100));
  await at(page, 100);
  await call(page, (element) => element.goTo(5));
  await at(page, 5);
  await call(page, (element) => (element.step = 100));
  await at(page, 100);
  await call(page, (element) => (element.step = undefined));
  await at(page, longest);
  await call(page, (element) => (element.plateau = 1));
  await call(page, (element) => element.goTo(5));
  await call(page, (element) => (element.plateau = 1));
  await at(page, longest);
});

test('without autoplay the film stops where the visitor is; with it once more it begins again', async ({
  page,
}) => {
  await open(
    page,
    '/autoplay',
    '<plateau-view id="a" shape="torus" size="900" panels="diagram" autoplay></plateau-view>',
  );
  await finished(page);
  await expect.poll(() => call(page, (element) => element.currentStep)).toBeGreaterThan(3);
  await call(page, (element) => element.pause());
  const stopped = await call(page, (element) => element.currentStep);
  await call(page, (element) => (element.autoplay = false));
  await call(page, (element) => (element.theme = 'dark'));
  await at(page, stopped);
  expect(await call(page, (element) => element.playing)).toBe(false);
  await call(page, (element) => (element.autoplay = true));
  await expect.poll(() => call(page, (element) => element.playing)).toBe(true);
});

test('goTo takes numbers, and nothing that is none', async ({ page }) => {
  await open(page, '/goto', '<plateau-view id="a" shape="torus" size="200" panels="diagram"></plateau-view>');
  await finished(page);
  const codes = await call(page, (element) =>
    [NaN, undefined, 'abc'].map((wrong) => {
      try {
        element.goTo(wrong as number);
        return 'taken';
      } catch (error) {
        return (error as { code: string }).code;
      }
    }),
  );
  expect(codes).toEqual(['invalid-option', 'invalid-option', 'invalid-option']);
  await expect(page.locator('#a .readout')).not.toContainText('NaN');
  await call(page, (element) => element.goTo('17' as unknown as number));
  await at(page, 17);
  await call(page, (element) => element.goTo(Infinity));
  await at(page, 200);
});

test('load tells how it ended: for the points that it was given, and for no others', async ({ page }) => {
  await open(page, '/load', '<plateau-view id="a" shape="torus" size="60" panels="diagram"></plateau-view>');
  await finished(page);
  const ends = await call(page, async (element) => {
    const told = (promise: Promise<void>): Promise<string> =>
      promise.then(
        () => 'resolved',
        (error: Error & { code?: string }) => `${error.name} ${error.code ?? ''} ${error.message}`,
      );
    const points = Float64Array.from({ length: 600 }, (_, i) => Math.sin(i * i));
    // Other points are named before these can be watched.
    const replaced = told(element.load(points));
    element.shape = 'sphere';
    const lost = await replaced;
    const wrong = [undefined, [1, 2], 'abc', new Float32Array(3)] as unknown as File[];
    const refused = await Promise.all(wrong.map((given) => told(element.load(given))));
    const taken = await told(element.load(points));
    const removed = told(element.load(points));
    element.remove();
    return { lost, refused, taken, removed: await removed };
  });
  expect(ends).toEqual({
    lost: expect.stringMatching(/^AbortError .*Another opening came in between/),
    refused: ['undefined', 'Array', '"abc"', 'Float32Array'].map(
      (given) => `PlateauError invalid-option load takes a File or a Float64Array, not ${given}.`,
    ),
    taken: 'resolved',
    removed: expect.stringMatching(/^AbortError .*The element was removed/),
  });
});

test('load in a browser that is too old is refused at once', async ({ page }) => {
  await page.addInitScript(() => (WebAssembly.validate = () => false));
  await open(page, '/old-load', '<plateau-view id="a"></plateau-view>');
  await expect(page.locator('#a')).toContainText('This browser lacks');
  const code = await call(page, (element) =>
    element.load(new Float64Array(30)).then(
      () => 'resolved',
      (error: { code: string }) => error.code,
    ),
  );
  expect(code).toBe('unsupported-browser');
});

test('a file that could not be read is asked for again, by script and by button', async ({ page }) => {
  const events = await rememberEvents(page);
  await open(page, '/dead', '<plateau-view id="a" src="late.xyz"></plateau-view>');
  const box = page.locator('#a');
  await expect(box.getByRole('alert')).toContainText('it answers 404');
  await expect(box).toContainText('Nothing to show: the points could not be opened.');
  await expect(view(page)).not.toHaveAttribute('aria-busy');
  await call(page, (element) => (element.src = 'late.xyz'));
  const faults = async (): Promise<number> => (await events()).filter(({ type }) => type === 'error').length;
  await expect.poll(faults).toBe(2);
  // What is looked at otherwise is not opened again.
  await call(page, (element) => (element.theme = 'dark'));
  await box.getByRole('button', { name: 'Dismiss' }).click();
  await expect(box).toContainText('Nothing to show: the points could not be opened.');
  expect(await call(page, (element) => element.shadowRoot?.activeElement?.className)).toBe('view');
  expect(await faults()).toBe(2);
  await call(page, (element) => (element.src = 'late.xyz'));
  await expect.poll(faults).toBe(3);
  foreign.put('/late.xyz', torusText(120));
  await box.getByRole('button', { name: 'Try again' }).click();
  await expect(view(page)).toHaveAttribute('data-steps', '120');
  await expect(box.getByRole('alert')).toBeHidden();
  expect(await call(page, (element) => element.shadowRoot?.activeElement?.textContent)).toContain('Play');
  await expect(box).not.toContainText('Nothing to show');
});

test('while points are read the element says so; without a shape it forgets what is under way', async ({
  page,
}) => {
  let answer = (): void => undefined;
  await page.route('**/slow.xyz', async (route) => {
    await new Promise<void>((resolve) => (answer = resolve));
    await route
      .fulfill({ body: torusText(90), headers: { 'Access-Control-Allow-Origin': '*' } })
      .catch(() => undefined);
  });
  await open(page, '/slow', '<plateau-view id="a" src="slow.xyz"></plateau-view>');
  await expect(page.locator('#a .note:visible')).toHaveText('Reading slow.xyz …');
  await expect(page.locator('#a').getByRole('status')).toHaveText('Reading slow.xyz …');
  await call(page, (element) => (element.src = ''));
  await expect(view(page)).not.toHaveAttribute('aria-busy');
  await expect(page.locator('#a .note:visible')).toContainText('this element needs a shape or a src');
  answer();
  await call(page, (element) => {
    element.shape = 'torus';
    element.size = 80;
  });
  await expect(view(page)).toHaveAttribute('data-steps', '80');
});

test('an element that is removed while it is to go on reports nothing', async ({ page }) => {
  const events = await rememberEvents(page);
  await page.addInitScript(() => {
    const told: unknown[] = [];
    Object.assign(window, { told });
    window.onerror = (what) => void told.push(what);
    // The removed element is no part of the page any more: what it tells is heard at itself.
    customElements.whenDefined('plateau-view').then(
      () => document.querySelector('#a')?.addEventListener('error', () => told.push('error')),
      () => undefined,
    );
  });
  await open(
    page,
    '/removed',
    `<plateau-view id="a" shape="torus" size="40000" panels="diagram"></plateau-view>${far}`,
  );
  await expect.poll(() => call(page, (element) => element.stepCount)).toBeGreaterThan(20);
  await page.evaluate(() => scrollTo(0, 1e6));
  await expect(page.locator('#a')).not.toBeInViewport();
  await page.waitForTimeout(200);
  await page.evaluate(async () => {
    const element = document.querySelector('#a');
    // Removed as soon as it has asked to go on, before that is answered.
    const asked = new Promise<void>((resolve) => {
      // eslint-disable-next-line @typescript-eslint/unbound-method -- it is called with its worker
      const { postMessage } = Worker.prototype;
      Worker.prototype.postMessage = function (message: { kind: string }, transfer?: object) {
        postMessage.call(this, message, transfer);
        if (message.kind !== 'resume') return;
        element?.remove();
        resolve();
      };
    });
    scrollTo(0, 0);
    await asked;
  });
  await expect.poll(() => page.workers().length).toBe(0);
  await page.waitForTimeout(100);
  expect(await page.evaluate(() => Reflect.get(window, 'told') as unknown)).toEqual([]);
  expect((await events()).filter(({ type }) => type === 'error')).toEqual([]);
});

test('faults of an element are none of the scripts of its page', async ({ page }) => {
  await page.addInitScript(() => {
    const told: unknown[] = [];
    Object.assign(window, { told });
    window.onerror = (what) => void told.push(what);
  });
  await open(page, '/onerror', '<plateau-view id="a" src="gone.xyz" panels="diagram"></plateau-view>');
  await expect(page.locator('#a').getByRole('alert')).toContainText('it answers 404');
  expect(await page.evaluate(() => Reflect.get(window, 'told') as unknown)).toEqual([]);
});

test('a sentence that was dismissed does not come back with every opening', async ({ page }) => {
  await open(
    page,
    '/dismissed',
    '<plateau-view id="a" shape="torus" size="60" panels="sideways"></plateau-view>',
  );
  await finished(page);
  const alert = page.locator('#a').getByRole('alert');
  await expect(alert).toContainText('panels="sideways"');
  await page.locator('#a').getByRole('button', { name: 'Dismiss' }).click();
  await call(page, (element) => (element.size = 70));
  await expect(view(page)).toHaveAttribute('data-steps', '70');
  await expect(alert).toBeHidden();
  await call(page, (element) => element.setAttribute('panels', 'upside down'));
  await expect(alert).toContainText('panels="upside down"');
});

test('a page from right to left, in capitals, changes nothing of the mathematics', async ({ page }) => {
  await page.goto(
    foreign.page(
      '/rtl',
      `<div dir="rtl" lang="ar" class="loud"><plateau-view id="a" shape="torus" size="200"></plateau-view></div>`,
    ),
  );
  await page.evaluate(() => {
    const sheet = new CSSStyleSheet();
    sheet.replaceSync(
      '.loud { text-transform: uppercase; white-space: pre; letter-spacing: 9px; word-spacing: 9px }',
    );
    document.adoptedStyleSheets = [sheet];
  });
  await finished(page);
  const look = await view(page).evaluate((box) => {
    const { direction, textTransform, whiteSpace, letterSpacing, wordSpacing } = getComputedStyle(box);
    return [direction, textTransform, whiteSpace, letterSpacing, wordSpacing];
  });
  expect(look).toEqual(['ltr', 'none', 'normal', 'normal', '0px']);
  await expect(view(page)).toHaveAttribute('lang', 'en');
  await call(page, (element) => element.goTo(50));
  await page.locator('#a').getByRole('slider', { name: 'Step' }).press('ArrowRight');
  await at(page, 51);
});

test('a session runs with its own options except those that attributes name', async ({ page }) => {
  const folder = mkdtempSync(join(tmpdir(), 'plateau-'));
  const [points, session] = [join(folder, 'points.xyz'), join(folder, 'mine.plateau')];
  writeFileSync(points, torusText(200));
  execFileSync(command, ['run', points, '--family', 'delaunay', '--steps', '70', '--session', session]);
  await page.route('**/mine.plateau', (route) => route.fulfill({ path: session }));
  const events = await rememberEvents(page);
  await open(page, '/session', '<plateau-view id="a" src="mine.plateau" panels="diagram"></plateau-view>');
  const last = async () => (await events()).filter(({ type }) => type === 'ready').at(-1)?.detail;
  await expect.poll(last).toMatchObject({ family: 'delaunay', stepsPlanned: 70 });
  await call(page, (element) => (element.steps = 90));
  await expect.poll(last).toMatchObject({ family: 'delaunay', stepsPlanned: 90 });
});
