import { expect, test, type Locator, type Page } from '@playwright/test';
import { ForeignServer, rememberEvents, type SeenEvent } from './foreign-page.ts';
import { torusText } from './page.ts';

let foreign: ForeignServer;

test.beforeAll(async ({ baseURL }) => {
  foreign = await ForeignServer.start(baseURL ?? '');
});
test.afterAll(() => foreign.stop());

const view = (page: Page, id: string): Locator => page.locator(`#${id} .view`);
const alertOf = (page: Page, id: string): Locator => page.locator(`#${id}`).getByRole('alert');
const steps = (page: Page, id: string, count: number): Promise<void> =>
  expect(view(page, id)).toHaveAttribute('data-steps', String(count));
const codes = async (events: () => Promise<SeenEvent[]>): Promise<unknown[]> =>
  (await events()).filter(({ type }) => type === 'error').map(({ detail }) => detail['code']);

test('values that make no sense are named, and unknown attributes are none of its business', async ({
  page,
}) => {
  const events = await rememberEvents(page);
  await page.goto(
    foreign.page(
      '/values',
      `<plateau-view id="a" shape="torus" size="150" nu="1,x" panels="sideways" colour="red"></plateau-view>`,
    ),
  );
  await steps(page, 'a', 150);
  await expect(alertOf(page, 'a')).toContainText(
    'nu="1,x" was not understood; it takes whole numbers from 0 on',
  );
  await expect(alertOf(page, 'a')).toContainText(
    'panels="sideways" was not understood; it takes shape, diagram',
  );
  await expect(view(page, 'a')).toHaveAttribute('data-panels', 'both');
  expect(await codes(events)).toEqual(['bad-attribute']);
  await page.locator('#a').evaluate((element) => {
    element.removeAttribute('nu');
    element.removeAttribute('panels');
  });
  await expect(alertOf(page, 'a')).toBeHidden();
});

test('what cannot be opened is said, and what is shown stays', async ({ page }) => {
  const events = await rememberEvents(page);
  foreign.put('/good.xyz', torusText(130));
  foreign.put('/empty.xyz', '');
  await page.goto(
    foreign.page('/dead', '<plateau-view id="a" src="good.xyz" panels="diagram"></plateau-view>'),
  );
  await steps(page, 'a', 130);
  const attempts = [
    ['src', 'gone.xyz', 'cannot-read', 'it answers 404'],
    ['src', 'http://127.0.0.1:9/cloud.xyz', 'cannot-read', 'does not allow it'],
    ['src', 'empty.xyz', 'empty-input', ''],
    ['family', 'bogus', 'invalid-option', 'There is no family "bogus"'],
  ] as const;
  for (const [name, value, code, sentence] of attempts) {
    await page.locator('#a').evaluate(
      (element, [attribute, text]) => {
        element.setAttribute('src', 'good.xyz');
        element.setAttribute(attribute, text);
      },
      [name, value] as const,
    );
    await expect(alertOf(page, 'a')).toContainText(sentence);
    await expect.poll(async () => (await codes(events)).at(-1)).toBe(code);
    await steps(page, 'a', 130);
    await expect(view(page, 'a')).not.toHaveAttribute('aria-busy');
  }
  await page.locator('#a').evaluate((element) => {
    element.removeAttribute('src');
    element.removeAttribute('family');
    Object.assign(element, { shape: 'teapot' });
  });
  await expect(alertOf(page, 'a')).toContainText('There is no shape "teapot"; the shapes are');
  await page
    .locator('#a')
    .evaluate((element) => Object.assign(element, { shape: 'torus', size: 90, plateau: 40 }));
  await steps(page, 'a', 90);
  await expect(alertOf(page, 'a')).toContainText('There is no plateau 40');
  expect((await codes(events)).at(-1)).toBe('no-such-plateau');
});

test('while another opening fails the run that is shown waits; then it goes on', async ({ page }) => {
  await page.goto(
    foreign.page('/on', '<plateau-view id="a" shape="torus" size="40000" panels="diagram"></plateau-view>'),
  );
  await expect(view(page, 'a')).toHaveAttribute('data-run-state', 'running');
  await page.locator('#a').evaluate((element) => element.setAttribute('src', 'gone.xyz'));
  await expect(alertOf(page, 'a')).toContainText('it answers 404');
  const count = async (): Promise<number> => Number(await view(page, 'a').getAttribute('data-steps'));
  const before = await count();
  await expect.poll(count).toBeGreaterThan(before + 50);
});

test('a module that cannot be fetched is said; the next opening begins anew', async ({ page }) => {
  const events = await rememberEvents(page);
  await page.route('**/plateau.wasm', (route) => route.abort());
  await page.goto(
    foreign.page(
      '/blocked',
      '<plateau-view id="a" shape="torus" size="150" panels="diagram"></plateau-view>',
    ),
  );
  await expect(alertOf(page, 'a')).toContainText('plateau.wasm cannot be read');
  expect(await codes(events)).toEqual(['worker-failed']);
  await page.unroute('**/plateau.wasm');
  await page.locator('#a').evaluate((element) => element.setAttribute('size', '160'));
  await steps(page, 'a', 160);
  await expect(alertOf(page, 'a')).toBeHidden();
});

test('a measured shape whose file is gone is said in words', async ({ page }) => {
  const events = await rememberEvents(page);
  await page.route('**/bunny-points.js', (route) => route.abort());
  await page.goto(
    foreign.page('/gone', '<plateau-view id="a" shape="bunny" panels="diagram"></plateau-view>'),
  );
  await expect(alertOf(page, 'a')).toContainText('What the shape "bunny" is made of cannot be read');
  expect(await codes(events)).toEqual(['cannot-read']);
});

