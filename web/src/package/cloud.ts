import { PlateauError } from '../client/plateau-error.ts';
import type { CloudSource } from '../worker/protocol.ts';
import { demand, demandIfGiven } from './given.ts';

/** One of the built-in shapes: `helix`, `torus`, `sphere` and others; an unknown name is answered with all of them. */
export interface ShapeCloud {
  /** By its name. */
  readonly shape: string;
  /** How many points. */
  readonly size: number;
  /** Radius of a ball in which each point is shaken, in units of the shape. */
  readonly noise?: number;
  /** Another seed is another sample of the same shape; 1 unless given. */
  readonly seed?: number;
}

/** Points as numbers. */
export interface PointCloud {
  /** One point after another, or a list of points. They are copied. */
  readonly points: Float64Array | readonly (readonly number[])[];
  /** Coordinates a point; 3 for a Float64Array unless given. */
  readonly dimension?: number;
}

/** A file as it is on disk: .xyz, .txt, .csv, .ply, .off, .obj, .pcd, .npy, or a session, .plateau. */
export interface FileCloud {
  /** Says by its ending what kind of file it is. */
  readonly name: string;
  /** They are copied. */
  readonly bytes: ArrayBuffer | Uint8Array;
  /** Which columns of a table are the coordinates, from 1; a table of more than three columns needs them. */
  readonly columns?: readonly number[];
}

/** Where the points come from. */
export type Cloud = ShapeCloud | PointCloud | FileCloud;

function flattened({ points, dimension }: PointCloud): { values: Float64Array; dimension: number } {
  demand('points', points, 'a Float64Array or a list of points');
  if (points instanceof Float64Array) return { values: points, dimension: dimension ?? 3 };
  points.forEach((point, i) => demand(`Point ${i}`, point, 'a list of numbers'));
  const width = dimension ?? points[0]?.length ?? 0;
  const ragged = points.findIndex((point) => point.length !== width);
  if (ragged >= 0)
    throw new PlateauError(
      'ragged-rows',
      `Point ${ragged} has ${points[ragged]?.length ?? 0} coordinates, not ${width}.`,
    );
  return { values: Float64Array.from(points.flat()), dimension: width };
}

const MAGIC = '\x93NUMPY\x01\x00';
/** What stands before the numbers is filled up to a multiple of this. */
const ALIGNMENT = 64;

/** Every bit of the numbers as they are: the form in which NumPy writes an array to a file. */
export function npyOf(cloud: PointCloud): ArrayBuffer {
  const { values, dimension } = flattened(cloud);
  if (!Number.isInteger(dimension) || dimension < 1 || values.length % dimension !== 0)
    throw new PlateauError(
      'ragged-rows',
      `${values.length} numbers are no points of ${dimension} coordinates each.`,
    );
  const shape = `(${values.length / dimension}, ${dimension})`;
  const about = `{'descr': '<f8', 'fortran_order': False, 'shape': ${shape}, }`;
  const before = MAGIC.length + 2;
  const length = Math.ceil((before + about.length + 1) / ALIGNMENT) * ALIGNMENT - before;
  const bytes = new Uint8Array(before + length + 8 * values.length);
  const write = (text: string, at: number): void =>
    [...text].forEach((sign, i) => (bytes[at + i] = sign.charCodeAt(0)));
  write(MAGIC, 0);
  const view = new DataView(bytes.buffer);
  view.setUint16(MAGIC.length, length, true);
  write(about.padEnd(length - 1) + '\n', before);
  values.forEach((value, i) => view.setFloat64(before + length + 8 * i, value, true));
  return bytes.buffer;
}

/** The cloud as the core is given it; with a sentence for what is none. */
export function sourceOf(cloud: Cloud): CloudSource {
  demand('A cloud', cloud, 'an object');
  if ('shape' in cloud) {
    const { shape, size, noise, seed } = cloud;
    demand('shape', shape, 'text');
    demand('size', size, 'a number');
    demandIfGiven('noise', noise, 'a number');
    demandIfGiven('seed', seed, 'a number');
    return { kind: 'sample', ...cloud };
  }
  if ('points' in cloud) return { kind: 'file', name: 'points.npy', bytes: npyOf(cloud), anyDimension: true };
  if (!('bytes' in cloud))
    throw new PlateauError('invalid-option', 'A cloud has a shape, or points, or a name and bytes.');
  const { name, bytes, columns } = cloud;
  demand('name', name, 'text');
  demand('bytes', bytes, 'an ArrayBuffer or a Uint8Array');
  demandIfGiven('columns', columns, 'a list of numbers');
  const copy = bytes instanceof ArrayBuffer ? bytes.slice(0) : new Uint8Array(bytes).buffer;
  return { kind: 'file', name, bytes: copy, ...(columns ? { columns, anyDimension: true } : {}) };
}
