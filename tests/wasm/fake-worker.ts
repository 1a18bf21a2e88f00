import type { WorkerLike } from '../../web/src/client/worker-link.ts';
import type { WorkerEvent, WorkerRequest } from '../../web/src/worker/protocol.ts';
import { openedWith } from '../web/model/fixtures.ts';

export const OPENED = openedWith();

/** A worker that answers only what the test wants. */
export class FakeWorker implements WorkerLike {
  onmessage: WorkerLike['onmessage'] = null;
  onmessageerror: WorkerLike['onmessageerror'] = null;
  onerror: WorkerLike['onerror'] = null;
  readonly requests: WorkerRequest[] = [];
  terminated = false;

  postMessage(request: WorkerRequest): void {
    this.requests.push(request);
  }

  terminate(): void {
    this.terminated = true;
  }

  /** Its program is loaded. */
  begin(): void {
    this.answer({ kind: 'ready', runId: 0 });
  }

  answer(event: WorkerEvent): void {
    this.onmessage?.({ data: event } as MessageEvent<WorkerEvent>);
  }

  open(at = 0): void {
    const request = this.requests[at];
    if (request?.kind !== 'open') throw new Error('nothing to open');
    this.answer({ kind: 'opened', runId: request.runId, requestId: request.requestId, opened: OPENED });
  }

  die(message: string): void {
    this.onerror?.({ message, preventDefault: () => undefined } as ErrorEvent);
  }
}
