// A long run can be left at any moment. How soon is printed, not asserted: times are the machine's. What is asserted is
// why it is soon: the worker looks at messages between any two slices, and a slice ends when the clock says so.
import type { Page } from '@playwright/test';
import { drop, expect, root, state, test, torusText } from './page.ts';

const FULL = process.env['PLATEAU_FULL'] === '1';
const SIZE = FULL ? 100_000 : 4_000;
/** SLICE_MS of the worker. */
const BUDGET_MS = 12;

/** Times are milliseconds since 1970 here, the same on the page and in its worker. */
interface WorkerSeen {
  /** When each slice began, how long it took, and how often it saw on the clock that its budget was spent. */
  slices: { begin: number; duration: number; late: number }[];
  /** When the worker came to each request. */
  handled: Record<number, number>;
}
interface PageSeen {
  requests: { requestId: number; kind: string; posted: number; answered?: number }[];
  dropped: number;
  shown: number;
}
declare global {
  interface Window {
    cancelSeen: PageSeen;
    workerSeen: WorkerSeen;
  }
}

/** Goes before the program of the worker and only watches: slices come by a port, requests to the worker itself. */
function watchWorker(budgetMs: number): void {
  const seen: WorkerSeen = { slices: [], handled: {} };
  self.workerSeen = seen;
  const now = performance.now.bind(performance);
  let first: number | undefined;
  let late = 0;
  performance.now = () => {
    const time = now();
    first ??= time;
    if (time - first >= budgetMs) late += 1;
    return time;
  };
  const accessor = Object.getOwnPropertyDescriptor(MessagePort.prototype, 'onmessage');
  Object.defineProperty(MessagePort.prototype, 'onmessage', {
    set(this: MessagePort, handler: (event: MessageEvent) => void) {
      accessor?.set?.call(this, (event: MessageEvent) => {
        first = undefined;
        late = 0;
        const begin = now();
        handler(event);
        seen.slices.push({ begin: performance.timeOrigin + begin, duration: now() - begin, late });
      });
    },
  });
  self.addEventListener('message', ({ data }: MessageEvent<{ requestId: number }>) => {
    seen.handled[data.requestId] = performance.timeOrigin + now();
  });
}

function watchPage(): void {
  const seen: PageSeen = { requests: [], dropped: 0, shown: 0 };
  window.cancelSeen = seen;
  const now = (): number => performance.timeOrigin + performance.now();
  const Original = Worker;
  window.Worker = class extends Original {
    constructor(address: string | URL, options?: WorkerOptions) {
      super(address, options);
      this.addEventListener('message', ({ data }: MessageEvent<{ requestId?: number }>) => {
        const request = seen.requests.find(({ requestId }) => requestId === data.requestId);
        if (request) request.answered = now();
      });
    }
    override postMessage(message: { requestId: number; kind: string }, transfer?: unknown): void {
      seen.requests.push({ requestId: message.requestId, kind: message.kind, posted: now() });
      super.postMessage(message, transfer as Transferable[]);
    }
  };
  document.addEventListener(
    'drop',
    () => {
      seen.dropped = now();
      new MutationObserver((_, watch) => {
        seen.shown = now();
        watch.disconnect();
      }).observe(document.querySelector('main') as Node, { attributeFilter: ['data-source'] });
    },
    true,
  );
}

test.beforeEach(async ({ page }) => {
  await page.addInitScript(watchPage);
  await page.route('**/assets/main-*.js', async (route) => {
    const response = await route.fetch();
    const program = `(${watchWorker.toString()})(${BUDGET_MS});\n${await response.text()}`;
    await route.fulfill({ response, body: program });
  });
});

const pageSeen = (page: Page): Promise<PageSeen> => page.evaluate(() => window.cancelSeen);

async function workerSeen(page: Page): Promise<WorkerSeen> {
  const [worker] = page.workers();
  if (!worker) throw new Error('The page has no worker.');
  return worker.evaluate(() => self.workerSeen);
}

const ms = (value: number): string => `${Math.round(value)} ms`;

interface Examined {
  longestWait: number;
  /** Slices that went before one request, at most. */
  mostBefore: number;
  longestSlice: number;
  slices: number;
  /** What took long, in words: every wait and slice over 100 ms with its kind and when it began. */
  slow: string;
}

