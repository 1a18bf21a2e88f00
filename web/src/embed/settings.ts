import type { Family, RunOptions } from '../worker/protocol.ts';
import { SAMPLES } from '../app/samples.ts';

/** What of an element is seen: the shape, its Betti numbers over the scale, both, or also the plateaus and all buttons. */
export type Panels = 'shape' | 'diagram' | 'both' | 'full';
/** As the visitor's system asks, or one of the two in any case. */
export type Theme = 'auto' | 'light' | 'dark';

/** Where the points of an element come from. */
export type ElementSource =
  | {
      readonly kind: 'shape';
      readonly shape: string;
      readonly size: number;
      readonly noise?: number;
      readonly seed?: number;
    }
  | { readonly kind: 'address'; readonly address: string; readonly columns?: readonly number[] };

/** What the attributes ask for. */
export interface Settings {
  readonly source: ElementSource | undefined;
  readonly options: RunOptions;
  /** Where the playhead goes. */
  readonly step: number | undefined;
  /** 1: the longest plateau; undefined where none was named. */
  readonly plateau: number | undefined;
  readonly autoplay: boolean;
  readonly panels: Panels;
  /** Sentences about values that were not understood; their defaults are taken. */
  readonly complaints: readonly string[];
}

/** Every attribute that an element looks at. */
export const ATTRIBUTES = [
  'shape',
  'size',
  'noise',
  'seed',
  'src',
  'columns',
  'family',
  'nu',
  'steps',
  'step',
  'plateau',
  'autoplay',
  'panels',
  'theme',
] as const;
export type AttributeName = (typeof ATTRIBUTES)[number];

/** Those that say how it is looked at. */
const OF_LOOKING: readonly string[] = ['step', 'plateau', 'autoplay', 'panels', 'theme'];
/** The others: what is opened and how. */
export const OF_OPENING: readonly string[] = ATTRIBUTES.filter((name) => !OF_LOOKING.includes(name));

const PANELS: readonly Panels[] = ['shape', 'diagram', 'both', 'full'];
const THEMES: readonly Theme[] = ['auto', 'light', 'dark'];
/** Points of a shape that does not say its own. */
const USUAL_SIZE = 3000;
const DEFAULT_PANELS: Panels = 'both';

/** Whether there is such a family is for the core to say: it knows them all. */
function named(family: string): family is Family {
  return family !== '';
}

/** Reads attributes, and gathers a sentence for each that makes no sense. */
class Reader {
  readonly complaints: string[] = [];

  constructor(private readonly element: Element) {}

  text(name: AttributeName): string | undefined {
    const value = this.element.getAttribute(name)?.trim();
    return value === '' ? undefined : value;
  }

  number(name: AttributeName, least: number, whole: boolean): number | undefined {
    const text = this.text(name);
    if (text === undefined) return undefined;
    const value = Number(text);
    if (Number.isFinite(value) && value >= least && (!whole || Number.isInteger(value))) return value;
    return this.complain(name, text, `a ${whole ? 'whole ' : ''}number from ${least} on`);
  }

  list(name: AttributeName, least: number): readonly number[] | undefined {
    const text = this.text(name);
    if (text === undefined) return undefined;
    const entries = text.split(/[\s,;]+/);
    if (entries.every((entry) => /^\d+$/.test(entry) && Number(entry) >= least)) return entries.map(Number);
    return this.complain(name, text, `whole numbers from ${least} on, separated by commas`);
  }

  choice<T extends string>(name: AttributeName, choices: readonly T[]): T | undefined {
    const text = this.text(name);
    const chosen = choices.find((choice) => choice === text);
    if (text !== undefined && chosen === undefined) this.complain(name, text, choices.join(', '));
    return chosen;
  }

  private complain(name: AttributeName, text: string, takes: string): undefined {
    this.complaints.push(`${name}="${text}" was not understood; it takes ${takes}.`);
    return undefined;
  }
}

/** The fields that there are. */
function present<T extends object>(fields: { readonly [K in keyof T]: T[K] | undefined }): Partial<T> {
  const found: Partial<T> = {};
  for (const key in fields) if (fields[key] !== undefined) found[key] = fields[key];
  return found;
}

function sourceIn(reader: Reader): ElementSource | undefined {
  const address = reader.text('src');
  const columns = reader.list('columns', 1);
  if (address !== undefined) return { kind: 'address', address, ...present({ columns }) };
  const shape = reader.text('shape');
  if (shape === undefined) return undefined;
  const usual = SAMPLES.find((sample) => sample.shape === shape)?.size ?? USUAL_SIZE;
  const size = reader.number('size', 1, true) ?? usual;
  const noise = reader.number('noise', 0, false);
  const seed = reader.number('seed', 0, true);
  return { kind: 'shape', shape, size, ...present({ noise, seed }) };
}

/** What the attributes of the element ask for; where both are given, `src` goes before `shape`. */
export function settingsOf(element: Element): Settings {
  const reader = new Reader(element);
  const source = sourceIn(reader);
  const family = reader.text('family');
  const nu = reader.list('nu', 0);
  const maxSteps = reader.number('steps', 1, true);
  const step = reader.number('step', 1, true);
  const plateau = reader.number('plateau', 1, true);
  const panels = reader.choice('panels', PANELS) ?? DEFAULT_PANELS;
  reader.choice('theme', THEMES);
  return {
    source,
    options: { ...(family !== undefined && named(family) ? { family } : {}), ...present({ nu, maxSteps }) },
    step,
    plateau,
    autoplay: element.hasAttribute('autoplay'),
    panels,
    complaints: reader.complaints,
  };
}
