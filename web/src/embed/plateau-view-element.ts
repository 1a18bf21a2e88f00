import type { RemoteRun } from '../client/plateau-client.ts';
import { codeOf, PlateauError, type ErrorCode } from '../client/plateau-error.ts';
import { demandBrowser } from '../package/browser-floor.ts';
import type { ClientShare } from '../package/shared-client.ts';
import { cloudOf, nameOf, optionsFor, type Given, type Opening } from './element-cloud.ts';
import { plateauDetail, type PlateauDetail, type PlateauViewEventMap } from './events.ts';
import { createParts, type Parts } from './parts.ts';
import { ReflectingElement } from './reflecting-element.ts';
import { ATTRIBUTES, settingsOf, type Settings } from './settings.ts';
import { sharedWorker } from './shared-worker.ts';
import { elementStyle } from './style.ts';
import { Viewer, type Destination } from './viewer.ts';

const EMPTY = 'Nothing to show yet: this element needs a shape or a src.';

/** Whoever called `load` and waits. */
interface Waiting {
  readonly resolve: () => void;
  readonly reject: (reason: unknown) => void;
}

/** How points are read that a call gives. */
export interface LoadOptions {
  /** Coordinates a point of a Float64Array; 3 unless given. */
  readonly dimension?: number;
  /** Which columns of a table are the coordinates, from 1. */
  readonly columns?: readonly number[];
}

