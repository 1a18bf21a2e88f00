import { openPoints } from '../client/open-points.ts';
import { memoryBeside, memoryInWords } from '../model/forecast.ts';
import { scaleOf, type AxisKind } from '../model/scale-axis.ts';
import type { RunOptions } from '../worker/protocol.ts';
import { ComparedPair, type PairView } from './compared-pair.ts';
import { byId } from './dom.ts';
import type { ShownRun } from './earlier-run.ts';
import { openingOf, type Opening } from './opening.ts';
import type { Page } from './page.ts';
import { RunFeed, type FeedListener } from './run-feed.ts';
import { cloudSource, sourceName, withDefaults } from './source.ts';

/** With less than this no second run can begin. */
const LEAST_MEMORY = 16 * 2 ** 20;

/** Resolves as soon as the page opens no run of its own. */
function pageIdle(): Promise<void> {
  const root = byId('plateau', HTMLElement);
  return new Promise((resolve) => {
    const look = (): void => {
      if (root.hasAttribute('aria-busy')) return;
      watch.disconnect();
      resolve();
    };
    const watch = new MutationObserver(look);
    watch.observe(root, { attributeFilter: ['aria-busy'] });
    look();
  });
}

/** Opens a second run beside that of the page, and gives the page back. */
export class Comparison {
  private readonly button = byId('open-compare', HTMLButtonElement);
  private shown: ComparedPair | undefined;
  private opening: AbortController | undefined;
  private refused: Opening | undefined;

  constructor(
    private readonly page: Page,
    /** Of the page and of what is compared. */
    private readonly setAxis: (kind: AxisKind) => void,
  ) {}

  /** What is compared now. */
  get pair(): ComparedPair | undefined {
    return this.shown;
  }

  /**
   * Opens the second run; what is shown stays until it can be watched, and for good if that fails. Without a view the
   * playhead stays at its scale.
   */
  async open(second: Opening, view?: PairView): Promise<void> {
    const { page, button } = this;
    this.opening?.abort();
    const { signal } = (this.opening = new AbortController());
    this.refused = undefined;
    page.dismissError();
    button.setAttribute('aria-busy', 'true');
    try {
      await pageIdle();
      const begin = performance.now();
      const asked = withDefaults(second.choice, second.options, this.memoryLeft());
      const read = () => cloudSource(second.choice);
      const { run, options: taken } = await openPoints(page.client, read, asked, signal);
      const readMs = performance.now() - begin;
      await pageIdle();
      const first = page.shownRun();
      if (signal.aborted || !first) {
        run.close().catch(() => undefined);
        return;
      }
      const feed = new RunFeed(run, this.troubles());
      const { opened } = run;
      // A session brings its own settings, and is its points where others are asked for.
      const { choice, options } = taken === asked ? second : openingOf(second.choice, taken);
      this.show(first, { choice, options, opened, record: feed.record, feed, cards: [] }, view, readMs);
      feed.start();
    } catch (error) {
      if (signal.aborted) return;
      const { choice } = second;
      const asks = choice.kind === 'file' && choice.columns === undefined;
      if (asks) this.refused = second;
      page.showError(error, asks ? sourceName(choice) : '');
    }
    this.opening = undefined;
    button.removeAttribute('aria-busy');
  }

  /** The second file could not be read without knowing what its columns are. Returns false if it was another one. */
  openRefusedWith(columns: readonly number[], options: RunOptions): boolean {
    if (this.refused?.choice.kind !== 'file') return false;
    void this.open({
      choice: { ...this.refused.choice, columns },
      options: { ...this.refused.options, ...options },
    });
    return true;
  }

  /** The page alone, at the step that its run shows. */
  close(): void {
    this.opening?.abort();
    this.opening = undefined;
    this.refused = undefined;
    this.button.removeAttribute('aria-busy');
    if (!this.shown) return;
    const step = this.shown.firstStep;
    const focused = document.activeElement?.closest('#compared-film, .second-stage, .compared-side');
    this.shown.dispose();
    this.shown = undefined;
    this.page.goTo(step);
    if (focused) this.button.focus();
  }

  /** What a second run may take; a sentence is thrown where that is nothing, or where there is no first one. */
  private memoryLeft(): number {
    const first = this.page.shownRun();
    if (!first) throw new Error('There is nothing to compare with yet: open a point cloud first.');
    const left = memoryBeside(first.record, this.shown?.runs[1].record);
    if (left >= LEAST_MEMORY) return left;
    throw new Error(
      `The first run takes the memory of this page (${memoryInWords(first.record.memoryLimitBytes)}): ` +
        'there is none left for a second one. Let the first stop earlier.',
    );
  }

  /** What goes wrong with the second run, said as of it. */
  private troubles(): FeedListener {
    return {
      grown: () => undefined,
      cardsFound: () => undefined,
      ended: (stopped) => {
        if (stopped) this.page.showError(`Run B: ${stopped.message}`);
      },
      failed: (error) => this.page.showError(error),
    };
  }

  private show(first: ShownRun, second: ShownRun, view: PairView | undefined, readMs: number): void {
    const { page, shown } = this;
    const start = page.currentStep > 0 ? scaleOf(first.record, page.currentStep) : 0;
    const scale = shown?.view.scale ?? start;
    const axis = page.diagram.axisKind;
    page.goTo(page.currentStep);
    shown?.dispose();
    const actions = { close: () => this.close(), setAxis: this.setAxis };
    this.shown = new ComparedPair(page, first, { ...second, readMs }, view ?? { scale }, actions);
    this.shown.setAxis(axis);
    this.shown.film.speed = Number(byId('speed', HTMLSelectElement).value);
  }
}
