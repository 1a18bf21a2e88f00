import { openPoints } from '../client/open-points.ts';
import type { RunOptions } from '../worker/protocol.ts';
import { sourceOf, type Cloud } from './cloud.ts';
import { demand, demandIfGiven, demandOptions } from './given.ts';
import { Run } from './run.ts';
import type { SharedClient } from './shared-client.ts';

/** What a run does with the points, and how an opening is given up. */
export interface OpenOptions extends RunOptions {
  /** Aborted, it ends the opening, which fails with the signal's reason. */
  readonly signal?: AbortSignal;
}

/** Opens a run that holds the client as long as it is not closed. */
export async function openWith(shared: SharedClient, cloud: Cloud, options: OpenOptions): Promise<Run> {
  demand('The second argument', options, 'an object');
  const { signal, ...asked } = options;
  demandIfGiven('signal', signal, 'an AbortSignal');
  demandOptions(asked);
  let opened: Run | undefined;
  const share = shared.share(() => opened?.lose());
  try {
    const { run } = await openPoints(share.client, () => sourceOf(cloud), asked, signal);
    opened = new Run(run, () => share.release());
    return opened;
  } catch (error) {
    share.release();
    throw error;
  }
}
