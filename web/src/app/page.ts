import { PlateauClient } from '../client/plateau-client.ts';
import { PlateauError } from '../client/plateau-error.ts';
import { History } from '../model/history.ts';
import type { PlateauCard } from '../model/plateau-cards.ts';
import { Playback } from '../model/playback.ts';
import type { RunRecord } from '../model/record.ts';
import { grouped } from '../model/numbers.ts';
import type { AxisKind } from '../model/scale-axis.ts';
import { DiagramView } from '../view/diagram-view.ts';
import type { Failure, RunOptions } from '../worker/protocol.ts';
import { CardList } from './card-list.ts';
import { byId, setNotice } from './dom.ts';
import { RunFeed } from './run-feed.ts';
import { RunNotes } from './run-notes.ts';
import { SettingsForm } from './settings-form.ts';
import { shapeViewOrNone } from './shape-or-none.ts';
import { cloudSource, sourceName, withDefaults, type SourceChoice } from './source.ts';
import { StatusLine } from './status-line.ts';
import { Transport } from './transport.ts';
import { ViewTools } from './view-tools.ts';

const UNSUPPORTED_DIMENSION = 7;
/** While a run grows: the computation needs the time between two pictures. */
const PICTURES_EVERY_MS = 120;

/** What happens to the playhead when a cloud is opened. */
type Arrival =
  /** The film begins. */
  | 'play'
  /** The film waits at its beginning. */
  | 'wait'
  /** The playhead follows the computation and ends at the longest plateau: the answer. */
  | 'answer';

/** What was opened and how: all that is needed to open it again. */
interface Opening {
  readonly choice: SourceChoice;
  readonly options: RunOptions;
}

/** The page as a whole: one run that is shown, one playhead, and the way from one run to the next. */
export class Page {
  private readonly root = byId('plateau', HTMLElement);
  private readonly alert = byId('alert', HTMLElement);
  readonly client = new PlateauClient({ onDeath: (error) => this.showError(error) });
  readonly tools = new ViewTools();
  private readonly shape = shapeViewOrNone(this.tools.showScale);
  private readonly diagram = new DiagramView(byId('diagram', HTMLElement), (step) => this.goTo(step));
  private readonly status = new StatusLine(byId('readout', HTMLElement), byId('status', HTMLElement));
  private readonly transport = new Transport(this);
  private readonly cardList = new CardList(
    byId('cards', HTMLElement),
    byId('no-cards', HTMLElement),
    (card) => this.goTo(card.middleStep),
  );
  private readonly settings = new SettingsForm(() => this.openAgain());
  private readonly notes = new RunNotes(() => void this.runPastNoise());
  private readonly playback = new Playback();
  private readonly history = new History<Opening>();
  private readonly sample = byId('sample', HTMLSelectElement);

  /** Bytes that a run may take, where that is less than the module allows. */
  memoryLimit: number | undefined;
  private opening: AbortController | undefined;
  private failedChoice: SourceChoice | undefined;
  private feed: RunFeed | undefined;
  private choice: SourceChoice | undefined;
  private cards: readonly PlateauCard[] = [];
  private step = 0;
  private arrival: Arrival = 'wait';
  private playing = false;
  private frameRequest = 0;
  private picturesDue = 0;

  constructor() {
    this.tools.attach(this.shape);
  }

  get record(): RunRecord | undefined {
    return this.feed?.record;
  }

  get currentStep(): number {
    return this.step;
  }

  get currentCards(): readonly PlateauCard[] {
    return this.cards;
  }

  get currentChoice(): SourceChoice | undefined {
    return this.choice;
  }

  /** The bytes of a file in the command's format; rejects with a sentence. */
  async exportFile(format: 'betti-csv' | 'mesh-ply', step?: number): Promise<Uint8Array> {
    if (!this.feed) throw new Error('There is nothing to save yet.');
    return this.feed.run.exportFile(format, step);
  }

  /** Opens what was shown before (-1) or after (1), with its settings. */
  travel(by: -1 | 1): void {
    const opening = this.history.peek(by);
    if (opening) void this.open(opening.choice, opening.options, 'answer', by);
  }

