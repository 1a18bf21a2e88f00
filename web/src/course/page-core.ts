import { startWorker } from '../app/page-client.ts';
import { SharedClient } from '../package/shared-client.ts';
import { ClientPlaneCore } from '../sketch/client-plane-core.ts';
import type { RunOptions } from '../worker/protocol.ts';

/** One worker for all figures of the page; it ends when the page is left. */
export const sharedWorker = new SharedClient(startWorker);

/** What the tasks ask beyond the figures. */
export class PageCore extends ClientPlaneCore {
  /** The Betti numbers of a sample at one step. */
  async bettiAt(
    { shape, size, seed }: { shape: string; size: number; seed: number },
    options: RunOptions,
    step: number,
  ): Promise<number[]> {
    const run = await this.client.open({ kind: 'sample', shape, size, seed }, { ...options, maxSteps: step });
    const deltas = await this.through(run);
    const { bettiCount } = run.opened;
    const all = deltas.flatMap(({ betti }) => [...betti]);
    return all.slice((step - 1) * bettiCount, step * bettiCount);
  }
}

let core: PageCore | undefined;

export function coreOfPage(): PageCore {
  core ??= new PageCore(sharedWorker.share().client);
  return core;
}
