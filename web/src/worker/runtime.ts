import type { PlateauModule } from 'plateau-module';
import { CoreFailure, CoreSession, planePicture, planeWhy } from './core-session.ts';
import { frameOf } from './frame.ts';
import type { OpenedRun, WorkerEvent, WorkerRequest } from './protocol.ts';
import { buffersOf } from './transfer.ts';

/** How long the core may work before messages are looked at: a pause or a cancel waits no longer. */
const SLICE_MS = 12;
/** New simplices in one delta: the page appends them well within a frame. */
const DELTA_SIMPLICES = 30_000;
/** The first landmarks come one by one, so that they can be drawn at once. */
const FIRST_STEPS = 12;
const INVALID_OPTION = 8;
const INTERNAL = 12;

type OpenRequest = Extract<WorkerRequest, { kind: 'open' }>;

interface Entry {
  readonly core: CoreSession;
  readonly openRequest: OpenRequest;
  /** What was read, while it is not ready to be shown. */
  opened?: OpenedRun | undefined;
  phase: 'opening' | 'running' | 'paused' | 'done';
  /** Whether the tree over the points stands. */
  prepared: boolean;
  stepsDone: number;
}

export type Post = (event: WorkerEvent, transfer: ArrayBuffer[]) => void;

/** A value of a type that the module does not take is found before it does anything: only this request fails. */
function refused(error: unknown): CoreFailure | undefined {
  if (!(error instanceof Error) || !['TypeError', 'BindingError'].includes(error.name)) return undefined;
  return new CoreFailure({ code: INVALID_OPTION, message: `This was not understood: ${error.message}.` });
}

function assertNever(request: never): never {
  throw new Error(`Unknown request ${JSON.stringify(request)}`);
}

/**
 * Answers requests and computes in slices in between. It knows neither the worker's scope nor the page: `post` sends,
 * `schedule` runs a callback after waiting messages. Several runs can be open; one that opens does not disturb one
 * that is shown. Whatever it throws is a broken module: the caller must let the worker die of it.
 */
export class WorkerRuntime {
  private readonly runs = new Map<number, Entry>();
  private scheduled = false;
  private lastServed = 0;

  constructor(
    private readonly module: PlateauModule,
    private readonly post: Post,
    private readonly schedule: (callback: () => void) => void,
  ) {}

  handle(request: WorkerRequest): void {
    this.answering(request, () => {
      try {
        this.dispatch(request);
      } catch (error) {
        throw refused(error) ?? error;
      }
    });
  }

  private dispatch(request: WorkerRequest): void {
    const { runId, requestId } = request;
    switch (request.kind) {
      case 'open':
        this.runs.set(runId, {
          core: new CoreSession(this.module, request.source, request.options),
          openRequest: request,
          phase: 'opening',
          prepared: false,
          stepsDone: 0,
        });
        this.wake();
        return;
      case 'pause': {
        const entry = this.entry(runId);
        if (entry.phase === 'running') entry.phase = 'paused';
        this.send({ kind: 'paused', runId, requestId });
        return;
      }
      case 'resume': {
        const entry = this.entry(runId);
        if (entry.phase === 'paused') entry.phase = 'running';
        this.send({ kind: 'resumed', runId, requestId });
        this.wake();
        return;
      }
      case 'runPastNoise':
      case 'runToNextPlateau': {
        const entry = this.entry(runId);
        entry.core[request.kind]();
        // A run that has ended elsewhere ends again with its next slice.
        if (entry.phase === 'done') entry.phase = 'running';
        this.send({ kind: 'lifted', runId, requestId });
        this.wake();
        return;
      }
      case 'fetchDelta':
        this.send({ kind: 'delta', runId, requestId, delta: this.entry(runId).core.delta(DELTA_SIMPLICES) });
        return;
      case 'fetchPlateaus':
        this.send({ kind: 'plateaus', runId, requestId, plateaus: this.entry(runId).core.plateaus() });
        return;
      case 'export': {
        const bytes = this.entry(runId).core.exportFile(request.format, request.step, request.view);
        this.send({ kind: 'exported', runId, requestId, bytes });
        return;
      }
      case 'inspect': {
        const inspection = this.entry(runId).core.inspect(request.step, request.vertices);
        this.send({ kind: 'inspected', runId, requestId, inspection });
        return;
      }
      case 'drawPlane': {
        const picture = planePicture(this.module, request.view);
        this.send({ kind: 'planeDrawn', runId: 0, requestId, picture });
        return;
      }
      case 'inspectPlane': {
        const inspection = planeWhy(this.module, request.scene, request.vertices);
        this.send({ kind: 'inspected', runId, requestId, inspection });
        return;
      }
      case 'close': {
        const entry = this.runs.get(runId);
        if (entry) this.drop(runId, entry, 'The run was closed before it was open.');
        this.send({ kind: 'closed', runId, requestId });
        return;
      }
      default:
        assertNever(request);
    }
  }

