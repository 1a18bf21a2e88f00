import createModule from 'plateau-module';
import type { WorkerLike } from '../client/worker-link.ts';
import type { WorkerEvent, WorkerRequest } from '../worker/protocol.ts';
import { WorkerRuntime } from '../worker/runtime.ts';

/**
 * What the worker does, in this very thread: in slices between which everything else has its turn. Messages come one
 * after another and never within the call that sent them, as those of a worker. It never says that it is ready, so
 * nobody looks whether it is silent: who would look runs in the same thread.
 */
export class InProcessWorker implements WorkerLike {
  onmessage: WorkerLike['onmessage'] = null;
  onmessageerror: WorkerLike['onmessageerror'] = null;
  onerror: WorkerLike['onerror'] = null;
  private runtime: Promise<WorkerRuntime>;
  private ended = false;

  /** `later` runs something after what waits already. */
  constructor(
    wasmBinary: Uint8Array,
    private readonly later: (callback: () => void) => void,
  ) {
    this.runtime = createModule({ wasmBinary }).then(
      (module) =>
        new WorkerRuntime(
          module,
          (event) => this.tell(event),
          (next) => this.turn(next),
        ),
    );
  }

  postMessage(request: WorkerRequest, transfer: Transferable[]): void {
    const own = structuredClone(request, { transfer });
    this.runtime.then(
      (runtime) => this.turn(() => runtime.handle(own)),
      (error: unknown) => this.die(error),
    );
  }

  terminate(): void {
    this.ended = true;
  }

  private tell(event: WorkerEvent): void {
    this.later(() => {
      if (!this.ended) this.onmessage?.(new MessageEvent('message', { data: event }));
    });
  }

  private turn(work: () => void): void {
    this.later(() => {
      if (this.ended) return;
      try {
        work();
      } catch (error) {
        this.die(error);
      }
    });
  }

  /** What the runtime throws is a broken module. */
  private die(error: unknown): void {
    const message = error instanceof Error ? error.message : String(error);
    this.onerror?.(Object.assign(new Event('error', { cancelable: true }), { message }) as ErrorEvent);
  }
}
