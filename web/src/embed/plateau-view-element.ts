import { codeOf, PlateauError, type ErrorCode } from '../client/plateau-error.ts';
import { browserFault } from '../package/browser-floor.ts';
import type { ClientShare } from '../package/shared-client.ts';
import { openPoints } from '../client/open-points.ts';
import { destinationOf, playing, still, type Destination } from './destination.ts';
import {
  cloudOf,
  givenBy,
  nameOf,
  optionsFor,
  toldOf,
  type Given,
  type LoadOptions,
  type Opening,
} from './element-cloud.ts';
import { plateauDetail, readyDetail, type PlateauDetail } from './events.ts';
import { createParts, type Parts } from './parts.ts';
import { ReflectingElement } from './reflecting-element.ts';
import { ATTRIBUTES, OF_OPENING, settingsOf, type Settings } from './settings.ts';
import { sharedWorker } from './shared-worker.ts';
import { elementStyle } from './style.ts';
import { Trouble } from './trouble.ts';
import { Viewer } from './viewer.ts';

const REPLACED = 'Another opening came in between.';

/** Whoever called `load` and waits. */
interface Waiting {
  readonly resolve: () => void;
  readonly reject: (reason: unknown) => void;
}

/**
 * `<plateau-view>`: a point cloud, and the shapes it may have been sampled from, scale by scale.
 *
 * It computes only while it is in view, and all elements of a page share one worker. Its attributes can be set as
 * properties too; what they ask for comes into force a moment later, all changes at once.
 *
 * Its events are those of {@link PlateauViewEventMap}: `ready`, `step`, `plateau` and `error`.
 */
export class PlateauViewElement extends ReflectingElement {
  /** @internal */
  static readonly observedAttributes = [...ATTRIBUTES, 'aria-label'];

  private parts: Parts | undefined;
  private viewer: Viewer | undefined;
  private trouble: Trouble | undefined;
  private share: ClientShare | undefined;
  private opening: AbortController | undefined;
  /** What is opened or being opened, to see whether the attributes ask for something else. */
  private asked = '';
  /** It could not be opened, or its worker died: the same is tried again when it is asked for again. */
  private refused = false;
  /** Where the attributes sent the playhead; '': they are to send it anew. */
  private sent = '';
  /** Where calls sent it before what is to come could be watched. */
  private wished: Destination | undefined;
  private given: Given | undefined;
  private givenOver = '';
  private waiting: Waiting[] = [];
  private told: unknown;
  private inView = false;
  private scheduled = false;
  private unsupported: PlateauError | undefined;
  private readonly watch = new IntersectionObserver((entries) =>
    this.seen(entries.at(-1)?.isIntersecting ?? false),
  );
  private readonly system = matchMedia('(prefers-color-scheme: dark)');

  /** The step that is shown, 0 before the first. Set the attribute `step` or call `goTo` to change it. */
  get currentStep(): number {
    return this.viewer?.currentStep ?? 0;
  }

  /** How many steps are computed. */
  get stepCount(): number {
    return this.viewer?.record?.stepCount ?? 0;
  }

  /** Whether the film runs, or will as soon as there is one and the element is in view. */
  get playing(): boolean {
    const settings = settingsOf(this);
    const { viewer, opening, refused } = this;
    const comes = (opening || !viewer?.record) && !refused && (this.given ?? settings.source) !== undefined;
    return (viewer?.playing ?? false) || (comes && this.destinationIn(settings).kind === 'film');
  }

  /** The plateaus so far, the longest first; those of few landmarks last. */
  get plateaus(): readonly PlateauDetail[] {
    return (this.viewer?.currentCards ?? []).map((card, i) => plateauDetail(card, i + 1));
  }

  /** @internal Nothing more will come: all plateaus are known. */
  get finished(): boolean {
    return this.viewer?.complete ?? false;
  }

  /**
   * Lets the film run, from the beginning if it is at its end. This, `pause` and `goTo` can be called at any time: what
   * is called before the points can be watched counts as soon as they can.
   */
  play(): void {
    this.wish(playing);
    this.viewer?.play();
  }

  /** Stops the film. */
  pause(): void {
    this.wish(still);
    this.viewer?.pause();
  }

  /** Shows a step, or the last one that is computed, which is also that of `Infinity`; stops the film. */
  goTo(step: number): void {
    const wanted = Math.max(1, Math.round(step));
    if (Number.isNaN(wanted)) throw new PlateauError('invalid-option', 'goTo takes the number of a step.');
    this.wish(() => ({ kind: 'step', step: wanted }));
    this.viewer?.goTo(wanted);
  }

