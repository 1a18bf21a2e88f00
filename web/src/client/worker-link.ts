import type { WorkerEvent, WorkerRequest } from '../worker/protocol.ts';
import { PlateauError, WORKER_FAILED } from './plateau-error.ts';

/** What the link needs of a Worker; a test brings its own. */
export interface WorkerLike {
  onmessage: ((event: MessageEvent<WorkerEvent>) => unknown) | null;
  onmessageerror: ((event: MessageEvent) => unknown) | null;
  onerror: ((event: ErrorEvent) => unknown) | null;
  postMessage(request: WorkerRequest, transfer: Transferable[]): void;
  terminate(): void;
}

type WithoutId<T> = T extends unknown ? Omit<T, 'requestId'> : never;
export type OutgoingRequest = WithoutId<WorkerRequest>;

interface Pending {
  readonly resolve: (event: WorkerEvent) => void;
  readonly reject: (error: Error) => void;
}

/** A worker is asked to answer within a slice; one that says nothing for this many looks in a row is dead. */
const LOOK_EVERY_MS = 5_000;
const SILENT_LOOKS = 6;

/**
 * Requests become promises. Every promise settles: with its answer, with a failure of the core, or, when the worker
 * dies or falls silent, with a readable failure. A dead worker is replaced by the next request. As long as a worker
 * loads its program nobody looks: that takes what the network takes, and a failure there is heard of.
 */
export class WorkerLink {
  private worker: WorkerLike | undefined;
  /** Whether its program is loaded. */
  private ready = false;
  private readonly pending = new Map<number, Pending>();
  private nextRequestId = 1;
  private silentLooks = 0;
  private lives = 0;
  private death: PlateauError | undefined;
  private watch: ReturnType<typeof setInterval> | undefined;

  /** `onDeath` is told why a worker died, also when nobody was waiting. All its runs are gone then. */
  constructor(
    private readonly spawn: () => WorkerLike,
    private readonly onDeath: (error: PlateauError) => void,
  ) {}

  send(request: OutgoingRequest, transfer: Transferable[] = []): Promise<WorkerEvent> {
    const requestId = this.nextRequestId++;
    return new Promise((resolve, reject) => {
      this.pending.set(requestId, { resolve, reject });
      if (this.ready) this.startWatch();
      try {
        this.worker ??= this.start();
        this.worker.postMessage({ ...request, requestId }, transfer);
      } catch (error) {
        this.pending.delete(requestId);
        if (this.pending.size === 0) this.stopWatch();
        reject(error instanceof Error ? error : new Error(String(error)));
      }
    });
  }

  /** How many workers there were before: what began in one of them ended with it. */
  get life(): number {
    return this.lives;
  }

  /** As `send`, for what only the worker of that life can answer; a later one does not know it. */
  async sendWithin(life: number, request: OutgoingRequest): Promise<WorkerEvent> {
    const { death } = this;
    if (!death || life === this.lives) return this.send(request);
    throw new PlateauError(death.code, `This run is not open any more. ${death.message}`, { cause: death });
  }

  /** Ends the worker; what is pending fails. The next request starts a fresh one. */
  dispose(): void {
    this.end(new PlateauError('closed', 'The computation was closed.'));
  }

  private start(): WorkerLike {
    const worker = this.spawn();
    worker.onmessage = ({ data }) => {
      this.silentLooks = 0;
      if (data.kind === 'ready') {
        this.ready = true;
        if (this.pending.size > 0) this.startWatch();
        return;
      }
      const waiting = this.pending.get(data.requestId);
      if (!waiting) return;
      this.pending.delete(data.requestId);
      // A watch that goes on would keep a program alive that has nothing more to do.
      if (this.pending.size === 0) this.stopWatch();
      if (data.kind === 'failed') waiting.reject(PlateauError.of(data.failure));
      else waiting.resolve(data);
    };
    worker.onerror = (event) => {
      event.preventDefault();
      this.die(
        event.message || 'its program could not be loaded, or the policy of this page does not allow it',
      );
    };
    worker.onmessageerror = () => this.die('a message could not be read');
    return worker;
  }

  private startWatch(): void {
    if (this.watch !== undefined) return;
    this.silentLooks = 0;
    this.watch = setInterval(() => {
      if (++this.silentLooks >= SILENT_LOOKS) this.die('it no longer answers');
    }, LOOK_EVERY_MS);
  }

  private stopWatch(): void {
    clearInterval(this.watch);
    this.watch = undefined;
  }

  private die(reason: string): void {
    const error = new PlateauError(WORKER_FAILED, `The computation stopped unexpectedly (${reason}).`);
    this.end(error);
    this.onDeath(error);
  }

  private end(error: PlateauError): void {
    this.stopWatch();
    this.lives += 1;
    this.death = error;
    this.ready = false;
    if (this.worker) {
      // What it still has to say is not of the next one.
      this.worker.onmessage = this.worker.onmessageerror = this.worker.onerror = null;
      this.worker.terminate();
    }
    this.worker = undefined;
    const waiting = [...this.pending.values()];
    this.pending.clear();
    for (const { reject } of waiting) reject(error);
  }
}
