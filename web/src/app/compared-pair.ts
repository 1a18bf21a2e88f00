import { FIRST_AXES, rowsOf } from '../model/dimensions.ts';
import { MergedScales } from '../model/merged-scales.ts';
import { readable } from '../model/numbers.ts';
import { jointRange, scaleOf, stepAt, stepBefore, type AxisKind } from '../model/scale-axis.ts';
import { LinkedCameras } from '../view/linked-cameras.ts';
import { ComparedSide, standingAt, type Place } from './compared-side.ts';
import { createComparedFilm, createSecondStage, createSideParts } from './comparison-parts.ts';
import { projectionInWords } from './dimension-tools.ts';
import { byId, setNotice, showLegend } from './dom.ts';
import { samePoints, type ShownRun } from './earlier-run.ts';
import { Film, type FilmScreen } from './film.ts';
import { make } from './make.ts';
import type { Page } from './page.ts';
import type { FeedListener } from './run-feed.ts';
import { RunNotes } from './run-notes.ts';
import { ScaleBar } from './scale-bar.ts';
import { shapeViewIn } from './shape-or-none.ts';
import { heldTogether, StatusLine } from './status-line.ts';
import { Transport, type TransportActions } from './transport.ts';

/** What the buttons of a comparison ask for. */
export interface PairActions {
  close(): void;
  setAxis(kind: AxisKind): void;
}

/** How a comparison is looked at. */
export interface PairView {
  /** Where the playhead stands, in ln(1/ε). */
  readonly scale: number;
  /** From where the second shape is looked at; none: as the first, if their points are the same. */
  readonly pose?: readonly number[];
}

/**
 * Two runs under one playhead, which stands at a scale and not at a step. The first is that of the page: its stage
 * stays where it is, and what else is shown of it makes room.
 */
export class ComparedPair implements FilmScreen, TransportActions {
  readonly film = new Film(this);
  private readonly merged: MergedScales;
  private readonly first: ComparedSide;
  private readonly second: ComparedSide;
  private readonly parts: ReturnType<typeof createComparedFilm>;
  private readonly transport: Transport;
  private readonly status: StatusLine;
  private readonly notes: RunNotes;
  private readonly cameras: LinkedCameras | undefined;
  private readonly own: readonly HTMLElement[];
  private readonly ofPage: readonly HTMLElement[];
  private readonly deaf: readonly (() => void)[];
  private place: Place;

