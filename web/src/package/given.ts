import { PlateauError } from '../client/plateau-error.ts';
import type { RunOptions } from '../worker/protocol.ts';

const LONGEST_TEXT = 40;

/** A value as a sentence names it. */
function named(value: unknown): string {
  if (typeof value === 'string') return value.length > LONGEST_TEXT ? 'text' : `"${value}"`;
  if (value === null || typeof value !== 'object') return String(value);
  return Object.prototype.toString.call(value).slice('[object '.length, -1);
}

function isList(value: unknown): boolean {
  if (!Array.isArray(value) && !ArrayBuffer.isView(value)) return false;
  return Array.from(value as ArrayLike<unknown>).every((entry) => typeof entry === 'number');
}

/** What can be asked for, in the words of a sentence. */
const KINDS = {
  text: (value: unknown) => typeof value === 'string',
  'a number': (value: unknown) => typeof value === 'number',
  'a list of numbers': isList,
  'true or false': (value: unknown) => typeof value === 'boolean',
  'an AbortSignal': (value: unknown) => value instanceof AbortSignal,
  'an object': (value: unknown) => typeof value === 'object' && value !== null,
  'an ArrayBuffer or a Uint8Array': (value: unknown) =>
    value instanceof ArrayBuffer || value instanceof Uint8Array,
  'a File or a Float64Array': (value: unknown) => value instanceof Float64Array || value instanceof File,
  'a Float64Array or a list of points': (value: unknown) =>
    value instanceof Float64Array || Array.isArray(value),
} as const;
type Kind = keyof typeof KINDS;

/** Not every program has types: what cannot be meant is refused here, before it reaches a module that others use, too. */
export function demand(name: string, value: unknown, kind: Kind): void {
  if (KINDS[kind](value)) return;
  throw new PlateauError('invalid-option', `${name} takes ${kind}, not ${named(value)}.`);
}

/** The same for what need not be given. */
export function demandIfGiven(name: string, value: unknown, kind: Kind): void {
  if (value !== undefined) demand(name, value, kind);
}

const OPTIONS: Readonly<Record<keyof RunOptions, Kind>> = {
  family: 'text',
  metric: 'text',
  knn: 'a number',
  box: 'a list of numbers',
  maxDimension: 'a number',
  field: 'a number',
  nu: 'a list of numbers',
  dilation: 'a number',
  pump: 'true or false',
  omegaBar: 'a number',
  zeta2: 'a number',
  sliver: 'text',
  minLength: 'a number',
  first: 'a number',
  maxSteps: 'a number',
  untilEpsilon: 'a number',
  rho: 'a number',
  noiseStopFrom: 'a number',
  memoryLimit: 'a number',
};

/** Whether the values make sense is for the core to say. */
export function demandOptions(options: RunOptions): void {
  const kinds = new Map<string, Kind>(Object.entries(OPTIONS));
  for (const [name, value] of Object.entries(options)) {
    const kind = kinds.get(name);
    if (!kind) throw new PlateauError('invalid-option', `There is no option ${name}.`);
    demandIfGiven(name, value, kind);
  }
}
