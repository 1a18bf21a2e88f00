import type { RemoteRun } from '../client/plateau-client.ts';
import type { PlateauCard } from '../model/plateau-cards.ts';
import type { RunRecord } from '../model/record.ts';
import { grouped } from '../model/numbers.ts';
import { stepAt } from '../model/scale-axis.ts';
import { viewOf, viewText } from '../model/view-state.ts';
import { DiagramView } from '../view/diagram-view.ts';
import type { Failure, RunOptions } from '../worker/protocol.ts';
import { Announcer } from './announcer.ts';
import { CardList } from './card-list.ts';
import { byId, showLegend } from './dom.ts';
import { EarlierRun, sameShape, type ShownRun } from './earlier-run.ts';
import { Film } from './film.ts';
import { Notices } from './notices.ts';
import { openingOf, type Arrival, type Opening, type Restored } from './opening.ts';
import { pageClient } from './page-client.ts';
import { PlateauWalk, type WalkScreen } from './plateau-walk.ts';
import { PumpPanel } from './pump-panel.ts';
import { RunFeed, type FeedListener } from './run-feed.ts';
import { RunNotes } from './run-notes.ts';
import { SettingsForm } from './settings-form.ts';
import { shapeViewOrNone } from './shape-or-none.ts';
import { cloudSource, sourceName, withDefaults, type SourceChoice } from './source.ts';
import { StatusLine } from './status-line.ts';
import { pageTransport } from './transport.ts';
import { Travel } from './travel.ts';
import { ViewTools } from './view-tools.ts';

/** While a run grows: the computation needs the time between two pictures. */
const PICTURES_EVERY_MS = 120;

/** The page as a whole: one run that is shown, one playhead, and the way from one run to the next. */
export class Page implements FeedListener, WalkScreen {
  private readonly root = byId('plateau', HTMLElement);
  private readonly notices = new Notices();
  private readonly earlier = new EarlierRun();
  readonly client = pageClient((error) => this.showError(error));
  readonly tools = new ViewTools();
  /** None without WebGL. */
  readonly shape = shapeViewOrNone(this.tools.showScale);
  readonly diagram = new DiagramView(byId('diagram', HTMLElement), byId('timeline', HTMLElement), (step) =>
    this.goTo(step),
  );
  private readonly status = new StatusLine(byId('readout', HTMLElement), byId('status', HTMLElement));
  private readonly transport = pageTransport(this);
  private readonly cardList = new CardList(
    byId('cards', HTMLElement),
    byId('no-cards', HTMLElement),
    (card) => {
      this.goTo(card.middleStep);
      this.shape?.frameAll();
    },
  );
  private readonly announcer = new Announcer(byId('spoken', HTMLElement));
  private readonly settings = new SettingsForm((place) => this.openAgain(place));
  private readonly notes = new RunNotes(() => this.goOn('runPastNoise'));
  private readonly pumps = new PumpPanel();
  readonly walk = new PlateauWalk(this, this.announcer);
  private readonly film = new Film(this);
  private readonly travels = new Travel();
  private readonly sample = byId('sample', HTMLSelectElement);

  /** Bytes that a run may take, where that is less than the module allows. */
  memoryLimit: number | undefined;
  private opening: AbortController | undefined;
  private askedChoice: SourceChoice | undefined;
  private feed: RunFeed | undefined;
  private choice: SourceChoice | undefined;
  private options: RunOptions = {};
  private cards: readonly PlateauCard[] = [];
  /** Where the playhead returns to, of the steps that there are; none: to the last one. */
  private returnTo: ((record: RunRecord) => number) | undefined;
  private step = 0;
  private arrival: Arrival = 'wait';
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

  /** What is computed; none before the first cloud. */
  get run(): RemoteRun | undefined {
    return this.feed?.run;
  }

  /** How the run is looked at, as a session keeps it. */
  viewState(): string {
    return viewText({ axis: this.diagram.axisKind, ...(this.shape ? { pose: this.shape.pose } : {}) });
  }

  /** Opens what was shown before (-1) or after (1), with its settings; also while such an opening is under way. */
  travel(by: -1 | 1): void {
    const opening = this.travels.go(by);
    if (opening) void this.open(opening.choice, opening.options, this.arrivalAt(opening.choice), true);
  }