/** Asserts what bounds every wait of this page's requests, and tells the longest that the page waited. */
async function examine(page: Page): Promise<Examined> {
  const { requests } = await pageSeen(page);
  const { slices, handled } = await workerSeen(page);
  const waits: { what: string; at: number; took: number; slices: number }[] = [];
  for (const { requestId, kind, posted, answered } of requests) {
    const reached = handled[requestId];
    // `open` is answered by a later slice; the very first waits for the module.
    if (kind === 'open' || answered === undefined || reached === undefined) continue;
    const between = slices.filter(({ begin }) => begin > posted && begin < reached).length;
    waits.push({ what: kind, at: posted, took: answered - posted, slices: between });
  }
  // The slice that was due already goes first. More go where the page's thread was held up while it posted, which a
  // busy machine does now and then: hence the median.
  const byCount = waits.map((wait) => wait.slices).sort((a, b) => a - b);
  expect(byCount[byCount.length >> 1], 'slices that go before a request').toBeLessThanOrEqual(1);
  expect(slices.length).toBeGreaterThan(10);
  // The budget is seen to be spent by the loop over steps, and before it where the tree or the noise is in parts.
  for (const { late } of slices) expect(late, 'steps after the budget was spent').toBeLessThanOrEqual(2);
  const begin = Math.min(...requests.map(({ posted }) => posted));
  const slow = [
    ...waits,
    ...slices.map((slice) => ({ what: 'slice', at: slice.begin, took: slice.duration })),
  ].filter(({ took }) => took > 100);
  return {
    longestWait: Math.max(...waits.map((wait) => wait.took)),
    mostBefore: Math.max(...byCount),
    longestSlice: Math.max(...slices.map(({ duration }) => duration)),
    slices: slices.length,
    slow:
      slow.map(({ what, at, took }) => `${what} ${ms(took)} at ${ms(at - begin)}`).join(', ') || 'nothing',
  };
}

for (const share of [0, 0.1, 0.4, 0.75]) {
  test(`a run is left for another cloud after ${100 * share} % of it`, async ({ page }) => {
    test.setTimeout(FULL ? 1_500_000 : 150_000);
    await page.goto(`./?sample=torus&n=${SIZE}`);
    const enough = Math.max(1, share * SIZE);
    await expect
      .poll(async () => Number(await state(page, 'steps')), { timeout: FULL ? 1_200_000 : 120_000 })
      .toBeGreaterThanOrEqual(enough);
    await drop(page, 'other.xyz', torusText(150));
    await expect(root(page)).toHaveAttribute('data-source', 'other.xyz');
    await expect
      .poll(async () => (await pageSeen(page)).requests.find(({ kind }) => kind === 'close')?.answered)
      .toBeDefined();
    await expect(root(page)).toHaveAttribute('data-run-state', 'finished');

    const { requests, dropped, shown } = await pageSeen(page);
    const close = requests.filter(({ kind }) => kind === 'close');
    expect(close).toHaveLength(1);
    const [{ posted = 0, answered = 0 } = {}] = close;
    const { longestWait, longestSlice } = await examine(page);
    console.log(
      `${SIZE} points, left at ${100 * share} %: the other cloud shown after ${ms(shown - dropped)}, the run gone ` +
        `${ms(answered - posted)} after it was asked to; longest wait for an answer ${ms(longestWait)}, longest slice ${ms(longestSlice)}`,
    );
    // Nothing of the earlier run comes after it.
    expect(await state(page, 'steps')).toBe('150');
  });
}

test('a run goes to its end, and all along it could have been left', async ({ page }) => {
  test.setTimeout(FULL ? 3_000_000 : 150_000);
  await page.goto(`./?sample=torus&n=${SIZE}`);
  await expect(root(page)).toHaveAttribute('data-run-state', 'finished', {
    timeout: FULL ? 2_400_000 : 120_000,
  });
  expect(await state(page, 'steps')).toBe(String(SIZE));
  const { longestWait, mostBefore, longestSlice, slices, slow } = await examine(page);
  const { requests } = await pageSeen(page);
  expect(requests.filter(({ kind }) => kind === 'fetchDelta').length).toBeGreaterThan(5);
  console.log(
    `${SIZE} points to the end: ${slices} slices, the longest ${ms(longestSlice)}; ${requests.length} requests, ` +
      `the longest wait ${ms(longestWait)}, at most ${mostBefore} slices before one; over 100 ms: ${slow}`,
  );
});

// In five dimensions with large balls a step pumps against, and counts cycles among, thousands of simplices.
test('a pumped run of family dilated is left within a step, and could be all along', async ({ page }) => {
  test.setTimeout(FULL ? 600_000 : 120_000);
  const steps = FULL ? 100 : 40;
  await page.goto(`./#v=1&shape=s2xs1&n=3000&family=dilated&dilation=1&pump=1&steps=${steps}`);
  await expect.poll(async () => Number(await state(page, 'steps'))).toBeGreaterThan(20);
  await drop(page, 'other.xyz', torusText(150));
  await expect(root(page)).toHaveAttribute('data-source', 'other.xyz');
  await expect(root(page)).toHaveAttribute('data-run-state', 'finished');
  const { longestWait, longestSlice, slices, slow } = await examine(page);
  const { requests } = await pageSeen(page);
  expect(requests.filter(({ kind }) => kind === 'close')).toHaveLength(1);
  console.log(
    `dilated in R^5, pumped: ${slices} slices, the longest ${ms(longestSlice)}; the longest wait ${ms(longestWait)}; ` +
      `over 100 ms: ${slow}`,
  );
});
