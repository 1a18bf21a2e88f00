import type { PlateauViewElement } from '../embed/plateau-view-element.ts';
import type { StepDetail } from '../embed/events.ts';
import { SETTABLE } from './links.ts';
import { PlaneSketchElement } from '../sketch/plane-sketch-element.ts';

/** The step that each view shows, as it told last. */
const shown = new WeakMap<Element, StepDetail>();

/** Listens from the beginning: a view tells its step once. */
export function watchViews(): void {
  document.addEventListener('step', (event) => {
    if (event instanceof CustomEvent && event.target instanceof Element)
      shown.set(event.target, event.detail as StepDetail);
  });
}

export function sketchOf(id: string): PlaneSketchElement {
  const element = document.getElementById(id);
  if (!(element instanceof PlaneSketchElement)) throw new Error(`#${id} is no sketch`);
  return element;
}

/** A view of a cloud, and what it shows; nothing while it is not open. */
export interface ShownView {
  readonly element: PlateauViewElement;
  readonly step: StepDetail | undefined;
}

export function viewOf(id: string): ShownView {
  const element = document.querySelector<PlateauViewElement>(`plateau-view#${id}`);
  if (!element) throw new Error(`#${id} is no view`);
  return { element, step: shown.get(element) };
}

/** What is shown of a figure, or asked of it, changes nothing of what it is. */
const LOOKS: readonly string[] = ['show', 'layers', 'offer', 'ask', 'panels', 'theme'];

/** Calls whenever a figure has become another. */
export function changesOf(id: string, changed: () => void): void {
  const element = document.getElementById(id);
  if (!element) return;
  const names = SETTABLE[element.localName]?.filter((name) => !LOOKS.includes(name)) ?? [];
  new MutationObserver((records) => {
    if (records.some(({ attributeName, oldValue }) => element.getAttribute(attributeName ?? '') !== oldValue))
      changed();
  }).observe(element, { attributeFilter: [...names], attributeOldValue: true });
  element.addEventListener('step', changed);
}
