import type { RemoteRun } from '../client/plateau-client.ts';
import type { PlateauCard } from '../model/plateau-cards.ts';
import type { RunRecord, StepSummary } from '../model/record.ts';
import type { Failure } from '../worker/protocol.ts';
import { Announcer } from '../app/announcer.ts';
import { showLegend } from '../app/dom.ts';
import { Film } from '../app/film.ts';
import { RunFeed } from '../app/run-feed.ts';
import { RunScreen } from '../app/run-screen.ts';
import { NO_WEBGL, shapeViewIn } from '../app/shape-or-none.ts';
import { StatusLine } from '../app/status-line.ts';
import { Transport } from '../app/transport.ts';
import { playing, still, type Destination } from './destination.ts';
import type { Parts } from './parts.ts';
import type { Panels } from './settings.ts';
import { listenToShapeKeys } from './shape-keys.ts';

/** What happens inside, for the element to tell. */
export interface ViewerListener {
  /** The playhead shows another step. */
  stepped(at: StepSummary): void;
  /** It has come to another plateau. */
  arrived(card: PlateauCard, rank: number): void;
  /** The run stopped early, or its worker died. */
  failed(error: unknown): void;
  stopped(failure: Failure): void;
  noGraphics(sentence: string): void;
  noSuchPlateau(rank: number, plateaus: number): void;
}

/** One run that is shown and one playhead: what is inside an element. */
export class Viewer {
  private readonly film = new Film(this);
  private readonly screen: RunScreen;
  private readonly transport: Transport;
  private readonly status: StatusLine;
  private readonly announcer: Announcer;
  /** From where the shape was looked at when it went out of view. */
  private pose: readonly number[] | undefined;
  private feed: RunFeed | undefined;
  private cards: readonly PlateauCard[] = [];
  /** The cards are those of the whole run. */
  private cardsComplete = false;
  private destination: Destination | undefined;
  private panels: Panels = 'both';
  private inView = false;
  private playsWhenSeen = false;
  private noGraphics = false;
  private arrivedAt = '';

  constructor(
    private readonly parts: Parts,
    private readonly listener: ViewerListener,
  ) {
    this.screen = new RunScreen(
      { ...parts, state: parts.view },
      {
        scrub: (step) => this.goTo(step),
        choose: (card) => {
          this.goTo(card.middleStep);
          this.screen.shape?.frameAll();
        },
      },
    );
    this.transport = new Transport(this, parts.transport);
    this.status = new StatusLine(parts.readout, parts.status);
    this.announcer = new Announcer(parts.spoken);
    listenToShapeKeys(parts.shape, {
      turn: (across, upright) => this.screen.shape?.turn(across, upright),
      zoom: (factor) => this.screen.shape?.zoom(factor),
      togglePlay: () => this.togglePlay(),
    });
    // The wheel scrolls what the element is part of, until the shape is what the visitor works with.
    parts.shape.addEventListener('focus', () => this.takeWheel(true));
    parts.shape.addEventListener('blur', () => this.takeWheel(false));
  }

  get record(): RunRecord | undefined {
    return this.feed?.record;
  }

  get currentStep(): number {
    return this.screen.currentStep;
  }

  get currentCards(): readonly PlateauCard[] {
    return this.cards;
  }

  /** Nothing more will come. */
  get complete(): boolean {
    return this.cardsComplete;
  }

  get playing(): boolean {
    return this.film.playing || this.playsWhenSeen || this.destination?.kind === 'film';
  }

  setPanels(panels: Panels): void {
    this.panels = panels;
    this.parts.view.dataset['panels'] = panels;
    this.holdGraphics();
    this.screen.diagram.requestPaint();
  }

  applyTheme(): void {
    this.screen.applyTheme();
  }

  /** Out of view nothing is computed, nothing moves, and the graphics card is given back. */
  setInView(inView: boolean): void {
    if (this.inView === inView) return;
    this.inView = inView;
    if (inView) {
      this.feed?.resume();
    } else {
      this.playsWhenSeen = this.film.playing;
      this.film.pause();
      this.feed?.pause();
    }
    this.holdGraphics();
    if (inView && this.playsWhenSeen) this.play();
  }

