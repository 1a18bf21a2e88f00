/**
 * The core: opens point clouds and follows their shapes, in Node.js and in browsers.
 *
 * @module plateau
 */
import { demandBrowser } from './browser-floor.ts';
import type { Cloud } from './cloud.ts';
import { openWith, type OpenOptions } from './open-cloud.ts';
import { startPackagedWorker } from './packaged-worker.ts';
import type { Run } from './run.ts';
import { SharedClient } from './shared-client.ts';

export * from './types.ts';
export { BROWSER_FLOOR } from './browser-floor.ts';

const shared = new SharedClient(startPackagedWorker);

/**
 * Reads the points and starts to compute; resolves as soon as the run can be watched. All runs of a page share one
 * worker, which ends when the last of them is closed. In Node.js a run computes in slices of the same thread, between
 * which everything else has its turn.
 *
 * @throws {@link PlateauError}, with a sentence for people and a code for programs.
 */
export async function openCloud(cloud: Cloud, options: OpenOptions = {}): Promise<Run> {
  demandBrowser('core');
  return openWith(shared, cloud, options);
}
