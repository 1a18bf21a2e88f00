import { memoryBeside, memoryInWords } from '../model/forecast.ts';
import { scaleOf, type AxisKind } from '../model/scale-axis.ts';
import { ComparedPair, type PairView } from './compared-pair.ts';
import { byId } from './dom.ts';
import type { ShownRun } from './earlier-run.ts';
import type { Opening } from './opening.ts';
import type { Page } from './page.ts';
import { RunFeed, type FeedListener } from './run-feed.ts';
import { cloudSource, withDefaults } from './source.ts';

/** With less than this no second run can begin. */
const LEAST_MEMORY = 16 * 2 ** 20;

/** Opens a second run beside that of the page, and gives the page back. */
export class Comparison {
  private shown: ComparedPair | undefined;
  private opening: AbortController | undefined;

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
    const { page } = this;
    this.opening?.abort();
    const { signal } = (this.opening = new AbortController());
    const root = byId('plateau', HTMLElement);
    page.dismissError();
    root.setAttribute('aria-busy', 'true');
    try {
      const first = page.shownRun();
      if (!first) throw new Error('There is nothing to compare with yet: open a point cloud first.');
      const left = memoryBeside(first.record, this.shown?.runs[1].record);
      if (left < LEAST_MEMORY)
        throw new Error(
          `The first run takes the memory of this page (${memoryInWords(first.record.memoryLimitBytes)}): ` +
            'there is none left for a second one. Let the first stop earlier.',
        );
      const asked = withDefaults(second.choice, second.options, left);
      const run = await page.client.open(await cloudSource(second.choice), asked, signal);
      const feed = new RunFeed(run, this.troubles());
      // A session brings its own settings.
      const options = run.opened.session?.options ?? second.options;
      const { choice } = second;
      const beside = { choice, options, opened: run.opened, record: feed.record, feed, cards: [] };
      // The page may have found more plateaus meanwhile.
      this.show(page.shownRun() ?? first, beside, view);
      feed.start();
    } catch (error) {
      if (signal.aborted) return;
      page.showError(error);
    }
    this.opening = undefined;
    root.removeAttribute('aria-busy');
  }

  /** The page alone, at the step that its run shows. */
  close(): void {
    if (this.opening) byId('plateau', HTMLElement).removeAttribute('aria-busy');
    this.opening?.abort();
    this.opening = undefined;
    if (!this.shown) return;
    const step = this.shown.firstStep;
    const focused = document.activeElement?.closest('#compared-film, .second-stage, .compared-side');
    this.shown.dispose();
    this.shown = undefined;
    this.page.goTo(step);
    if (focused) byId('open-compare', HTMLElement).focus();
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

  private show(first: ShownRun, second: ShownRun, view: PairView | undefined): void {
    const { page, shown } = this;
    const start = page.currentStep > 0 ? scaleOf(first.record, page.currentStep) : 0;
    const axis = page.diagram.axisKind;
    page.goTo(page.currentStep);
    const before = shown?.view;
    shown?.dispose();
    this.shown = new ComparedPair(page, first, second, view ?? { scale: before?.scale ?? start }, {
      close: () => this.close(),
      setAxis: this.setAxis,
    });
    this.shown.setAxis(axis);
    this.shown.film.speed = Number(byId('speed', HTMLSelectElement).value);
  }
}
