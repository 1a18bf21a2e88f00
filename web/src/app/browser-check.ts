import { demandBrowser } from '../package/browser-floor.ts';
import { byId } from './dom.ts';

// The page imports this before anything else: in a browser that is too old nothing of the rest begins.
try {
  demandBrowser('page');
} catch (error) {
  byId('alert', HTMLElement).textContent = error instanceof Error ? error.message : String(error);
  byId('trouble', HTMLElement).hidden = false;
  throw error;
}
