import { PlateauClient } from '../client/plateau-client.ts';
import type { PlateauError } from '../client/plateau-error.ts';

/** Runs in a worker of the page's own origin. */
export function pageClient(onDeath: (error: PlateauError) => void): PlateauClient {
  const spawn = (): Worker => new Worker(new URL('../worker/main.ts', import.meta.url), { type: 'module' });
  return new PlateauClient({ spawn, onDeath });
}
