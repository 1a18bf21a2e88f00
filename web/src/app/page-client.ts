import { PlateauClient } from '../client/plateau-client.ts';
import type { PlateauError } from '../client/plateau-error.ts';
import { demandBrowser } from '../package/browser-floor.ts';

/** A worker of the page's own origin; where the browser is too old for it, a sentence. */
export function startWorker(): Worker {
  demandBrowser('core');
  return new Worker(new URL('../worker/main.ts', import.meta.url), { type: 'module' });
}

export function pageClient(onDeath: (error: PlateauError) => void): PlateauClient {
  return new PlateauClient({ spawn: startWorker, onDeath });
}