  /** Another opening is under way: what is shown stays, and takes no time from it. */
  makeWay(): void {
    this.feed?.pause();
  }

  /** It led to nothing. */
  goOn(): void {
    if (this.inView) this.feed?.resume();
  }

  show(run: RemoteRun, destination: Destination): void {
    this.film.pause();
    this.feed?.dispose();
    const feed = new RunFeed(run, {
      grown: () => this.grown(),
      cardsFound: (cards) => this.showCards(cards),
      ended: (stopped) => this.ended(stopped),
      failed: (error) => this.feedFailed(error),
    });
    this.feed = feed;
    this.cards = [];
    this.cardsComplete = false;
    this.arrivedAt = '';
    this.playsWhenSeen = false;
    this.pose = undefined;
    this.still = false;
    this.destination = destination;
    this.screen.setRecord(feed.record);
    this.announcer.restart();
    this.transport.setSteps(1);
    this.status.show(feed.record, undefined, false);
    showLegend(feed.record.bettiCount, this.parts.film);
    this.parts.empty.hidden = true;
    this.parts.bar.inert = this.parts.film.inert = false;
    if (!this.inView) feed.pause();
    feed.start();
  }

  /** Goes where the attributes say, with the run that is shown. */
  send(destination: Destination): void {
    this.destination = destination;
    this.film.pause();
    if (this.record) this.follow(this.record);
  }

  togglePlay(): void {
    if (this.film.playing) this.pause();
    else this.play();
  }

  /** Before the first step it is a wish, and so are `pause` and `goTo`. */
  play(): void {
    const { record } = this;
    if (!record) return;
    if (record.stepCount === 0) {
      this.destination = playing(this.destination);
      return;
    }
    this.destination = undefined;
    if (!this.inView) {
      this.playsWhenSeen = true;
      return;
    }
    this.playsWhenSeen = false;
    if (this.film.playing) return;
    if (this.currentStep >= record.stepCount && record.ended) this.showStep(1);
    this.film.play();
  }

  pause(): void {
    this.playsWhenSeen = false;
    const { destination } = this;
    if (destination?.kind === 'film')
      this.destination = this.currentStep > 0 ? undefined : still(destination);
    this.film.pause();
  }

  move(steps: number): void {
    this.goTo(this.currentStep + steps);
  }

  /** To a step that is computed, or the last one that is. */
  goTo(step: number): void {
    const { record } = this;
    if (!record) return;
    this.pause();
    const wanted = Math.max(1, Math.round(step));
    this.destination = record.stepCount === 0 ? { kind: 'step', step: wanted } : undefined;
    if (record.stepCount > 0) this.showStep(Math.min(record.stepCount, wanted));
  }

  showFrame(step: number, recent: number): void {
    if (step === this.currentStep) this.screen.shape?.glowSince(recent);
    else this.showStep(step, recent);
  }

  playingChanged(playing: boolean): void {
    this.transport.setPlaying(playing);
    this.parts.view.dataset['playing'] = String(playing);
    if (!playing && this.currentStep > 0) this.showStep(this.currentStep);
  }

  /** Frees everything; the viewer is of no use any more. */
  dispose(): void {
    this.film.pause();
    this.feed?.dispose();
    this.feed = undefined;
    this.screen.shape?.dispose();
    this.screen.shape = undefined;
    this.screen.diagram.dispose();
  }

  /** What is drawn stays to be seen where there is no graphics card: out of view, and on paper. */
  keepStill(): void {
    const picture = this.screen.shape?.picture();
    if (!picture) return;
    const { still } = this.parts;
    [still.width, still.height] = [picture.width, picture.height];
    still.getContext('2d')?.drawImage(picture, 0, 0);
    this.still = true;
  }

  private set still(there: boolean) {
    this.parts.stage.toggleAttribute('data-still', there);
  }