  /**
   * Opens a file, or points as numbers, instead of what the attributes name; what is shown stays until the new points
   * can be watched, and for good if that fails. Resolves with the event `ready`, rejects with the event `error`, or
   * with an AbortError where another opening or the removal of the element came in between. Before the element is part
   * of a page it waits for that.
   */
  async load(points: File | Float64Array, options: LoadOptions = {}): Promise<void> {
    if (this.unsupported) throw this.unsupported;
    let given: Given;
    try {
      given = givenBy(points, options);
    } catch (error) {
      this.fail(error);
      throw error;
    }
    this.giveUp(REPLACED);
    this.given = given;
    this.givenOver = JSON.stringify(settingsOf(this).source ?? null);
    this.asked = '';
    await new Promise<void>((resolve, reject) => {
      this.waiting.push({ resolve, reject });
      this.schedule();
    });
  }

  /** @internal */
  connectedCallback(): void {
    this.upgradeProperties();
    if (!this.viewer && !this.unsupported) this.build();
    if (!this.viewer) return;
    this.watch.observe(this);
    addEventListener('beforeprint', this.keepStill);
    this.system.addEventListener('change', this.applyTheme);
    this.schedule();
  }

  /** @internal */
  disconnectedCallback(): void {
    this.watch.unobserve(this);
    removeEventListener('beforeprint', this.keepStill);
    this.system.removeEventListener('change', this.applyTheme);
    // An element that is only moved is connected again by then.
    queueMicrotask(() => {
      if (!this.isConnected) this.tearDown();
    });
  }

  /** @internal */
  attributeChangedCallback(name: string): void {
    if (name === 'theme') this.applyTheme();
    if (name === 'step' || name === 'plateau' || name === 'autoplay') this.sendAnew(name);
    // What failed is tried again when it is asked for again.
    else if (this.refused && OF_OPENING.includes(name)) this.asked = '';
    if (this.viewer) this.schedule();
  }

  /** Also where the browser is too old for anything else there is a sentence. */
  private build(): void {
    const root = this.shadowRoot ?? this.attachShadow({ mode: 'open' });
    root.replaceChildren();
    const unsupported = (this.unsupported = browserFault('element'));
    if (unsupported) {
      root.append(unsupported.message);
      this.tell(unsupported);
      this.settle(({ reject }) => reject(unsupported));
      return;
    }
    root.adoptedStyleSheets = [elementStyle()];
    const parts = (this.parts = createParts());
    this.trouble = new Trouble(parts, () => this.tryAgain());
    root.append(parts.box);
    this.viewer = new Viewer(parts, {
      stepped: ({ step, epsilon, family, betti, torsion }) =>
        this.emit('step', { step, epsilon, family, betti, ...(torsion ? { torsion } : {}) }),
      arrived: (card, rank) => this.emit('plateau', plateauDetail(card, rank)),
      failed: (error) => this.lose(error),
      stopped: (failure) => this.failWith(codeOf(failure), failure.message),
      noGraphics: (sentence) => this.tell(new PlateauError('no-graphics', sentence)),
      noSuchPlateau: (rank, plateaus) =>
        this.failWith('no-such-plateau', `There is no plateau ${rank}: the run has ${plateaus}.`),
    });
  }

  private tearDown(): void {
    this.giveUp('The element was removed.');
    this.viewer?.dispose();
    this.viewer = this.parts = this.trouble = undefined;
    this.share?.release();
    this.share = undefined;
    this.inView = this.refused = false;
    this.asked = this.sent = '';
    this.wished = undefined;
  }

  private seen(inView: boolean): void {
    if (!this.isConnected) return;
    this.inView = inView;
    this.viewer?.setInView(inView);
    this.schedule();
  }

  /** All changes of a moment count as one. */
  private schedule(): void {
    if (this.scheduled) return;
    this.scheduled = true;
    queueMicrotask(() => {
      this.scheduled = false;
      if (this.isConnected && this.viewer) this.follow(settingsOf(this), this.viewer);
    });
  }

  /** Does what the attributes ask for and is not done yet. */
  private follow(settings: Settings, viewer: Viewer): void {
    viewer.setPanels(settings.panels);
    this.complain(settings.complaints);
    // Points that were given hold until the attributes name others.
    if (this.given && JSON.stringify(settings.source ?? null) !== this.givenOver) {
      this.given = undefined;
      this.giveUp(REPLACED);
    }
    const opening = this.given ?? settings.source;
    this.nameView(opening);
    if (!opening) this.openNothing(viewer);
    else if (this.inView || this.waiting.length > 0) this.openOrSend(opening, settings, viewer);
    this.showNote(opening);
  }

  private openOrSend(opening: Opening, settings: Settings, viewer: Viewer): void {
    const asked = JSON.stringify([this.given ? this.givenOver : settings.source, settings.options]);
    const sent = JSON.stringify(destinationOf(settings));
    if (asked !== this.asked) {
      this.asked = asked;
      void this.open(opening, settings, viewer);
    } else if (sent !== this.sent && !this.opening) {
      viewer.send(this.destinationIn(settings));
    }
    this.sent = sent;
    if (!this.isToCome) this.wished = undefined;
  }

