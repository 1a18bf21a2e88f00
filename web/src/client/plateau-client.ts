import type { Inspection, PlanePicture, PlaneScene, PlaneView } from '../worker/inspection.ts';
import type {
  CloudSource,
  Delta,
  ExportFormat,
  Opened,
  Plateaus,
  RunOptions,
  WorkerEvent,
} from '../worker/protocol.ts';
import { PlateauError, WORKER_FAILED } from './plateau-error.ts';
import { WorkerLink, type OutgoingRequest, type WorkerLike } from './worker-link.ts';

function outOfTurn(event: WorkerEvent): PlateauError {
  return new PlateauError(WORKER_FAILED, `The computation answered out of turn (${event.kind}).`);
}

/** A run in the worker. Close it when it is no longer shown; its memory is freed there. */
export class RemoteRun {
  private readonly life: number;
  private closing: Promise<WorkerEvent> | undefined;

  constructor(
    private readonly link: WorkerLink,
    private readonly runId: number,
    readonly opened: Opened,
  ) {
    this.life = link.life;
  }

  async fetchDelta(): Promise<Delta> {
    const event = await this.send({ kind: 'fetchDelta', runId: this.runId });
    if (event.kind !== 'delta') throw outOfTurn(event);
    return event.delta;
  }

  async fetchPlateaus(): Promise<Plateaus> {
    const event = await this.send({ kind: 'fetchPlateaus', runId: this.runId });
    if (event.kind !== 'plateaus') throw outOfTurn(event);
    return event.plateaus;
  }

  /** The bytes of a file in the command's format; `step` is for what shows one, `view` for a session. */
  async exportFile(format: ExportFormat, step?: number, view?: string): Promise<Uint8Array> {
    const at = step === undefined ? {} : { step };
    const kept = view === undefined ? {} : { view };
    const event = await this.send({ kind: 'export', runId: this.runId, format, ...at, ...kept });
    if (event.kind !== 'exported') throw outOfTurn(event);
    return event.bytes;
  }

  /** Why the simplex of these landmarks (named by their steps) is in the complex shown at the step, or why not. */
  async inspect(step: number, vertices: readonly number[]): Promise<Inspection> {
    const event = await this.send({ kind: 'inspect', runId: this.runId, step, vertices });
    if (event.kind !== 'inspected') throw outOfTurn(event);
    return event.inspection;
  }

  async pause(): Promise<void> {
    await this.send({ kind: 'pause', runId: this.runId });
  }

  async resume(): Promise<void> {
    await this.send({ kind: 'resume', runId: this.runId });
  }

  /** Lifts the stop at the noise: the run goes on to its end, whether it has ended there or not. */
  async runPastNoise(): Promise<void> {
    await this.send({ kind: 'runPastNoise', runId: this.runId });
  }

  /** A run that ended at a plateau goes on to the next one that is long enough, or to its end. */
  async runToNextPlateau(): Promise<void> {
    await this.send({ kind: 'runToNextPlateau', runId: this.runId });
  }

  /** Twice is once. */
  async close(): Promise<void> {
    this.closing ??= this.send({ kind: 'close', runId: this.runId });
    await this.closing;
  }

  /** A run ends with its worker: another one would not know it. */
  private async send(request: OutgoingRequest): Promise<WorkerEvent> {
    if (this.closing) throw new PlateauError('closed', 'The run was closed.');
    return this.link.sendWithin(this.life, request);
  }
}

/** The door to the computation: opens runs in one worker, which it replaces when it dies. */
export class PlateauClient {
  private readonly link: WorkerLink;
  private nextRunId = 1;

  /** `spawn` starts a worker that serves runs; `onDeath` is told why one died. */
  constructor(options: { spawn: () => WorkerLike; onDeath?: (error: PlateauError) => void }) {
    this.link = new WorkerLink(options.spawn, options.onDeath ?? (() => undefined));
  }

  /**
   * Reads the source and starts a run; resolves once it can be watched. The bytes of a file are transferred: the
   * caller's buffer is empty afterwards. An aborted signal closes the run within a slice and rejects with its reason.
   */
  async open(source: CloudSource, options: RunOptions, signal?: AbortSignal): Promise<RemoteRun> {
    signal?.throwIfAborted();
    const runId = this.nextRunId++;
    const abort = (): void => {
      this.link.send({ kind: 'close', runId }).catch(() => undefined);
    };
    signal?.addEventListener('abort', abort, { once: true });
    try {
      const transfer = source.kind === 'file' ? [source.bytes] : [];
      const event = await this.link.send({ kind: 'open', runId, source, options }, transfer);
      signal?.throwIfAborted();
      if (event.kind !== 'opened') throw outOfTurn(event);
      return new RemoteRun(this.link, runId, event.opened);
    } catch (error) {
      signal?.throwIfAborted();
      throw error;
    } finally {
      signal?.removeEventListener('abort', abort);
    }
  }

  /** The exact picture of witnesses and landmarks in the plane; of no run. */
  async planePicture(view: PlaneView): Promise<PlanePicture> {
    const event = await this.link.send({ kind: 'drawPlane', runId: 0, view });
    if (event.kind !== 'planeDrawn') throw outOfTurn(event);
    return event.picture;
  }

  /**
   * Why the simplex of these landmarks, named by their places in the array from 0 on, is in the complex of the scene, or
   * why not. Steps and lifespans mean nothing there; the words count landmarks from 1.
   */
  async planeWhy(scene: PlaneScene, vertices: readonly number[]): Promise<Inspection> {
    const event = await this.link.send({ kind: 'inspectPlane', runId: 0, scene, vertices });
    if (event.kind !== 'inspected') throw outOfTurn(event);
    return event.inspection;
  }

  dispose(): void {
    this.link.dispose();
  }
}