  private takeWheel(takes: boolean): void {
    if (this.screen.shape) this.screen.shape.wheelZooms = takes;
  }

  /** A context of the graphics card is held only while the shape is seen: browsers allow about sixteen on a page. */
  private holdGraphics(): void {
    const wanted = this.inView && this.panels !== 'diagram' && !this.noGraphics;
    const { screen, parts } = this;
    if (wanted === (screen.shape !== undefined)) return;
    if (!wanted) {
      this.pose = screen.shape?.pose;
      this.keepStill();
      screen.shape?.dispose();
      screen.shape = undefined;
      delete parts.stage.dataset['live'];
      return;
    }
    const shape = shapeViewIn(parts.shape, parts.noShape);
    if (!shape) {
      this.noGraphics = true;
      this.listener.noGraphics(NO_WEBGL);
      return;
    }
    screen.shape = shape;
    parts.stage.dataset['live'] = '';
    shape.wheelZooms = parts.shape.matches(':focus');
    if (!this.record) return;
    shape.setRecord(this.record);
    if (this.pose) shape.pose = this.pose;
    shape.sync();
    if (this.currentStep > 0) shape.showStep(this.currentStep);
  }

  private grown(): void {
    const { record } = this;
    if (!record || !this.screen.grown()) return;
    this.transport.setSteps(record.stepCount);
    this.follow(record);
  }

  /** As far towards the destination as the record reaches. */
  private follow(record: RunRecord): void {
    const { destination } = this;
    if (!destination || record.stepCount === 0) return;
    const { stepCount } = record;
    switch (destination.kind) {
      case 'film':
        if (stepCount < destination.from && !record.ended) return this.showStep(stepCount);
        this.showStep(Math.min(stepCount, destination.from));
        return this.play();
      case 'step':
        if (stepCount >= destination.step || record.ended) this.destination = undefined;
        return this.showStep(Math.min(stepCount, destination.step));
      case 'plateau':
        return this.followPlateau(destination, record);
    }
  }

  /** Which plateau is the longest is known at the end. */
  private followPlateau({ rank, asked }: { rank: number; asked: boolean }, record: RunRecord): void {
    const card = this.cards[rank - 1];
    if (!this.cardsComplete) return this.showStep(record.stepCount);
    this.destination = undefined;
    this.showStep(card?.middleStep ?? record.stepCount);
    if (!card && asked) this.listener.noSuchPlateau(rank, this.cards.length);
  }

  private showCards(cards: readonly PlateauCard[]): void {
    const { record } = this;
    if (!record) return;
    this.cards = cards;
    this.cardsComplete = record.ended;
    this.arriveAt(this.screen.showCards(cards));
  }

  private ended(stopped: Failure | undefined): void {
    if (this.record) this.follow(this.record);
    if (stopped) this.listener.stopped(stopped);
  }

  /** The run is lost; what the record holds can still be looked at. */
  private feedFailed(error: unknown): void {
    if (this.record) {
      this.record.state = 'stopped';
      this.grown();
    }
    this.listener.failed(error);
  }

  private showStep(step: number, recent = step): void {
    const { record } = this;
    if (!record) return;
    const other = step !== this.currentStep;
    const { summary, card } = this.screen.showStep(record, step, recent);
    this.transport.showStep(summary);
    this.arriveAt(card);
    this.status.show(record, summary, this.film.playing || this.destination !== undefined);
    // A picture of another step would lie.
    if (other && !this.screen.shape) this.still = false;
    if (other) this.listener.stepped(summary);
  }

  /** While the playhead follows the computation plateaus come and go: none is told of. */
  private arriveAt(card: PlateauCard | undefined): void {
    if (this.destination || this.currentStep === 0) return;
    this.announcer.at(card);
    const name = card ? `${card.firstStep} ${card.family} ${card.betti.join()}` : '';
    if (name === this.arrivedAt) return;
    this.arrivedAt = name;
    if (card) this.listener.arrived(card, this.cards.indexOf(card) + 1);
  }
}