  /** What is shown stays; what was under way to replace it is not wanted any more. */
  private openNothing(viewer: Viewer): void {
    if (!this.opening) return;
    this.giveUp(REPLACED);
    this.asked = '';
    viewer.goOn();
  }

  /** Whether another run is to be shown than the one that is, if there is one. */
  private get isToCome(): boolean {
    return !this.viewer?.record || this.opening !== undefined || this.scheduled;
  }

  private destinationIn(settings: Settings): Destination {
    return this.wished ?? destinationOf(settings);
  }

  /** What a call asks of the run that is to come. */
  private wish(change: (to: Destination) => Destination): void {
    if (this.isToCome) this.wished = change(this.destinationIn(settingsOf(this)));
  }

  /** An attribute was written that sends the playhead: it goes there also if it was sent there before. */
  private sendAnew(name: string): void {
    if (name !== 'autoplay' || this.autoplay) {
      this.wished = undefined;
      this.sent = '';
      return;
    }
    // Without autoplay the film stops where it is.
    this.pause();
    if (this.sent !== '') this.sent = JSON.stringify(destinationOf(settingsOf(this)));
  }

  private tryAgain(): void {
    this.asked = '';
    this.schedule();
  }

  private async open(opening: Opening, { options }: Settings, viewer: Viewer): Promise<void> {
    this.opening?.abort();
    const { signal } = (this.opening = new AbortController());
    this.refused = false;
    this.parts?.view.setAttribute('aria-busy', 'true');
    viewer.makeWay();
    try {
      // Whoever has all that was to come loses nothing with the worker.
      this.share ??= sharedWorker().share((error) => {
        if (!viewer.record?.ended) this.lose(error);
      });
      const read = () => cloudOf(opening, signal);
      const { run } = await openPoints(this.share.client, read, optionsFor(opening, options), signal);
      viewer.show(run, this.destinationIn(settingsOf(this)));
      this.wished = undefined;
      this.endOpening();
      this.trouble?.quiet();
      this.nameView(opening);
      // Who hears of it may open something else.
      const waiting = this.waiting.splice(0);
      this.emit('ready', readyDetail(nameOf(opening), run.opened));
      for (const { resolve } of waiting) resolve();
    } catch (error) {
      if (signal.aborted) return;
      this.endOpening();
      viewer.goOn();
      if (viewer.record) this.wished = undefined;
      const told = toldOf(error, opening);
      this.lose(told);
      this.showNote(opening);
      this.settle(({ reject }) => reject(told));
    }
  }

  private endOpening(): void {
    this.opening = undefined;
    this.parts?.view.removeAttribute('aria-busy');
  }

  /** Ends the opening that is under way; those who wait for it are told. */
  private giveUp(reason: string): void {
    this.opening?.abort();
    this.endOpening();
    this.settle(({ reject }) => reject(new DOMException(reason, 'AbortError')));
  }

  private showNote(opening: Opening | undefined): void {
    if (this.viewer?.record) return;
    this.trouble?.note(opening && nameOf(opening), this.opening !== undefined, this.refused);
  }

  private settle(end: (waiting: Waiting) => void): void {
    for (const waiting of this.waiting.splice(0)) end(waiting);
  }

  private nameView(opening: Opening | undefined): void {
    const name = this.getAttribute('aria-label') ?? (opening ? `Plateau: ${nameOf(opening)}` : 'Plateau');
    this.parts?.view.setAttribute('aria-label', name);
  }

  /** Says once what was not understood. */
  private complain(complaints: readonly string[]): void {
    const sentence = complaints.join(' ');
    if (this.trouble?.complain(sentence)) this.failWith('bad-attribute', sentence);
  }

  private failWith(code: ErrorCode, message: string): void {
    this.fail(new PlateauError(code, message));
  }

  /** As `fail`, where the same could be tried again. */
  private lose(error: unknown): void {
    this.refused = true;
    this.fail(error);
  }

  /** Shows the sentence and tells of it; the death of a worker is heard of twice. */
  private fail(error: unknown): void {
    const { cause } = error instanceof Error ? error : {};
    if (!this.trouble || error === this.told || (cause !== undefined && cause === this.told)) return;
    this.told = error;
    this.trouble.say(error instanceof Error ? error.message : String(error), this.refused);
    this.tell(error);
  }

  private readonly applyTheme = (): void => this.viewer?.applyTheme();
  private readonly keepStill = (): void => this.viewer?.keepStill();
}

declare global {
  interface HTMLElementTagNameMap {
    'plateau-view': PlateauViewElement;
  }
}