  constructor(
    private readonly page: Page,
    first: ShownRun,
    /** `readMs`: so long its points took to read. */
    second: ShownRun & { readonly readMs: number },
    view: PairView,
    actions: PairActions,
  ) {
    this.place = standingAt(view.scale);
    this.merged = new MergedScales(first.record, second.record);
    const [partsA, partsB] = [createSideParts('A'), createSideParts('B')];
    const parts = (this.parts = createComparedFilm([partsA.diagram, partsB.diagram]));
    const stage = createSecondStage();
    const answers = make('aside', { class: 'side compared-side', 'aria-label': 'Plateaus of both runs' });
    answers.append(partsA.answers, partsB.answers);

    const root = byId('plateau', HTMLElement);
    const [film, side] = ['.film', '.side'].map((name) => root.querySelector<HTMLElement>(name));
    const firstStage = root.querySelector('.stage');
    if (!film || !side || !firstStage) throw new Error('The page has no place for a second run.');
    firstStage.before(partsA.head);
    firstStage.after(partsB.head, stage.stage);
    film.after(parts.film);
    side.after(answers);
    this.own = [partsA.head, partsB.head, stage.stage, parts.film, answers];
    this.ofPage = [film, side, byId('undo', HTMLElement), byId('redo', HTMLElement)];
    for (const element of this.ofPage) element.hidden = true;
    root.dataset['comparing'] = 'true';

    const goTo = (scale: number): void => this.scrubTo(scale);
    this.first = new ComparedSide('A', partsA, first, parts.timeline, goTo);
    this.second = new ComparedSide('B', partsB, second, parts.timeline, goTo);
    this.first.screen.shape = page.shape;
    const bar = new ScaleBar(stage.bar, stage.length, stage.text);
    const shape = shapeViewIn(stage.shape, stage.noShape, bar.show);
    const alike = samePoints(first.choice, second.choice);
    shape?.setRecord(second.record);
    if (shape && view.pose) shape.pose = view.pose;
    this.second.screen.shape = shape;
    page.tools.attachBeside(shape, alike);
    this.cameras = alike && page.shape && shape ? new LinkedCameras(page.shape, shape) : undefined;
    const { frame } = second.record;
    setNotice(stage.projection, alike ? '' : projectionInWords(frame, rowsOf(frame.axes, FIRST_AXES, 0)));
    parts.turns.hidden = !this.cameras;
    parts.together.checked = view.pose === undefined;
    parts.together.addEventListener('change', () => this.linkCameras());
    this.linkCameras();

    parts.bar.inert = false;
    this.transport = new Transport(this, { ...parts.buttons, slider: parts.slider });
    this.status = new StatusLine(parts.readout, parts.status);
    parts.close.addEventListener('click', () => actions.close());
    parts.axis.addEventListener('change', () =>
      actions.setAxis(parts.axis.value === 'linear' ? 'linear' : 'log'),
    );
    this.notes = new RunNotes(() => {
      second.feed.runPastNoise().then(
        () => this.grown(this.second),
        (error: unknown) => page.showError(error),
      );
    }, stage.notes);
    this.notes.begin(second.record, second.readMs);
    showLegend(Math.max(first.record.bettiCount, second.record.bettiCount), parts.film);
    this.deaf = [
      first.feed.alsoTell(this.listener(this.first)),
      second.feed.alsoTell(this.listener(this.second)),
    ];
    this.grown(this.first);
  }

  get record(): MergedScales {
    return this.merged;
  }

  /** In the order of both runs. */
  get currentStep(): number {
    return stepAt(this.merged, this.place.scale);
  }

  /** The runs as they are shown. */
  get runs(): readonly [ShownRun, ShownRun] {
    return [this.first.run, this.second.run];
  }

  /** The step that the run of the page shows. */
  get firstStep(): number {
    return this.first.screen.currentStep;
  }

  get view(): PairView {
    const pose = this.cameras?.linked ? undefined : this.second.screen.shape?.pose;
    return { scale: this.place.scale, ...(pose ? { pose } : {}) };
  }

  /** The second shape, if it has the focus. */
  get shapeInFocus() {
    const { shape } = this.second.screen;
    return this.own.some((element) => element.querySelector('.shape:focus')) ? shape : undefined;
  }

  togglePlay(): void {
    if (this.film.playing) return this.film.pause();
    if (this.merged.stepCount === 0) return;
    if (this.merged.ended && this.currentStep >= this.merged.stepCount) this.show(standingAt(this.lowest));
    this.film.play();
  }

  /** To the next scales at which one of the runs has a step, or back. */
  move(steps: number): void {
    const { merged } = this;
    let { scale } = this.place;
    for (let left = Math.abs(steps); left > 0; --left) {
      const step = steps > 0 ? stepAt(merged, scale) + 1 : stepBefore(merged, scale);
      if (step < 1 || step > merged.stepCount) break;
      scale = scaleOf(merged, step);
    }
    this.scrubTo(scale);
  }

  /** A step in the order of both runs. */
  goTo(step: number): void {
    const { stepCount } = this.merged;
    if (stepCount > 0) this.scrubTo(scaleOf(this.merged, Math.min(stepCount, Math.max(1, step))));
  }

  nextPlateau(): void {
    const places = [...this.first.cardPlaces, ...this.second.cardPlaces].sort((a, b) => a - b);
    const next = places.find((place) => place > this.place.scale) ?? places[0];
    if (next !== undefined) this.scrubTo(next);
  }

  fit(): void {
    this.first.screen.shape?.fit();
    this.second.screen.shape?.fit();
  }