  /** Opens another source. What is shown stays until the new one can be watched, and for good if it fails. */
  async open(choice: SourceChoice, options: RunOptions, arrival: Arrival, travel?: -1 | 1): Promise<void> {
    this.opening?.abort();
    const opening = (this.opening = new AbortController());
    const shown = this.feed;
    this.setNotices('', false);
    this.root.setAttribute('aria-busy', 'true');
    // The old run must not take slices from the new one; it goes on if the new one fails.
    shown?.run.pause().catch(() => undefined);
    const begin = performance.now();
    try {
      const asked = withDefaults(choice, options, this.memoryLimit);
      const run = await this.client.open(await cloudSource(choice), asked, opening.signal);
      if (opening.signal.aborted) {
        run.close().catch(() => undefined);
        return;
      }
      this.show(new RunFeed(run, this.listener()), choice, arrival, performance.now() - begin);
      this.settings.show(choice, options, run.opened);
      if (travel) this.history.go(travel);
      else this.history.add({ choice, options });
      this.markHistory();
      setNotice(byId('warning', HTMLElement), run.opened.warnings.join(' '));
    } catch (error) {
      if (opening.signal.aborted) return;
      shown?.run.resume().catch(() => undefined);
      this.failedChoice = choice;
      this.markSample();
      this.showEmpty();
      this.showError(error, choice.kind === 'file' && choice.columns === undefined ? sourceName(choice) : '');
    }
    this.opening = undefined;
    this.root.removeAttribute('aria-busy');
  }

  /** The file that could not be read without columns, with them. */
  openWithColumns(columns: readonly number[]): void {
    if (this.failedChoice?.kind !== 'file') return;
    void this.open({ kind: 'file', file: this.failedChoice.file, columns }, {}, 'answer');
  }

  showError(error: unknown, about = ''): void {
    const message = error instanceof Error ? error.message : String(error);
    const asksForColumns = error instanceof PlateauError && error.code === UNSUPPORTED_DIMENSION;
    this.setNotices(about === '' ? message : `${about}: ${message}`, asksForColumns && about !== '');
  }

  dismissError(): void {
    this.setNotices('', false);
  }

  togglePlay(): void {
    if (this.playing) this.pause();
    else this.play();
  }

  play(): void {
    const { record } = this;
    if (!record || this.playing) return;
    this.arrival = 'wait';
    if (this.step >= record.stepCount && record.state !== 'running') this.showStep(1);
    this.playing = true;
    this.playback.restart();
    this.transport.setPlaying(true);
    this.root.dataset['playing'] = 'true';
    let before = performance.now();
    const frame = (now: number): void => {
      const elapsed = Math.min(250, Math.max(0, now - before));
      before = now;
      this.advanceFilm(elapsed);
      if (this.playing) this.frameRequest = requestAnimationFrame(frame);
    };
    this.frameRequest = requestAnimationFrame(frame);
  }

  pause(): void {
    if (!this.playing) return;
    this.playing = false;
    cancelAnimationFrame(this.frameRequest);
    this.transport.setPlaying(false);
    this.root.dataset['playing'] = 'false';
    if (this.step > 0) this.showStep(this.step);
  }

  move(steps: number): void {
    this.goTo(this.step + steps);
  }

  /** Moves the playhead by hand: the film stops. */
  goTo(step: number): void {
    const { record } = this;
    if (!record || record.stepCount === 0) return;
    this.arrival = 'wait';
    this.pause();
    this.showStep(Math.min(record.stepCount, Math.max(1, step)));
  }

  /** The next plateau along the film, the first one after the last. */
  nextPlateau(): void {
    const along = this.cards.map((card) => card.middleStep).sort((a, b) => a - b);
    const next = along.find((step) => step > this.step) ?? along[0];
    if (next !== undefined) this.goTo(next);
  }

  set speed(factor: number) {
    this.playback.speed = factor;
  }

  get axisKind(): AxisKind {
    return this.diagram.axisKind;
  }

  setAxis(kind: AxisKind): void {
    this.diagram.setAxis(kind);
  }

  /** Looks at the whole shape again. */
  fit(): void {
    this.shape?.fit();
  }

  /** Where nothing was opened yet, the way in is shown. */
  showEmpty(): void {
    byId('empty', HTMLElement).hidden = this.choice !== undefined;
    byId('film', HTMLElement).inert = byId('tools', HTMLElement).inert = this.choice === undefined;
    if (!this.choice) this.root.dataset['runState'] = 'empty';
  }

  applyTheme(): void {
    this.shape?.applyTheme();
    this.diagram.requestPaint();
  }

  private openAgain(): void {
    if (!this.choice) return;
    try {
      const { choice, options } = this.settings.asked(this.choice);
      void this.open(choice, options, 'answer');
    } catch (error) {
      this.showError(error);
    }
  }

  /** Lifts the stop at the noise: the run goes on where it is, or where it has ended. */
  private async runPastNoise(): Promise<void> {
    const { feed } = this;
    if (!feed) return;
    try {
      await feed.runPastNoise();
      if (feed === this.feed) this.showRunState(feed.record);
    } catch (error) {
      this.showError(error);
    }
  }