function reading(points: File | Float64Array, { dimension = 3, columns }: LoadOptions): Given {
  return points instanceof Float64Array
    ? { kind: 'points', points, dimension }
    : { kind: 'file', file: points, ...(columns ? { columns } : {}) };
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
  private share: ClientShare | undefined;
  private opening: AbortController | undefined;
  /** What is opened or being opened, to see whether the attributes ask for something else. */
  private asked = '';
  private destination = '';
  private given: Given | undefined;
  private givenOver = '';
  private waiting: Waiting[] = [];
  private complained = '';
  private told: unknown;
  private inView = false;
  private scheduled = false;
  private unsupported = false;
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

  /** Whether the film runs, or will as soon as the element is in view. */
  get playing(): boolean {
    return this.viewer?.playing ?? false;
  }

  /** The plateaus so far, the longest first; those of few landmarks last. */
  get plateaus(): readonly PlateauDetail[] {
    return (this.viewer?.currentCards ?? []).map((card, i) => plateauDetail(card, i + 1));
  }

  /** @internal Nothing more will come: all plateaus are known. */
  get finished(): boolean {
    return this.viewer?.complete ?? false;
  }

  /** Lets the film run, from the beginning if it is at its end. */
  play(): void {
    this.viewer?.play();
  }

  /** Stops the film. */
  pause(): void {
    this.viewer?.pause();
  }

  /** Shows a step, or the last one that is computed; stops the film. */
  goTo(step: number): void {
    this.viewer?.goTo(step);
  }

  /**
   * Opens a file, or points as numbers, instead of what the attributes name; what is shown stays until the new points
   * can be watched, and for good if that fails. Resolves with the event `ready`, rejects with the event `error`, or
   * with an AbortError where another opening or the removal of the element came in between.
   */
  load(points: File | Float64Array, options: LoadOptions = {}): Promise<void> {
    this.given = reading(points, options);
    this.givenOver = JSON.stringify(settingsOf(this).source ?? null);
    this.asked = '';
    this.giveUp();
    return new Promise((resolve, reject) => {
      this.waiting.push({ resolve, reject });
      this.schedule();
    });
  }

  /** As of every element; the events of this one have their details. */
  override addEventListener<K extends keyof PlateauViewEventMap>(
    type: K,
    listener: (event: PlateauViewEventMap[K]) => unknown,
    options?: boolean | AddEventListenerOptions,
  ): void;
  override addEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | AddEventListenerOptions,
  ): void;
  override addEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | AddEventListenerOptions,
  ): void {
    super.addEventListener(type, listener, options);
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
    if (this.viewer) this.schedule();
  }

  /** Also where the browser is too old for anything else there is a sentence. */
  private build(): void {
    const root = this.shadowRoot ?? this.attachShadow({ mode: 'open' });
    root.replaceChildren();
    try {
      demandBrowser('element');
    } catch (error) {
      this.unsupported = true;
      root.append(error instanceof Error ? error.message : String(error));
      this.tell(error);
      return;
    }
    root.adoptedStyleSheets = [elementStyle()];
    const parts = (this.parts = createParts());
    parts.dismiss.addEventListener('click', () => (parts.trouble.hidden = true));
    parts.empty.textContent = EMPTY;
    root.append(parts.box);
    this.viewer = new Viewer(parts, {
      stepped: ({ step, epsilon, family, betti, torsion }) =>
        this.emit('step', { step, epsilon, family, betti, ...(torsion ? { torsion } : {}) }),
      arrived: (card, rank) => this.emit('plateau', plateauDetail(card, rank)),
      failed: (error) => this.fail(error),
      stopped: (failure) => this.failWith(codeOf(failure), failure.message),
      noGraphics: (sentence) => this.tell(new PlateauError('no-graphics', sentence)),
      noSuchPlateau: (rank, plateaus) =>
        this.failWith('no-such-plateau', `There is no plateau ${rank}: the run has ${plateaus}.`),
    });
  }

  private tearDown(): void {
    this.giveUp();
    this.settle(({ reject }) => reject(new DOMException('The element was removed.', 'AbortError')));
    this.viewer?.dispose();
    this.viewer = undefined;
    this.parts = undefined;
    this.share?.release();
    this.share = undefined;
    this.inView = false;
    this.asked = this.destination = this.complained = '';
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
    if (JSON.stringify(settings.source ?? null) !== this.givenOver) this.given = undefined;
    const opening = this.given ?? settings.source;
    this.nameView(opening);
    if (!opening) {
      if (this.parts && !viewer.record) this.parts.empty.hidden = false;
      return;
    }
    if (!this.inView && this.waiting.length === 0) return;
    const destination = this.destinationOf(settings);
    const asked = JSON.stringify([this.given ? this.givenOver : settings.source, settings.options]);
    const sent = JSON.stringify(destination);
    if (asked !== this.asked) {
      this.asked = asked;
      this.destination = sent;
      void this.open(opening, settings, destination, viewer);
    } else if (sent !== this.destination) {
      this.destination = sent;
      viewer.send(destination);
    }
  }

  private destinationOf({ autoplay, step, plateau }: Settings): Destination {
    // Visitors who asked for less motion start the film themselves.
    const moves = autoplay && !matchMedia('(prefers-reduced-motion: reduce)').matches;
    if (moves) return { kind: 'film', from: step ?? 1 };
    if (step !== undefined) return { kind: 'step', step };
    return { kind: 'plateau', rank: plateau ?? 1, asked: plateau !== undefined };
  }

  private async open(
    opening: Opening,
    { options }: Settings,
    destination: Destination,
    viewer: Viewer,
  ): Promise<void> {
    this.opening?.abort();
    const { signal } = (this.opening = new AbortController());
    const view = this.parts?.view;
    view?.setAttribute('aria-busy', 'true');
    viewer.makeWay();
    try {
      // Whoever has all that was to come loses nothing with the worker.
      this.share ??= sharedWorker().share((error) => {
        if (!viewer.record?.ended) this.fail(error);
      });
      const { client } = this.share;
      const run = await client.open(await cloudOf(opening, signal), optionsFor(opening, options), signal);
      this.quiet();
      viewer.show(run, destination);
      this.nameView(opening);
      this.tellReady(opening, run);
      this.settle(({ resolve }) => resolve());
    } catch (error) {
      if (signal.aborted) return;
      viewer.goOn();
      this.fail(error);
      this.settle(({ reject }) => reject(error));
    }
    view?.removeAttribute('aria-busy');
    this.opening = undefined;
  }

  /** Ends the opening that is under way; those who wait for it are told. */
  private giveUp(): void {
    this.opening?.abort();
    this.opening = undefined;
    this.settle(({ reject }) => reject(new DOMException('Another opening came in between.', 'AbortError')));
  }

  private settle(end: (waiting: Waiting) => void): void {
    for (const waiting of this.waiting.splice(0)) end(waiting);
  }

  private nameView(opening: Opening | undefined): void {
    const name = this.getAttribute('aria-label') ?? (opening ? `Plateau: ${nameOf(opening)}` : 'Plateau');
    this.parts?.view.setAttribute('aria-label', name);
  }

  private tellReady(opening: Opening, { opened }: RemoteRun): void {
    const { points, dimension, family, nu, stepsPlanned, warnings } = opened;
    this.emit('ready', { name: nameOf(opening), points, dimension, family, nu, stepsPlanned, warnings });
  }

  /** Says once what was not understood. */
  private complain(complaints: readonly string[]): void {
    const sentence = complaints.join(' ');
    if (sentence === this.complained) return;
    this.complained = sentence;
    if (sentence === '') this.quiet();
    else this.failWith('bad-attribute', sentence);
  }

  private failWith(code: ErrorCode, message: string): void {
    this.fail(new PlateauError(code, message));
  }

  /** Shows the sentence and tells of it; the death of a worker is heard of twice. */
  private fail(error: unknown): void {
    const { cause } = error instanceof Error ? error : {};
    if (error === this.told || (cause !== undefined && cause === this.told)) return;
    this.told = error;
    if (this.parts) {
      this.parts.said.textContent = error instanceof Error ? error.message : String(error);
      this.parts.trouble.hidden = false;
    }
    this.tell(error);
  }

  /** What was wrong is over; what was not understood still is not. */
  private quiet(): void {
    if (!this.parts) return;
    this.parts.said.textContent = this.complained;
    this.parts.trouble.hidden = this.complained === '';
  }

  private tell(error: unknown): void {
    const code = error instanceof PlateauError ? error.code : 'internal';
    this.emit('error', { code, message: error instanceof Error ? error.message : String(error) });
  }

  private emit<K extends keyof PlateauViewEventMap>(name: K, detail: PlateauViewEventMap[K]['detail']): void {
    this.dispatchEvent(new CustomEvent(name, { detail, bubbles: true, composed: true }));
  }

  private readonly applyTheme = (): void => this.viewer?.applyTheme();
  private readonly keepStill = (): void => this.viewer?.keepStill();
}

declare global {
  interface HTMLElementTagNameMap {
    'plateau-view': PlateauViewElement;
  }
}
