// Figures in space: only pages that have one load it.
import { PlateauViewElement } from '../embed/plateau-view-element.ts';
import { shareWorker } from '../embed/shared-worker.ts';
import { sharedWorker } from './page-core.ts';

export function defineViews(): void {
  shareWorker(sharedWorker);
  customElements.define('plateau-view', PlateauViewElement);
}
