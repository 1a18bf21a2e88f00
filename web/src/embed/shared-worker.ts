import type { SharedClient } from '../package/shared-client.ts';

let shared: SharedClient | undefined;

/** Who defines the element says in which worker all elements of the page compute. */
export function shareWorker(client: SharedClient): void {
  shared = client;
}

export function sharedWorker(): SharedClient {
  if (!shared) throw new Error('shareWorker comes before the first element');
  return shared;
}