  /** Opens another source. What is shown stays until the new one can be watched, and for good if it fails. */
  async open(
    choice: SourceChoice,
    options: RunOptions,
    arrival: Arrival,
    travelling = false,
    linked?: Restored,
  ): Promise<void> {
    this.opening?.abort();
    const opening = (this.opening = new AbortController());
    const shown = this.feed;
    this.notices.clear();
    this.root.setAttribute('aria-busy', 'true');
    // An opening by undo or redo that this one replaces led nowhere.
    if (!travelling) this.travels.turnBack();
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
      const { session } = run.opened;
      const opened = session ? openingOf(choice, session.options) : { choice, options };
      const restored = session ? { ...session, view: viewOf(session.view) } : linked;
      const feed = new RunFeed(run, this, restored?.reached);
      this.show(feed, opened, session ? 'return' : arrival, begin);
      if (restored) this.restore(restored);
      this.settings.show(opened.choice, opened.options, run.opened);
      this.travels.arrive(travelling ? undefined : opened);
      this.askedChoice = choice;
      this.notices.opened(run.opened, choice.kind === 'file' && choice.columns === undefined);
    } catch (error) {
      if (opening.signal.aborted) return;
      shown?.run.resume().catch(() => undefined);
      this.travels.turnBack();
      this.askedChoice = choice;
      this.markSample();
      this.showEmpty();
      this.showError(error, choice.kind === 'file' && choice.columns === undefined ? sourceName(choice) : '');
    }
    this.opening = undefined;
    this.root.removeAttribute('aria-busy');
  }

  /** The file whose columns were asked for; none: they are distances. */
  openFailedWith(columns: readonly number[], options: RunOptions): void {
    if (this.askedChoice?.kind !== 'file') return;
    void this.open({ ...this.askedChoice, columns }, options, 'answer');
  }

  showError(error: unknown, about = ''): void {
    this.notices.error(error, about);
  }

  dismissError(): void {
    this.notices.clear();
  }

  togglePlay(): void {
    if (this.film.playing) this.film.pause();
    else this.play();
  }

  play(): void {
    const { record } = this;
    if (!record || this.film.playing) return;
    this.stay();
    if (this.step >= record.stepCount && record.state !== 'running') this.showStep(1);
    this.film.play();
  }

  playingChanged(playing: boolean): void {
    this.transport.setPlaying(playing);
    this.root.dataset['playing'] = String(playing);
    if (!playing && this.step > 0) this.showStep(this.step);
  }

  showFrame(step: number, recent: number): void {
    if (step === this.step) this.shape?.glowSince(recent);
    else this.showStep(step, recent);
  }

  /** The playhead follows the computation no longer. */
  private stay(): void {
    this.arrival = 'wait';
    this.walk.leave();
  }

  move(steps: number): void {
    this.goTo(this.step + steps);
  }

  /** Moves the playhead by hand: the film stops. */
  goTo(step: number): void {
    const { record } = this;
    if (!record || record.stepCount === 0) return;
    this.stay();
    this.film.pause();
    this.showStep(Math.min(record.stepCount, Math.max(1, step)));
  }

  /** The playhead follows the computation; what ended at a plateau goes on. */
  seek(): void {
    this.film.pause();
    this.arrival = 'seek';
    if (this.record?.endedAtPlateau) this.goOn('runToNextPlateau');
  }

  set speed(factor: number) {
    this.film.speed = factor;
  }

  /** Where nothing was opened yet, the way in is shown. */
  showEmpty(): void {
    byId('empty', HTMLElement).hidden = this.choice !== undefined;
    byId('film', HTMLElement).inert = byId('tools', HTMLElement).inert = this.choice === undefined;
    if (!this.choice) this.root.dataset['runState'] = 'empty';
  }

  /** `place`: the setting that was changed; what is wrong with it is said there. */
  private openAgain(place: Element): void {
    if (!this.choice) return;
    try {
      const { choice, options } = this.settings.asked(this.choice);
      void this.open(choice, options, this.arrivalAt(choice));
      this.notices.nextTo(place);
    } catch (error) {
      this.notices.nextTo(place);
      this.showError(error);
    }
  }

  private goOn(how: 'runPastNoise' | 'runToNextPlateau'): void {
    this.feed?.[how]().then(
      () => this.grown(),
      (error: unknown) => this.showError(error),
    );
  }

  /** The same shape with other settings is looked at where it was, another one at its answer. */
  private arrivalAt(choice: SourceChoice): Arrival {
    return this.choice && this.step > 0 && sameShape(this.choice, choice) ? 'return' : 'answer';
  }

  /** The run that is shown. */
  shownRun(): ShownRun | undefined {
    const { choice, options, feed, cards } = this;
    return choice && feed
      ? { choice, options, opened: feed.run.opened, record: feed.record, feed, cards }
      : undefined;
  }

  private show(feed: RunFeed, { choice, options }: Opening, arrival: Arrival, begin: number): void {
    this.film.pause();
    const before = this.shownRun();
    const epsilon = this.step > 0 ? (this.record?.epsilon(this.step) ?? 0) : 0;
    this.returnTo = epsilon > 0 ? (record) => stepAt(record, -Math.log(epsilon)) : undefined;
    this.feed?.dispose();
    this.feed = feed;
    this.choice = choice;
    this.options = options;
    this.cards = [];
    this.step = 0;
    this.arrival = arrival;
    this.shape?.setRecord(feed.record);
    this.tools.show(feed.record.frame);
    this.diagram.setRecord(feed.record, this.earlier.show(before, this.shownRun()));
    this.cardList.show([], false);
    this.announcer.restart();
    this.walk.leave();
    this.pumps.show(feed.record);
    this.transport.setSteps(1);
    this.status.show(feed.record, undefined, false);
    showLegend(feed.record.bettiCount);
    this.markSample();
    this.showEmpty();
    const { count } = feed.record.frame;
    byId('source', HTMLElement).textContent = `${sourceName(choice)} · ${grouped(count)} points`;
    this.root.dataset['source'] = choice.kind === 'sample' ? choice.shape : choice.file.name;
    this.root.dataset['step'] = '0';
    this.showRunState(feed.record);
    this.notes.begin(feed.record, performance.now() - begin);
    feed.start();
  }

  /** The step and the view of a session or a link; the run has just begun. */
  private restore({ step, view: { axis, pose } }: Restored): void {
    if (step > 0) this.returnTo = (record) => Math.min(step, record.stepCount);
    this.diagram.setAxis(axis);
    byId('axis', HTMLSelectElement).value = axis;
    if (this.shape && pose) this.shape.pose = pose;
  }

  /** The list of samples names what is shown, not what was tried. */
  private markSample(): void {
    this.sample.value = this.choice?.kind === 'sample' ? this.choice.shape : '';
  }

  grown(): void {
    const { record } = this;
    if (!record) return;
    const first = this.step === 0 && record.stepCount > 0;
    if (record.ended || first || performance.now() >= this.picturesDue) {
      this.picturesDue = performance.now() + PICTURES_EVERY_MS;
      this.shape?.sync();
      this.transport.setSteps(record.stepCount);
      this.diagram.requestPaint();
      if (record.stepCount > 0) {
        if (this.arrival === 'answer' || this.arrival === 'seek') this.showStep(record.stepCount);
        else if (this.arrival === 'return') this.showStep(this.stepReached(record));
        else if (first) this.showStep(1);
        if (this.arrival === 'play') this.play();
      }
    }
    this.showRunState(record);
  }

  /** The step of the scale that was looked at before, or the last one as long as that is not reached. */
  private stepReached(record: RunRecord): number {
    return this.returnTo?.(record) ?? record.stepCount;
  }

  cardsFound(cards: readonly PlateauCard[]): void {
    const { record } = this;
    if (!record) return;
    this.cards = cards;
    this.diagram.setCards(cards);
    this.cardList.show(cards, record.ended);
    this.pumps.show(record);
    if (this.step > 0) this.cardList.mark(record.summary(this.step));
    if (this.arrival === 'seek') this.walk.look();
  }

  ended(stopped: Failure | undefined): void {
    const { following } = this;
    const answer = this.arrival === 'answer' ? this.cards[0]?.middleStep : undefined;
    if (this.arrival === 'seek') {
      this.walk.ended();
    } else {
      this.arrival = 'wait';
      if (following && this.step > 0) this.showStep(answer ?? this.step);
    }
    if (stopped) this.showError(stopped.message);
  }

  /** The run is lost; what the record holds can still be looked at. */
  failed(error: unknown): void {
    this.stay();
    if (this.record) {
      this.record.state = 'stopped';
      this.grown();
    }
    this.showError(error);
  }

  private showRunState(record: RunRecord): void {
    this.root.dataset['runState'] = record.state;
    this.root.dataset['steps'] = String(record.stepCount);
    this.root.dataset['hash'] = record.hash;
    this.notes.show();
  }

  private get following(): boolean {
    return this.arrival !== 'play' && this.arrival !== 'wait';
  }

  /** `recent`: the step of a moment ago, while the film plays. */
  private showStep(step: number, recent = step): void {
    const { record } = this;
    if (!record) return;
    this.step = step;
    const summary = record.summary(step);
    this.shape?.showStep(step, recent);
    this.diagram.showStep(step);
    this.transport.showStep(summary);
    const card = this.cardList.mark(summary);
    if (!this.following) this.announcer.at(card);
    this.status.show(record, summary, this.film.playing || this.following);
    this.root.dataset['step'] = String(step);
    this.root.dataset['family'] = summary.family;
    this.root.dataset['betti'] = summary.betti.join(',');
  }
}
