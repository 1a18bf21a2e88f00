import type { PlateauModule } from 'plateau-module';
import type { WorkerEvent, WorkerRequest } from './protocol.ts';
import { WorkerRuntime } from './runtime.ts';

const scope = self as unknown as DedicatedWorkerGlobalScope;

// A message to oneself comes after those that wait already; a timer would wait at least 4 ms each time.
const turn = new MessageChannel();
let callback: (() => void) | undefined;
turn.port1.onmessage = () => callback?.();
function schedule(next: () => void): void {
  callback = next;
  turn.port2.postMessage(null);
}

function post(event: WorkerEvent, transfer: ArrayBuffer[]): void {
  scope.postMessage(event, transfer);
}

/** Takes the requests of this worker; what comes before the module waits for it. */
export function servedBy(loading: Promise<PlateauModule>): (request: WorkerRequest) => void {
  const early: WorkerRequest[] = [];
  let handle = (request: WorkerRequest): void => void early.push(request);
  loading.then(
    (module) => {
      const runtime = new WorkerRuntime(module, post, schedule);
      post({ kind: 'ready', runId: 0 }, []);
      handle = (request) => runtime.handle(request);
      for (const request of early.splice(0)) handle(request);
    },
    // A rejected promise does not reach the page; an error event does.
    (error: unknown) => reportError(error),
  );
  return (request) => handle(request);
}
