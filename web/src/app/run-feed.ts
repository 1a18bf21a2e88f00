import type { RemoteRun } from '../client/plateau-client.ts';
import { CardStack, type PlateauCard } from '../model/plateau-cards.ts';
import { RunRecord } from '../model/record.ts';
import type { Failure } from '../worker/protocol.ts';

/** Between two questions to the worker: it computes on, the page draws. */
const PULL_MS = 25;
const CARDS_EVERY_MS = 500;

export interface FeedListener {
  /** The record has grown. */
  grown(): void;
  cardsFound(cards: readonly PlateauCard[]): void;
  /** Nothing more will come; `stopped` says why, if it was too early. */
  ended(stopped: Failure | undefined): void;
  failed(error: unknown): void;
}

/** Pulls what a run appends into a record until it ends. */
export class RunFeed {
  readonly record: RunRecord;
  private readonly cards: CardStack;
  private stopped = false;
  private pulling = false;
  private resting = false;
  private readonly listeners: Set<FeedListener>;

  /** `reach`: so many steps are computed at least, past plateaus that would end the run before. */
  constructor(
    readonly run: RemoteRun,
    listener: FeedListener,
    private readonly reach = 0,
  ) {
    this.listeners = new Set([listener]);
    this.record = new RunRecord(run.opened);
    this.cards = new CardStack(this.record);
  }

  /** Somebody else is told, too, until the function that is returned is called. */
  alsoTell(listener: FeedListener): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }

  start(): void {
    if (this.pulling || this.resting) return;
    this.pulling = true;
    this.pull()
      .catch((error: unknown) => this.fail(error))
      .finally(() => {
        this.pulling = false;
      });
  }

  /** Nothing more is computed or asked for, until `resume`. */
  pause(): void {
    if (this.resting) return;
    this.resting = true;
    // A dead worker computes nothing anyway.
    this.run.pause().catch(() => undefined);
  }

  resume(): void {
    if (!this.resting) return;
    this.resting = false;
    if (this.record.ended) return;
    this.run.resume().then(
      () => this.start(),
      (error: unknown) => this.fail(error),
    );
  }

  /** The run goes on beyond the noise, also where it has ended there. */
  async runPastNoise(): Promise<void> {
    await this.run.runPastNoise();
    this.record.runPastNoise();
    this.start();
  }

  /** The run goes on to the next plateau that is long enough, where it has ended at one. */
  async runToNextPlateau(): Promise<void> {
    await this.run.runToNextPlateau();
    this.record.runToNextPlateau();
    this.start();
  }

  /** Ends the pulling and frees the run in the worker. */
  dispose(): void {
    this.stopped = true;
    // A dead worker has nothing to free.
    this.run.close().catch(() => undefined);
  }

  /** What ends because the run was freed is no fault. */
  private fail(error: unknown): void {
    if (!this.stopped) this.tell((listener) => listener.failed(error));
  }

  private tell(what: (listener: FeedListener) => void): void {
    for (const listener of [...this.listeners]) what(listener);
  }

  private async pull(): Promise<void> {
    let cardsDue = 0;
    while (!this.stopped && !this.resting) {
      const delta = await this.run.fetchDelta();
      if (this.stopped) return;
      this.record.append(delta);
      if (this.record.endedAtPlateau && this.record.stepCount < this.reach) {
        await this.run.runToNextPlateau();
        this.record.runToNextPlateau();
      }
      this.tell((listener) => listener.grown());
      if (this.record.ended || performance.now() >= cardsDue) {
        const plateaus = await this.run.fetchPlateaus();
        if (this.stopped) return;
        const cards = this.cards.ranked(plateaus);
        this.tell((listener) => listener.cardsFound(cards));
        cardsDue = performance.now() + CARDS_EVERY_MS;
      }
      // Asked again: a stop at the noise or at a plateau may have been lifted meanwhile.
      if (this.record.ended) {
        this.tell((listener) => listener.ended(delta.stopped));
        return;
      }
      await new Promise((resolve) => setTimeout(resolve, PULL_MS));
    }
  }
}
