import type { Locator, Page } from '@playwright/test';
import { complaints } from './axe.ts';
import { expect, state, test, torusText } from './page.ts';
import { ForeignServer, rememberEvents } from './foreign-page.ts';

let foreign: ForeignServer;

test.beforeAll(async ({ baseURL }) => {
  foreign = await ForeignServer.start(baseURL ?? '');
});
test.afterAll(() => foreign.stop());

const far = '<br>'.repeat(80);
const view = (page: Page, id: string): Locator => page.locator(`#${id} .view`);
const finished = async (page: Page, id: string): Promise<void> => {
  await expect(view(page, id)).toHaveAttribute('data-run-state', 'finished');
};
const own = <T>(page: Page, id: string, name: string): Promise<T> =>
  page.locator(`#${id}`).evaluate((element, key) => Reflect.get(element, key) as T, name);

/** What the page asks of the network and of the compiler. */
interface ProgramWatch {
  readonly modules: string[];
  compiled(): Promise<number>;
  /** Runs that were asked for, also those that another one replaced at once. */
  opened(): Promise<number>;
}

async function watchProgram(page: Page): Promise<ProgramWatch> {
  const modules: string[] = [];
  page.on('request', (request) => {
    if (request.url().endsWith('.wasm')) modules.push(request.url());
  });
  await page.addInitScript(() => {
    const counter = { compiled: 0, opened: 0 };
    Object.assign(window, { counter });
    // eslint-disable-next-line @typescript-eslint/unbound-method -- it is called with its worker
    const { postMessage } = Worker.prototype;
    Worker.prototype.postMessage = function (message: { kind: string }, transfer?: object) {
      if (message.kind === 'open') counter.opened += 1;
      postMessage.call(this, message, transfer);
    };
    for (const name of ['compile', 'compileStreaming', 'instantiate', 'instantiateStreaming'] as const) {
      const original = WebAssembly[name] as (...args: unknown[]) => unknown;
      Object.assign(WebAssembly, {
        [name]: (...args: unknown[]) => {
          counter.compiled += 1;
          return original.apply(WebAssembly, args);
        },
      });
    }
  });
  type Counter = Record<'compiled' | 'opened', number>;
  const count = (name: keyof Counter): Promise<number> =>
    page.evaluate((key) => (window as unknown as { counter: Counter }).counter[key], name);
  return { modules, compiled: () => count('compiled'), opened: () => count('opened') };
}

test('two on a page of another origin, under a strict policy, share one module and one worker', async ({
  page,
}) => {
  const program = await watchProgram(page);
  const events = await rememberEvents(page);
  await page.goto(
    foreign.page(
      '/two',
      `<plateau-view id="a" shape="torus" size="400" panels="diagram"></plateau-view>
       <plateau-view id="b" shape="helix" size="500" family="delaunay" panels="shape"></plateau-view>`,
    ),
  );
  await finished(page, 'a');
  await finished(page, 'b');
  expect(program.modules).toHaveLength(1);
  expect(await program.compiled()).toBe(1);
  expect(page.workers()).toHaveLength(1);
  expect(page.workers()[0]?.url()).toMatch(/^blob:/);
  const seen = await events();
  const ready = seen.filter(({ type }) => type === 'ready');
  expect(ready.map(({ id }) => id).sort()).toEqual(['a', 'b']);
  expect(ready.find(({ id }) => id === 'b')?.detail).toMatchObject({
    name: 'helix',
    points: 500,
    family: 'delaunay',
  });
  expect(seen.filter(({ type }) => type === 'error')).toEqual([]);
  // The longest plateau is where it comes to rest, and what it tells of.
  const [longest] = await own<{ middleStep: number; betti: number[]; shape: string }[]>(
    page,
    'a',
    'plateaus',
  );
  expect(longest).toMatchObject({ betti: [1, 2, 1], shape: 'torus-like closed surface' });
  expect(await own(page, 'a', 'currentStep')).toBe(longest?.middleStep);
  const told = seen.filter(({ type, id }) => type === 'plateau' && id === 'a');
  expect(told.map(({ detail }) => detail)).toEqual([longest]);
  expect(seen.filter(({ type, id }) => type === 'step' && id === 'a').at(-1)?.detail).toMatchObject({
    step: longest?.middleStep,
    betti: [1, 2, 1],
  });
  await expect(page.locator('#a').getByRole('status')).toContainText('β 1, 2, 1');
  const hash = await view(page, 'a').getAttribute('data-hash');

  await page.goto('./?sample=torus&n=400');
  await expect(page.locator('main')).toHaveAttribute('data-run-state', 'finished');
  expect(await state(page, 'hash')).toBe(hash);
});

