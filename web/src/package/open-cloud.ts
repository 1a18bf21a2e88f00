import type { RunOptions } from '../worker/protocol.ts';
import { sourceOf, type Cloud } from './cloud.ts';
import { Run } from './run.ts';
import type { SharedClient } from './shared-client.ts';

/** What a run does with the points, and how an opening is given up. */
export interface OpenOptions extends RunOptions {
  /** Aborted, it ends the opening, which fails with the signal's reason. */
  readonly signal?: AbortSignal;
}

/** Opens a run that holds the client as long as it is not closed. */
export async function openWith(shared: SharedClient, cloud: Cloud, options: OpenOptions): Promise<Run> {
  const { signal, ...asked } = options;
  const share = shared.share();
  try {
    return new Run(await share.client.open(sourceOf(cloud), asked, signal), () => share.release());
  } catch (error) {
    share.release();
    throw error;
  }
}