test('a policy that does not allow what is needed is named in a sentence', async ({ page }) => {
  const body = '<plateau-view id="a" shape="torus" size="90" panels="diagram"></plateau-view>';
  for (const [directive, sentence] of [
    ['worker-src', 'policy of this page does not allow it'],
    ['connect-src', 'plateau.wasm cannot be read; its server, or the content-security policy of this page'],
  ] as const) {
    foreign.without = [directive];
    try {
      await page.goto(foreign.page(`/without-${directive}`, body));
      await expect(alertOf(page, 'a')).toContainText(sentence);
    } finally {
      foreign.without = [];
    }
  }
});

test('a worker that dies takes nothing from the screen, and only those who wait for it are told', async ({
  page,
}) => {
  const events = await rememberEvents(page);
  await page.goto(
    foreign.page(
      '/death',
      `<plateau-view id="a" shape="torus" size="150" panels="diagram"></plateau-view>
       <plateau-view id="b" shape="torus" size="40000" panels="diagram"></plateau-view>${'<br>'.repeat(80)}`,
    ),
  );
  await expect(view(page, 'a')).toHaveAttribute('data-run-state', 'finished');
  await expect(view(page, 'b')).toHaveAttribute('data-run-state', 'running');
  // While nobody waits for it.
  await page.evaluate(() => scrollTo(0, 1e6));
  await expect(page.locator('#b')).not.toBeInViewport();
  await page.workers()[0]?.evaluate(() =>
    setTimeout(() => {
      throw new Error('out of bounds');
    }),
  );
  await expect(alertOf(page, 'b')).toContainText('out of bounds');
  await page.locator('#b').scrollIntoViewIfNeeded();
  await expect(view(page, 'b')).toHaveAttribute('data-run-state', 'stopped');
  await expect(alertOf(page, 'a')).toBeHidden();
  const failed = (await events()).filter(({ type }) => type === 'error');
  expect(failed).toMatchObject([{ id: 'b', detail: { code: 'worker-failed' } }]);
  await page.locator('#b').evaluate((element) => element.setAttribute('size', '170'));
  await steps(page, 'b', 170);
  expect(page.workers()).toHaveLength(1);
});

test('without WebGL the diagram and the plateaus work', async ({ page }) => {
  const events = await rememberEvents(page);
  await page.addInitScript(() => {
    // eslint-disable-next-line @typescript-eslint/unbound-method -- it is called with its canvas
    const { getContext } = HTMLCanvasElement.prototype;
    Object.assign(HTMLCanvasElement.prototype, {
      getContext(this: HTMLCanvasElement, kind: string) {
        return kind === '2d' ? getContext.call(this, kind) : null;
      },
    });
  });
  await page.goto(
    foreign.page('/flat', '<plateau-view id="a" shape="torus" size="150" panels="full"></plateau-view>'),
  );
  await expect(view(page, 'a')).toHaveAttribute('data-run-state', 'finished');
  await expect(page.locator('#a')).toContainText('The shape needs WebGL 2');
  await expect(page.locator('#a .card').first()).toBeVisible();
  expect(await codes(events)).toEqual(['no-graphics']);
});

test('a browser that is too old is told so in a sentence', async ({ page }) => {
  const events = await rememberEvents(page);
  const old: readonly [string, () => void][] = [
    ['exceptions in WebAssembly', () => (WebAssembly.validate = () => false)],
    ['constructed style sheets', () => Reflect.deleteProperty(CSSStyleSheet.prototype, 'replaceSync')],
  ];
  for (const [lacks, make] of old) {
    const context = await page.context().browser()?.newContext();
    const oldPage = await context?.newPage();
    if (!oldPage) throw new Error('no page');
    const told = await rememberEvents(oldPage);
    await oldPage.addInitScript(make);
    await oldPage.goto(foreign.page('/old', '<plateau-view id="a" shape="torus"></plateau-view>'));
    await expect(oldPage.locator('#a')).toContainText(
      `This browser lacks ${lacks}. Plateau needs Chrome and Edge 111, Firefox 114, Safari 16.4, or a newer one.`,
    );
    expect(await codes(told)).toEqual(['unsupported-browser']);
    await context?.close();
  }
  await page.goto(
    foreign.page('/new', '<plateau-view id="a" shape="torus" size="60" panels="diagram"></plateau-view>'),
  );
  await steps(page, 'a', 60);
  expect(await codes(events)).toEqual([]);
});

test('the page itself says so at its start, also where it has nothing to compute', async ({
  browser,
  baseURL,
}) => {
  const old: readonly [string, () => void][] = [
    ['exceptions in WebAssembly', () => (WebAssembly.validate = () => false)],
    ['mixed colors', () => (CSS.supports = () => false)],
  ];
  for (const [lacks, make] of old) {
    const context = await browser.newContext();
    const ownPage = await context.newPage();
    await ownPage.addInitScript(make);
    await ownPage.goto(`${baseURL ?? ''}/?sample=none`);
    await expect(ownPage.getByRole('alert').first()).toContainText(`This browser lacks ${lacks}.`);
    await context.close();
  }
});

test('no program has what older browsers cannot even read, so that they get as far as the sentence', async ({
  page,
}) => {
  const programs: Promise<string>[] = [];
  page.on('response', (response) => {
    if (response.url().endsWith('.js')) programs.push(response.text());
  });
  await page.goto('./?sample=none');
  await expect(page.locator('main')).toHaveAttribute('data-run-state', 'empty');
  await page.goto(foreign.page('/new', '<plateau-view id="a"></plateau-view>'));
  await expect(view(page, 'a')).toHaveCount(1);
  expect(programs.length).toBeGreaterThan(3);
  for (const program of await Promise.all(programs)) expect(/\bstatic\s*\{/.test(program)).toBe(false);
});