test('by iframe, with its attributes in the address', async ({ page, baseURL }) => {
  const address = `${baseURL}/embed/?size=300&panels=both#shape=sphere&plateau=1&aria-label=A%20ball`;
  await page.goto(
    foreign.put('/frame', `<iframe title="Plateau" width="500" height="480" src="${address}"></iframe>`),
  );
  const frame = page.frameLocator('iframe');
  await expect(frame.locator('.view')).toHaveAttribute('data-run-state', 'finished');
  await expect(frame.locator('.view')).toHaveAttribute('data-betti', '1,0,1');
  await expect(frame.locator('.view')).toHaveAttribute('data-panels', 'both');
  await expect(frame.getByRole('group', { name: 'A ball' })).toBeVisible();
  await page.evaluate(
    (next) => document.querySelector('iframe')?.setAttribute('src', next),
    address.replace('sphere', 'circle-noise'),
  );
  await expect(frame.locator('.view')).toHaveAttribute('data-betti', '1,1');
});

test('measured shapes are loaded when they are asked for; torsion is told', async ({ page }) => {
  const events = await rememberEvents(page);
  const programs: string[] = [];
  page.on('request', (request) => programs.push(request.url().replace(/^.*\//, '')));
  const element = (shape: string, size: number): string =>
    `<plateau-view id="a" shape="${shape}" size="${size}" panels="diagram"></plateau-view>`;
  await page.goto(foreign.page('/bunny', element('bunny', 700)));
  await finished(page, 'a');
  expect(programs).toContain('bunny-points.js');
  expect(programs).not.toContain('color-distances.js');
  const last = async (type: string) => (await events()).filter((event) => event.type === type).at(-1)?.detail;
  expect(await last('ready')).toMatchObject({ name: 'bunny', points: 700, dimension: 3, family: 'auto' });
  await page.goto(foreign.page('/colors', element('colors', 200)));
  await finished(page, 'a');
  expect(programs).toContain('color-distances.js');
  expect(await last('ready')).toMatchObject({ name: 'colors', points: 200, dimension: 0, nu: [1, 5, 6, 6] });
  await page.goto(foreign.page('/klein', element('klein', 2500)));
  await expect(view(page, 'a')).toHaveAttribute('data-run-state', 'finished');
  expect(await view(page, 'a').getAttribute('data-steps')).toBe('400');
  const plateaus = await own<{ shape: string; torsion?: object }[]>(page, 'a', 'plateaus');
  const bottle = plateaus.find(({ torsion }) => torsion);
  expect(bottle).toMatchObject({
    shape: 'Klein-bottle-like shape',
    torsion: { field: 3, betti: [1, 1, 0, 0] },
  });
  expect((await events()).filter(({ type }) => type === 'error')).toEqual([]);
});

test('starts when it is scrolled into view, stops when it is not, and goes on', async ({ page }) => {
  // Enough that no machine is done with them before they are scrolled away again.
  const points = 40_000;
  const program = await watchProgram(page);
  await page.goto(
    foreign.page(
      '/scroll',
      `${far}<plateau-view id="a" shape="torus" size="${points}" panels="both" autoplay></plateau-view>${far}`,
    ),
  );
  await page.waitForFunction(() => customElements.get('plateau-view') !== undefined);
  await expect(view(page, 'a')).toHaveCount(1);
  expect(await own(page, 'a', 'stepCount')).toBe(0);
  expect(page.workers()).toHaveLength(0);
  expect(program.modules).toHaveLength(0);

  await page.locator('#a').scrollIntoViewIfNeeded();
  await expect.poll(() => own<number>(page, 'a', 'currentStep')).toBeGreaterThan(2);
  await expect(page.locator('#a :is(.shape, .diagram) canvas')).toHaveCount(2);
  expect(await own(page, 'a', 'playing')).toBe(true);

  await page.evaluate(() => scrollTo(0, 0));
  await expect(page.locator('#a .shape canvas')).toHaveCount(0);
  await expect
    .poll(async () => {
      const before = await own<number>(page, 'a', 'stepCount');
      await page.waitForTimeout(400);
      return (await own<number>(page, 'a', 'stepCount')) - before;
    })
    .toBe(0);
  const [steps, step] = [
    await own<number>(page, 'a', 'stepCount'),
    await own<number>(page, 'a', 'currentStep'),
  ];
  await expect(view(page, 'a')).not.toHaveAttribute('data-run-state', 'finished');

  await page.locator('#a').scrollIntoViewIfNeeded();
  await expect.poll(() => own<number>(page, 'a', 'stepCount')).toBeGreaterThan(steps);
  await expect.poll(() => own<number>(page, 'a', 'currentStep')).toBeGreaterThan(step);
  await expect(page.locator('#a .shape canvas')).toHaveCount(1);
  await page.locator('#a').evaluate((element) => element.remove());
  await expect.poll(() => page.workers().length).toBe(0);
});

test('twenty on a page never hold more of the graphics card than is in view', async ({ page }) => {
  await page.addInitScript(() => {
    const contexts: WebGL2RenderingContext[] = [];
    Object.assign(window, { contexts });
    // eslint-disable-next-line @typescript-eslint/unbound-method -- it is called with its canvas
    const { getContext } = HTMLCanvasElement.prototype;
    Object.assign(HTMLCanvasElement.prototype, {
      getContext(this: HTMLCanvasElement, ...args: [string]) {
        const context: unknown = getContext.apply(this, args);
        if (context instanceof WebGL2RenderingContext) contexts.push(context);
        return context;
      },
    });
  });
  const many = Array.from(
    { length: 20 },
    (_, i) => `<plateau-view id="v${i}" shape="circle-noise" size="40" panels="shape"></plateau-view>`,
  );
  await page.goto(foreign.page('/many', many.join('<br>')));
  for (let i = 0; i < 20; ++i) {
    await page.locator(`#v${i}`).scrollIntoViewIfNeeded();
    await finished(page, `v${i}`);
  }
  expect(await page.locator('plateau-view .shape canvas').count()).toBeLessThanOrEqual(4);
  await page.locator('#v0').scrollIntoViewIfNeeded();
  await expect(page.locator('#v0 .shape canvas')).toHaveCount(1);
  const [made, held] = await page.evaluate(() => {
    const { contexts } = window as unknown as { contexts: WebGL2RenderingContext[] };
    const all = new Set(contexts);
    return [all.size, [...all].filter((context) => !context.isContextLost()).length];
  });
  expect(made).toBeGreaterThan(20);
  expect(held).toBeLessThanOrEqual(4);
  expect(page.workers()).toHaveLength(1);
});

test('changes of attributes count as one, and only those of the points open anew', async ({ page }) => {
  const program = await watchProgram(page);
  const events = await rememberEvents(page);
  await page.goto(foreign.page('/change', `<plateau-view id="a" shape="torus" size="300"></plateau-view>`));
  await finished(page, 'a');
  const ready = async (): Promise<number> => (await events()).filter(({ type }) => type === 'ready').length;
  expect(await ready()).toBe(1);
  await page.locator('#a').evaluate((element) => {
    element.setAttribute('step', '120');
    element.setAttribute('panels', 'full');
    element.setAttribute('theme', 'dark');
  });
  await expect(view(page, 'a')).toHaveAttribute('data-step', '120');
  await expect(page.locator('#a').getByRole('button', { name: 'Back' })).toBeVisible();
  expect(await ready()).toBe(1);
  await page.locator('#a').evaluate((element) => {
    Object.assign(element, { shape: 'sphere', size: 250, seed: 7, family: 'delaunay', step: undefined });
  });
  await expect.poll(ready).toBe(2);
  await finished(page, 'a');
  const last = (await events()).filter(({ type }) => type === 'ready').at(-1);
  expect(last?.detail).toMatchObject({ name: 'sphere', points: 250, family: 'delaunay' });
  await page.locator('#a').evaluate((element) => element.setAttribute('seed', '8'));
  await expect.poll(ready).toBe(3);
  expect(await program.opened()).toBe(3);
  const asked: string[] = [];
  page.on('request', (request) => asked.push(new URL(request.url()).pathname));
  foreign.put('/one.xyz', torusText(100));
  foreign.put('/two.xyz', torusText(110));
  await page.locator('#a').evaluate((element) => {
    element.setAttribute('src', 'one.xyz');
    element.setAttribute('src', 'two.xyz');
  });
  await expect(view(page, 'a')).toHaveAttribute('data-steps', '110');
  expect(asked).toEqual(['/two.xyz']);
});

test('properties that were set before the element is defined count', async ({ page, baseURL }) => {
  await page.goto(
    foreign.put('/early', '<!doctype html><title>Early</title><plateau-view id="a"></plateau-view>'),
  );
  await page.evaluate(() => {
    const element = document.querySelector('plateau-view');
    Object.assign(element ?? {}, { shape: 'torus', size: 200, panels: 'diagram' });
  });
  await page.addScriptTag({ url: `${baseURL}/embed/plateau-view.js`, type: 'module' });
  await finished(page, 'a');
  await expect(page.locator('#a')).toHaveAttribute('shape', 'torus');
  expect(await own(page, 'a', 'size')).toBe(200);
  await expect(view(page, 'a')).toHaveAttribute('data-steps', '200');
});

test('a moved element keeps its run; the worker ends with the last that is removed', async ({ page }) => {
  const program = await watchProgram(page);
  const events = await rememberEvents(page);
  await page.goto(
    foreign.page(
      '/move',
      `<div></div><plateau-view id="a" shape="torus" size="200" panels="diagram"></plateau-view>
       <plateau-view id="b" shape="sphere" size="200" panels="diagram"></plateau-view>`,
    ),
  );
  await finished(page, 'a');
  await finished(page, 'b');
  await page.locator('#a').evaluate((element) => document.querySelector('div')?.append(element));
  await page.locator('#b').evaluate((element) => element.remove());
  await page.locator('#a').evaluate((element) => {
    (element as unknown as { goTo(step: number): void }).goTo(17);
  });
  await expect(view(page, 'a')).toHaveAttribute('data-step', '17');
  expect((await events()).filter(({ type }) => type === 'ready')).toHaveLength(2);
  expect(page.workers()).toHaveLength(1);
  await page.evaluate(() => {
    const element = document.querySelector('#a');
    Object.assign(window, { kept: element });
    element?.remove();
  });
  await expect.poll(() => page.workers().length).toBe(0);
  await page.evaluate(() => document.body.append((window as unknown as { kept: Element }).kept));
  await finished(page, 'a');
  await expect(view(page, 'a')).toHaveAttribute('data-step', /^(?!17$)/);
  // Another worker, but not another module.
  expect(program.modules).toHaveLength(1);
  expect(await program.compiled()).toBe(1);
});

test('points and files are loaded by a call; a bad file changes nothing', async ({ page }) => {
  const events = await rememberEvents(page);
  await page.goto(foreign.page('/load', '<plateau-view id="a" panels="diagram"></plateau-view>'));
  await expect(page.locator('#a')).toContainText('Nothing to show yet');
  const load = (name: string, text: string): Promise<string> =>
    page.locator('#a').evaluate(
      async (element, [fileName = '', content = '']) => {
        const target = element as unknown as { load(data: File): Promise<void> };
        return target.load(new File([content], fileName)).then(
          () => 'loaded',
          (error: { code: string }) => error.code,
        );
      },
      [name, text],
    );
  expect(await load('torus.xyz', torusText(300))).toBe('loaded');
  await finished(page, 'a');
  expect(await load('broken.xyz', '1 2 3\n4 five 6\n')).toBe('malformed-input');
  await expect(page.locator('#a').getByRole('alert')).toContainText('ine 2');
  await expect(view(page, 'a')).toHaveAttribute('data-steps', '300');
  await page.locator('#a').getByRole('button', { name: 'Dismiss' }).click();
  await expect(page.locator('#a').getByRole('alert')).toBeHidden();
  expect((await events()).filter(({ type }) => type === 'error')).toMatchObject([
    { detail: { code: 'malformed-input' } },
  ]);
  const points = await page.locator('#a').evaluate(async (element) => {
    const circle = Float64Array.from({ length: 160 }, (_, i) =>
      i % 2 === 0 ? Math.cos((i * Math.PI) / 80) : Math.sin(((i - 1) * Math.PI) / 80),
    );
    const target = element as unknown as {
      load(data: Float64Array, options: { dimension: number }): Promise<void>;
    };
    await target.load(circle, { dimension: 2 });
    return circle.length;
  });
  expect(points).toBe(160);
  await finished(page, 'a');
  await expect(view(page, 'a')).toHaveAttribute('data-steps', '80');
  await expect(view(page, 'a')).toHaveAttribute('data-betti', '1,1');
  // What the attributes name later goes before what was given.
  foreign.put('/cloud.xyz', torusText(120));
  await page.locator('#a').evaluate((element) => element.setAttribute('src', 'cloud.xyz'));
  await expect(view(page, 'a')).toHaveAttribute('data-steps', '120');
  await expect(page.locator('#a').getByRole('group', { name: 'Plateau: cloud.xyz' })).toHaveCount(1);
});

test('autoplay plays, but not for visitors who asked for less motion', async ({ page }) => {
  const address = foreign.page(
    '/play',
    '<plateau-view id="a" shape="torus" size="300" autoplay></plateau-view>',
  );
  await page.goto(address);
  await expect(page.locator('#a').getByRole('button', { name: 'Pause' })).toBeVisible();
  await page.locator('#a').getByRole('button', { name: 'Pause' }).click();
  expect(await own(page, 'a', 'playing')).toBe(false);
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await page.goto(address);
  await finished(page, 'a');
  await expect(page.locator('#a').getByRole('button', { name: 'Play' })).toBeVisible();
  const [longest] = await own<{ middleStep: number }[]>(page, 'a', 'plateaus');
  expect(await own(page, 'a', 'currentStep')).toBe(longest?.middleStep);
});

test('by keyboard: the slider steps, the shape turns, and the page keeps its keys', async ({ page }) => {
  await page.goto(
    foreign.page('/keys', '<plateau-view id="a" shape="torus" size="300" step="50"></plateau-view>'),
  );
  await finished(page, 'a');
  await expect(view(page, 'a')).toHaveAttribute('data-step', '50');
  await page.keyboard.press('ArrowRight');
  expect(await own(page, 'a', 'currentStep')).toBe(50);
  await page.locator('#a').getByRole('slider', { name: 'Step' }).focus();
  await page.keyboard.press('ArrowRight');
  await expect(view(page, 'a')).toHaveAttribute('data-step', '51');
  const shape = page.locator('#a').getByRole('application');
  await expect(shape).toHaveAttribute('aria-busy', 'false');
  const before = await shape.screenshot();
  await shape.focus();
  for (let i = 0; i < 6; ++i) await page.keyboard.press('ArrowRight');
  await expect.poll(async () => (await shape.screenshot()).equals(before)).toBe(false);
  expect(await own(page, 'a', 'currentStep')).toBe(51);
  await page.keyboard.press(' ');
  await expect(page.locator('#a').getByRole('button', { name: 'Pause' })).toBeVisible();
});

test('a step that is shown from the beginning is drawn in full', async ({ page }) => {
  // A slow card: while the shape grows, more is computed than a picture carries.
  await page.addInitScript(() => {
    const soon = requestAnimationFrame.bind(window);
    const card = { slow: true };
    Object.assign(window, { card });
    window.requestAnimationFrame = (draw) =>
      soon((now) => (card.slow ? void setTimeout(() => soon(draw), 2_000) : draw(now)));
  });
  await page.goto(
    foreign.page(
      '/step',
      '<plateau-view id="a" shape="helix" size="1000" panels="shape" step="30"></plateau-view>',
    ),
  );
  await finished(page, 'a');
  await page.evaluate(() => Object.assign((window as unknown as { card: object }).card, { slow: false }));
  const shape = page.locator('#a .shape');
  const goTo = (step: number): Promise<void> =>
    page.locator('#a').evaluate((element, to) => {
      (element as unknown as { goTo(step: number): void }).goTo(to);
    }, step);
  await expect(shape).toHaveAttribute('aria-busy', 'false');
  await page.evaluate(async () => {
    for (let i = 0; i < 3; ++i) await new Promise((done) => requestAnimationFrame(done));
  });
  const before = await shape.screenshot();
  await goTo(200);
  await expect.poll(async () => (await shape.screenshot()).equals(before)).toBe(false);
  await goTo(30);
  await expect.poll(async () => (await shape.screenshot()).equals(before)).toBe(true);
});

test('on a narrow page the playhead is in sight where it comes to rest', async ({ page }) => {
  await page.setViewportSize({ width: 340, height: 700 });
  await page.goto(
    foreign.page('/narrow', '<plateau-view id="a" shape="helix" size="600" panels="diagram"></plateau-view>'),
  );
  await finished(page, 'a');
  const [longest] = await own<{ middleStep: number }[]>(page, 'a', 'plateaus');
  await expect(view(page, 'a')).toHaveAttribute('data-step', String(longest?.middleStep));
  const timeline = page.locator('#a .timeline');
  expect(
    await timeline.evaluate(({ scrollWidth, clientWidth }) => scrollWidth - clientWidth),
  ).toBeGreaterThan(100);
  await expect
    .poll(async () => {
      const [box, at] = [await timeline.boundingBox(), await page.locator('#a .playhead').boundingBox()];
      return box !== null && at !== null && box.x < at.x && at.x < box.x + box.width;
    })
    .toBe(true);
});

test('panels and themes', async ({ page }) => {
  await page.goto(
    foreign.page(
      '/panels',
      `<plateau-view id="a" shape="torus" size="150" theme="dark" panels="shape"></plateau-view>
       <plateau-view id="b" shape="torus" size="150" theme="light" panels="full"></plateau-view>`,
    ),
  );
  await finished(page, 'a');
  await finished(page, 'b');
  const shown = async (id: string): Promise<boolean[]> =>
    Promise.all(
      ['.stage', '.transport', '.film', '.side'].map((part) => page.locator(`#${id} ${part}`).isVisible()),
    );
  expect(await shown('a')).toEqual([true, true, false, false]);
  expect(await shown('b')).toEqual([true, true, true, true]);
  const background = (id: string): Promise<string> =>
    page.locator(`#${id}`).evaluate((element) => getComputedStyle(element).backgroundColor);
  expect(await background('a')).toBe('rgb(22, 29, 38)');
  expect(await background('b')).toBe('rgb(255, 255, 255)');
  await page.locator('#b').evaluate((element) => element.removeAttribute('theme'));
  await page.emulateMedia({ colorScheme: 'dark' });
  expect(await background('b')).toBe('rgb(22, 29, 38)');
  await page.locator('#a').evaluate((element) => element.setAttribute('panels', 'diagram'));
  await expect(page.locator('#a .film')).toBeVisible();
  expect(await shown('a')).toEqual([false, true, true, false]);
  await expect(page.locator('#a .shape canvas')).toHaveCount(0);
  await page.locator('#b .card').nth(1).click();
  const cards = await own<{ middleStep: number }[]>(page, 'b', 'plateaus');
  expect(await own(page, 'b', 'currentStep')).toBe(cards[1]?.middleStep);
});

test('axe finds nothing, in any panels and themes', async ({ page }) => {
  const all = (['shape', 'diagram', 'both', 'full'] as const).flatMap((panels) =>
    (['light', 'dark'] as const).map(
      (theme) =>
        `<h2>${panels}, ${theme}</h2>
         <plateau-view id="${panels}-${theme}" shape="torus" size="120" panels="${panels}" theme="${theme}"></plateau-view>`,
    ),
  );
  await page.setViewportSize({ width: 420, height: 900 });
  await page.goto(
    foreign.page(
      '/axe',
      `<main><h1>Plateau</h1>${all.join('')}<plateau-view id="none"></plateau-view></main>`,
    ),
  );
  for (const panels of ['shape', 'diagram', 'both', 'full'])
    for (const theme of ['light', 'dark']) {
      await page.locator(`#${panels}-${theme}`).scrollIntoViewIfNeeded();
      await finished(page, `${panels}-${theme}`);
    }
  await page.locator('#full-light').evaluate((element) => element.setAttribute('plateau', '99'));
  await expect(page.locator('#full-light').getByRole('alert')).toBeVisible();
  expect(await complaints(page)).toEqual([]);
});

test('the files of the element are open to all origins, those of the page are not', async ({
  page,
  baseURL,
}) => {
  const headers = async (path: string): Promise<Record<string, string>> =>
    (await page.request.get(`${baseURL}${path}`)).headers();
  const element = await headers('/embed/plateau-view.js');
  expect(element['access-control-allow-origin']).toBe('*');
  expect((await headers('/embed/'))['content-security-policy']).toContain('frame-ancestors *');
  const ownPage = await headers('/');
  expect(ownPage['access-control-allow-origin']).toBeUndefined();
  expect(ownPage['content-security-policy']).toContain("frame-ancestors 'self'");
});
