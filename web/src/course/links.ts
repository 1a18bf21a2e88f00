import { ATTRIBUTES } from '../embed/settings.ts';
import { SKETCH_ATTRIBUTES } from '../sketch/sketch-state.ts';

/** What an address may set: nothing that loads from elsewhere. */
const VIEW_ATTRIBUTES = ATTRIBUTES.filter((name) => name !== 'src' && name !== 'columns');
/** By the name of the element. */
export const SETTABLE: Readonly<Record<string, readonly string[]>> = {
  'plane-sketch': SKETCH_ATTRIBUTES,
  'plateau-view': VIEW_ATTRIBUTES,
};

/** Points and lists are read more easily without escapes; spaces travel as underscores. */
const written = (value: string): string =>
  encodeURIComponent(value.replaceAll(' ', '_')).replaceAll('%2C', ',');

function settable(element: Element): readonly string[] {
  return SETTABLE[element.localName] ?? [];
}

/** As the page has it: what a link need not say. */
const presets = new WeakMap<Element, ReadonlyMap<string, string | null>>();

function read(element: Element): Map<string, string | null> {
  return new Map(settable(element).map((name) => [name, element.getAttribute(name)]));
}

export function rememberPresets(): void {
  for (const element of document.querySelectorAll('plane-sketch, plateau-view'))
    if (!presets.has(element)) presets.set(element, read(element));
}

/** The address of this page with a figure as it is now: `#map.landmarks=20,18_60,10&map.nu=1,2,3`. */
export function linkTo(element: Element): string {
  const preset = presets.get(element) ?? new Map<string, string | null>();
  const parts = [...now(element)]
    .filter(([name, value]) => value !== (preset.get(name) ?? null))
    // What the page has and the figure has not is told as nothing.
    .map(([name, value]) => `${element.id}.${name}=${value === null ? '-' : written(value)}`);
  const fragment = parts.length > 0 ? parts.join('&') : element.id;
  return `${location.href.replace(/#.*$/, '')}#${fragment}`;
}

/** A view is left where its playhead stands. */
function now(element: Element): Map<string, string | null> {
  const attributes = read(element);
  const step: unknown = Reflect.get(element, 'currentStep');
  if (typeof step === 'number' && step > 0) {
    attributes.set('step', String(step));
    attributes.set('plateau', null);
  }
  return attributes;
}

/** Sets what the address asks for. What it does not name, or may not, stays. */
export function followLink(): void {
  let target: Element | undefined;
  for (const part of location.hash.slice(1).split('&')) {
    const [, id = '', name = '', value = ''] = /^([\w-]+)\.([\w-]+)=(.*)$/.exec(part) ?? [];
    const element = id === '' ? null : document.getElementById(id);
    if (!element || !settable(element).includes(name)) continue;
    target ??= element;
    if (value === '-') element.removeAttribute(name);
    else element.setAttribute(name, decoded(value).replaceAll('_', ' '));
  }
  target?.scrollIntoView({ block: 'center' });
}

function decoded(value: string): string {
  try {
    return decodeURIComponent(value);
  } catch {
    // Not an escape after all.
    return value;
  }
}
