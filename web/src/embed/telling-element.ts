import { PlateauError } from '../client/plateau-error.ts';
import type { PlateauViewEventMap } from './events.ts';

/** An element that tells the page around it what happens, by events with details. */
export class TellingElement extends HTMLElement {
  /** As of every element; the events of this one have their details. */
  override addEventListener<K extends keyof PlateauViewEventMap>(
    type: K,
    listener: (event: PlateauViewEventMap[K]) => unknown,
    options?: boolean | AddEventListenerOptions,
  ): void;
  override addEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | AddEventListenerOptions,
  ): void;
  override addEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | AddEventListenerOptions,
  ): void {
    super.addEventListener(type, listener, options);
  }

  protected emit<K extends keyof PlateauViewEventMap>(
    name: K,
    detail: PlateauViewEventMap[K]['detail'],
  ): void {
    // An `error` that bubbled to the window would be taken for one of the page's own scripts.
    this.dispatchEvent(new CustomEvent(name, { detail, bubbles: name !== 'error', composed: true }));
  }

  protected tell(error: unknown): void {
    const code = error instanceof PlateauError ? error.code : 'internal';
    this.emit('error', { code, message: error instanceof Error ? error.message : String(error) });
  }
}