  private show(feed: RunFeed, choice: SourceChoice, arrival: Arrival, readMs: number): void {
    this.pause();
    this.feed?.dispose();
    this.feed = feed;
    this.choice = choice;
    this.cards = [];
    this.step = 0;
    this.arrival = arrival;
    this.shape?.setRecord(feed.record);
    this.diagram.setRecord(feed.record);
    this.cardList.show([], false);
    this.transport.setSteps(1);
    this.status.show(feed.record, undefined, false);
    byId('legend-voids', HTMLElement).hidden = feed.record.dimension < 3;
    this.markSample();
    this.showEmpty();
    const { count } = feed.record.frame;
    byId('source', HTMLElement).textContent = `${sourceName(choice)} · ${grouped(count)} points`;
    this.root.dataset['source'] = choice.kind === 'sample' ? choice.shape : choice.file.name;
    this.root.dataset['step'] = '0';
    this.showRunState(feed.record);
    this.notes.begin(feed.record, readMs);
    feed.start();
  }

  private markHistory(): void {
    byId('undo', HTMLButtonElement).disabled = !this.history.peek(-1);
    byId('redo', HTMLButtonElement).disabled = !this.history.peek(1);
  }

  /** The list of samples names what is shown, not what was tried. */
  private markSample(): void {
    this.sample.value = this.choice?.kind === 'sample' ? this.choice.shape : '';
  }

  private listener() {
    return {
      grown: () => this.grown(),
      cardsFound: (cards: readonly PlateauCard[]) => this.showCards(cards),
      ended: (stopped: Failure | undefined) => this.ended(stopped),
      failed: (error: unknown) => this.feedFailed(error),
    };
  }

  private grown(): void {
    const { record } = this;
    if (!record) return;
    const ended = record.state === 'finished' || record.state === 'stopped';
    const first = this.step === 0 && record.stepCount > 0;
    if (ended || first || performance.now() >= this.picturesDue) {
      this.picturesDue = performance.now() + PICTURES_EVERY_MS;
      this.shape?.sync();
      this.transport.setSteps(record.stepCount);
      this.diagram.requestPaint();
      if (record.stepCount > 0) {
        if (this.arrival === 'answer') this.showStep(record.stepCount);
        else if (first) this.showStep(1);
        if (this.arrival === 'play') this.play();
      }
    }
    this.showRunState(record);
  }

  private showCards(cards: readonly PlateauCard[]): void {
    const { record } = this;
    if (!record) return;
    this.cards = cards;
    this.diagram.setCards(cards);
    this.cardList.show(cards, record.state === 'finished' || record.state === 'stopped');
    if (this.step > 0) this.cardList.mark(record.summary(this.step));
  }

  private ended(stopped: Failure | undefined): void {
    const answer = this.cards[0];
    const follows = this.arrival === 'answer';
    this.arrival = 'wait';
    if (follows && this.step > 0) this.showStep(answer?.middleStep ?? this.step);
    if (stopped) this.setNotices(stopped.message, false);
  }

  /** The run is lost; what the record holds can still be looked at. */
  private feedFailed(error: unknown): void {
    if (this.record) {
      this.record.state = 'stopped';
      this.showRunState(this.record);
    }
    this.showError(error);
  }

  private showRunState(record: RunRecord): void {
    this.root.dataset['runState'] = record.state;
    this.root.dataset['steps'] = String(record.stepCount);
    this.root.dataset['hash'] = record.hash;
    this.notes.show();
  }

  private showStep(step: number): void {
    const { record } = this;
    if (!record) return;
    this.step = step;
    const summary = record.summary(step);
    this.shape?.showStep(step);
    this.diagram.showStep(step);
    this.transport.showStep(summary);
    this.cardList.mark(summary);
    this.status.show(record, summary, this.playing || this.arrival === 'answer');
    this.root.dataset['step'] = String(step);
    this.root.dataset['family'] = summary.family;
    this.root.dataset['betti'] = summary.betti.join(',');
  }

  private advanceFilm(elapsedMs: number): void {
    const { record } = this;
    if (!record) return;
    const next = this.playback.advance(record, this.step, elapsedMs);
    if (next !== this.step) this.showStep(next);
    const complete = record.state === 'finished' || record.state === 'stopped';
    if (complete && next >= record.stepCount) this.pause();
  }

  private setNotices(message: string, askForColumns: boolean): void {
    this.alert.textContent = message;
    byId('trouble', HTMLElement).hidden = message === '';
    byId('columns-form', HTMLFormElement).hidden = !askForColumns;
  }
}