  /** One slice of work for one run, in turn; then messages first. */
  private slice(): void {
    this.scheduled = false;
    const active = [...this.runs].filter(
      ([, entry]) => entry.phase === 'opening' || entry.phase === 'running',
    );
    const next = active.find(([runId]) => runId > this.lastServed) ?? active[0];
    if (!next) return;
    const [runId, entry] = next;
    this.lastServed = runId;
    if (entry.phase === 'opening') {
      this.answering(entry.openRequest, () => this.openSlice(runId, entry));
    } else {
      const first = entry.prepared && entry.stepsDone < FIRST_STEPS;
      const { state, stepsDone } = entry.core.advance(SLICE_MS, first ? 1 : undefined);
      entry.prepared = state !== 'preparing';
      entry.stepsDone = stepsDone;
      if (state === 'finished' || state === 'stopped') entry.phase = 'done';
    }
    this.wake();
  }

  private openSlice(runId: number, entry: Entry): void {
    const opened = (entry.opened ??= entry.core.open(SLICE_MS));
    if (!opened) return;
    // A graph of neighbors may turn out not to join all points: then what is shown has to stay.
    if (opened.metric === 'geodesic' && !entry.prepared) {
      const { state, stopped, stepsDone } = entry.core.advance(SLICE_MS, 1);
      if (stopped && stepsDone === 0) throw new CoreFailure(stopped);
      entry.prepared = state !== 'preparing';
      if (!entry.prepared) return;
    }
    entry.phase = 'running';
    const { points, dimension, coordinates, projection } = opened;
    const frame = frameOf(points, projection ?? { axes: dimension, coordinates, shares: [] });
    const { requestId } = entry.openRequest;
    this.send({ kind: 'opened', runId, requestId, opened: { ...opened, frame } });
  }

  private wake(): void {
    if (this.scheduled || this.runs.size === 0) return;
    this.scheduled = true;
    this.schedule(() => this.slice());
  }

  private entry(runId: number): Entry {
    const entry = this.runs.get(runId);
    if (!entry || entry.phase === 'opening') {
      throw new CoreFailure({ code: INTERNAL, message: 'This run is not open.' });
    }
    return entry;
  }

  /** Frees a run; its open request, if still unanswered, fails with `reason`. */
  private drop(runId: number, entry: Entry, reason: string): void {
    this.runs.delete(runId);
    entry.core.dispose();
    if (entry.phase === 'opening') {
      const { requestId } = entry.openRequest;
      this.send({ kind: 'failed', runId, requestId, failure: { code: INTERNAL, message: reason } });
    }
  }

  /** Answers `request` with the failure if `work` ends in an expected one. */
  private answering(request: WorkerRequest, work: () => void): void {
    try {
      work();
    } catch (error) {
      if (!(error instanceof CoreFailure)) throw error;
      const { runId, requestId } = request;
      const entry = this.runs.get(runId);
      if (request.kind === 'open' && entry) {
        this.runs.delete(runId);
        entry.core.dispose();
      }
      this.send({ kind: 'failed', runId, requestId, failure: error.failure });
    }
  }

  private send(event: WorkerEvent): void {
    this.post(event, buffersOf(event));
  }
}
