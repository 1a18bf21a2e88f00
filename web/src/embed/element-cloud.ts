import { measuredShape } from '../app/measured-shapes.ts';
import { BUNNY, COLORS, SAMPLES } from '../app/samples.ts';
import { PlateauError } from '../client/plateau-error.ts';
import { SCAN_POINTS } from '../model/forecast.ts';
import { npyOf } from '../package/cloud.ts';
import { demand, demandIfGiven } from '../package/given.ts';
import type { CloudSource, RunOptions } from '../worker/protocol.ts';
import type { ElementSource } from './settings.ts';

/** Points that were given by a call instead of by attributes. */
export type Given =
  | { readonly kind: 'file'; readonly file: File; readonly columns?: readonly number[] }
  | { readonly kind: 'points'; readonly points: Float64Array; readonly dimension: number };

/** How points are read that a call gives. */
export interface LoadOptions {
  /** Coordinates a point of a Float64Array; 3 unless given. */
  readonly dimension?: number;
  /** Which columns of a table are the coordinates, from 1. */
  readonly columns?: readonly number[];
}

/** What a call gives; with a sentence for what cannot be meant. */
export function givenBy(points: File | Float64Array, options: LoadOptions): Given {
  demand('load', points, 'a File or a Float64Array');
  demand('The second argument of load', options, 'an object');
  const { dimension = 3, columns } = options;
  demand('dimension', dimension, 'a number');
  demandIfGiven('columns', columns, 'a list of numbers');
  return points instanceof Float64Array
    ? { kind: 'points', points, dimension }
    : { kind: 'file', file: points, ...(columns ? { columns } : {}) };
}

/** What an element opens. */
export type Opening = ElementSource | Given;

/** What the points are called. */
export function nameOf(opening: Opening): string {
  switch (opening.kind) {
    case 'shape':
      return opening.shape;
    case 'address':
      return opening.address.replace(/[?#].*$/, '').replace(/^.*\//, '') || opening.address;
    case 'file':
      return opening.file.name;
    case 'points':
      return 'points';
  }
}

/** As on the page: a shape has the settings of the gallery, where none are asked for; a scan ends at its noise. */
export function optionsFor(opening: Opening, options: RunOptions): RunOptions {
  if (opening.kind !== 'shape') return { noiseStopFrom: SCAN_POINTS, ...options };
  return { ...SAMPLES.find(({ shape }) => shape === opening.shape)?.options, ...options };
}

function fileSource(name: string, bytes: ArrayBuffer, columns: readonly number[] | undefined): CloudSource {
  return { kind: 'file', name, bytes, ...(columns ? { columns, anyDimension: true } : {}) };
}

async function fetched(address: string, signal: AbortSignal): Promise<ArrayBuffer> {
  let answer: Response;
  let url: URL;
  try {
    url = new URL(address, document.baseURI);
    answer = await fetch(url, { signal });
  } catch {
    signal.throwIfAborted();
    throw new PlateauError(
      'cannot-read',
      `${address} cannot be read: there is no answer, or its server or the policy of this page does not allow it.`,
    );
  }
  if (!answer.ok)
    throw new PlateauError('cannot-read', `${url.href} cannot be read: it answers ${answer.status}.`);
  return answer.arrayBuffer();
}

/** An element has more shapes than the core, which names only its own. */
export function toldOf(error: unknown, { kind }: Opening): unknown {
  if (kind !== 'shape' || !(error instanceof PlateauError) || !/^There is no shape/.test(error.message))
    return error;
  return new PlateauError(error.code, error.message.replace(/\.$/, `, ${BUNNY}, ${COLORS}.`));
}

/** The points as a run is given them. Points that were given stay as they are: they may be opened again. */
export async function cloudOf(opening: Opening, signal: AbortSignal): Promise<CloudSource> {
  switch (opening.kind) {
    case 'shape':
      return measuredShape(opening) ?? { ...opening, kind: 'sample' };
    case 'address':
      return fileSource(nameOf(opening), await fetched(opening.address, signal), opening.columns);
    case 'points':
      return { kind: 'file', name: 'points.npy', bytes: npyOf(opening), anyDimension: true };
    case 'file':
      try {
        return fileSource(opening.file.name, await opening.file.arrayBuffer(), opening.columns);
      } catch {
        throw new PlateauError(
          'cannot-read',
          `${opening.file.name} cannot be read. It may have been moved, or it is too large for this browser.`,
        );
      }
  }
}
