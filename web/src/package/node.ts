import { readFileSync } from 'node:fs';
import type { Cloud } from './cloud.ts';
import { InProcessWorker } from './in-process.ts';
import { openWith, type OpenOptions } from './open-cloud.ts';
import type { Run } from './run.ts';
import { SharedClient } from './shared-client.ts';

export * from './types.ts';

const shared = new SharedClient(
  () =>
    new InProcessWorker(
      readFileSync(new URL(/* @vite-ignore */ './plateau.wasm', import.meta.url)),
      setImmediate,
    ),
);

/**
 * Reads the points and starts to compute; resolves as soon as the run can be watched. The run computes in slices of
 * this thread, between which everything else has its turn.
 *
 * @throws {@link PlateauError}, with a sentence for people and a code for programs.
 */
export function openCloud(cloud: Cloud, options: OpenOptions = {}): Promise<Run> {
  return openWith(shared, cloud, options);
}
