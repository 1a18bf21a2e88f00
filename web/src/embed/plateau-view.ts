/**
 * The custom element `<plateau-view>`; importing this defines it.
 *
 * @module plateau/element
 */
import { startPackagedWorker } from '../package/packaged-worker.ts';
import { SharedClient } from '../package/shared-client.ts';
import { PlateauViewElement } from './plateau-view-element.ts';
import { shareWorker } from './shared-worker.ts';

export { PlateauError, type ErrorCode } from '../client/plateau-error.ts';
export type { Torsion } from '../model/record.ts';
export type { ErrorDetail, PlateauDetail, PlateauViewEventMap, ReadyDetail, StepDetail } from './events.ts';
export type { LoadOptions } from './element-cloud.ts';
export type { Panels, Theme } from './settings.ts';
export { PlateauViewElement };

// A page may name this program twice, by two addresses.
if (!customElements.get('plateau-view')) {
  shareWorker(new SharedClient(startPackagedWorker));
  customElements.define('plateau-view', PlateauViewElement);
}
