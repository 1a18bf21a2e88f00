import { browserFault } from '../package/browser-floor.ts';
import { byId } from './dom.ts';

// The page imports this before anything else: in a browser that is too old nothing of the rest begins.
const fault = browserFault('page');
if (fault) {
  byId('alert', HTMLElement).textContent = fault.message;
  byId('trouble', HTMLElement).hidden = false;
  throw fault;
}