  setAxis(kind: AxisKind): void {
    this.parts.axis.value = kind;
    for (const { screen } of this.sides) screen.diagram.setAxis(kind);
  }

  applyTheme(): void {
    for (const { screen } of this.sides) screen.applyTheme();
  }

  showFrame(step: number, recent: number): void {
    const { merged } = this;
    const scale = step === this.currentStep ? this.place.scale : scaleOf(merged, step);
    const glow = recent === step ? scale : undefined;
    const [from, to] = [Math.floor(recent), Math.ceil(recent)].map(
      (at) => glow ?? scaleOf(merged, Math.max(1, at)),
    );
    const place: Place = { scale, recent: [from ?? scale, to ?? scale, recent % 1] };
    if (String(place.recent) !== String(this.place.recent) || scale !== this.place.scale) this.show(place);
  }

  playingChanged(playing: boolean): void {
    this.transport.setPlaying(playing);
    this.parts.film.dataset['playing'] = String(playing);
    if (!playing) this.show(standingAt(this.place.scale));
  }

  /** The run of the page is alone again, and the second one is freed. */
  dispose(): void {
    this.film.pause();
    for (const stop of this.deaf) stop();
    this.cameras?.dispose();
    this.page.tools.attachBeside(undefined, false);
    for (const { screen } of this.sides) screen.diagram.dispose();
    this.second.screen.shape?.dispose();
    this.second.run.feed.dispose();
    for (const element of this.own) element.remove();
    for (const element of this.ofPage) element.hidden = false;
    delete byId('plateau', HTMLElement).dataset['comparing'];
  }

  private get sides(): readonly ComparedSide[] {
    return [this.first, this.second];
  }

  /** Where the film begins. */
  private get lowest(): number {
    return this.merged.stepCount > 0 ? scaleOf(this.merged, 1) : this.place.scale;
  }

  /** Moves the playhead by hand, as far as one of the runs is computed: the film stops. */
  private scrubTo(scale: number): void {
    this.film.pause();
    const ends = this.sides
      .map(({ record }) => record)
      .filter(({ stepCount }) => stepCount > 0)
      .map((record) => [scaleOf(record, 1), scaleOf(record, record.stepCount)] as const);
    if (ends.length === 0) return;
    const low = Math.min(...ends.map(([from]) => from));
    const high = Math.max(...ends.map(([, to]) => to));
    this.show(standingAt(Math.min(high, Math.max(low, scale))));
  }

  private show(place: Place): void {
    this.place = place;
    const { scale } = place;
    for (const side of this.sides) side.showAt(place);
    const epsilon = Math.exp(-scale);
    const words = `ε ${readable(epsilon)}`;
    this.transport.showPlace(this.currentStep, words);
    this.parts.readout.textContent = heldTogether(`${words} · 1/\u2060ε ${readable(1 / epsilon)}`);
    this.parts.film.dataset['scale'] = String(scale);
    this.status.say([words, ...this.sides.map((side) => side.words)].join(' · '), this.film.playing);
  }

  private listener(side: ComparedSide): FeedListener {
    return {
      grown: () => this.grown(side),
      cardsFound: (cards) => side.showCards(cards),
      ended: () => undefined,
      // What the record holds can still be looked at.
      failed: () => {
        side.record.state = 'stopped';
        this.grown(side);
      },
    };
  }

  /** Both diagrams have one axis, whichever run has grown; and a run may have come to the playhead only now. */
  private grown(side: ComparedSide): void {
    if (side === this.second) this.notes.show();
    // The page follows its own run no longer.
    if (side === this.first && this.firstStep === 0) this.page.goTo(this.page.currentStep);
    if (!side.grown()) return;
    const range = jointRange(this.sides.map(({ record }) => record));
    for (const { screen } of this.sides) screen.diagram.setRange(range);
    this.transport.setSteps(this.merged.stepCount);
    this.show(this.film.playing ? this.place : standingAt(this.place.scale));
  }

  private linkCameras(): void {
    if (this.cameras) this.cameras.linked = this.parts.together.checked;
  }
}
