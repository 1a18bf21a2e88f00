import { DataTexture, FloatType, NearestFilter, RGBAFormat } from 'three';

/** As wide as every WebGL 2 allows; the shaders know it. */
const TEXTURE_WIDTH = 2048;

/** The cloud moved and scaled into the unit sphere: single precision would lose clouds far from the origin. */
export interface CloudFrame {
  /** Units of the scene for one unit of the input. */
  readonly scale: number;
  readonly count: number;
  /** Four numbers a point. */
  readonly data: Float32Array;
  readonly texture: DataTexture;
}

/** n rows of 2 or 3 coordinates as a texture of positions. */
export function frameCloud(coordinates: Float64Array, dimension: number): CloudFrame {
  const count = coordinates.length / dimension;
  const low = [0, 0, 0];
  const high = [0, 0, 0];
  for (let axis = 0; axis < dimension; ++axis) {
    let least = Infinity;
    let most = -Infinity;
    for (let i = axis; i < coordinates.length; i += dimension) {
      const value = coordinates[i] ?? 0;
      if (value < least) least = value;
      if (value > most) most = value;
    }
    low[axis] = least;
    high[axis] = most;
  }
  const center = low.map((value, axis) => value / 2 + (high[axis] ?? 0) / 2);
  const extent = Math.max(...low.map((value, axis) => (high[axis] ?? 0) - value)) || 1;
  const rows = Math.max(1, Math.ceil(count / TEXTURE_WIDTH));
  const data = new Float32Array(TEXTURE_WIDTH * rows * 4);
  let radius = 0;
  for (let point = 0; point < count; ++point) {
    let sum = 0;
    for (let axis = 0; axis < dimension; ++axis) {
      const value = ((coordinates[point * dimension + axis] ?? 0) - (center[axis] ?? 0)) / extent;
      data[4 * point + axis] = value;
      sum += value * value;
    }
    if (sum > radius) radius = sum;
  }
  radius = Math.sqrt(radius) || 1;
  for (let i = 0; i < 4 * count; ++i) data[i] = (data[i] ?? 0) / radius;
  const texture = new DataTexture(data, TEXTURE_WIDTH, rows, RGBAFormat, FloatType);
  texture.minFilter = texture.magFilter = NearestFilter;
  texture.needsUpdate = true;
  return { scale: 1 / (extent * radius), count, data, texture };
}

type Triple = readonly [number, number, number];

/** From how far along `direction` all points are seen under at most the given slopes across and upright. */
export function distanceFor(
  { data, count }: CloudFrame,
  direction: Triple,
  across: Triple,
  upright: Triple,
  widest: number,
  tallest: number,
): number {
  let distance = 0.5;
  for (let i = 0; i < 4 * count; i += 4) {
    const x = data[i] ?? 0;
    const y = data[i + 1] ?? 0;
    const z = data[i + 2] ?? 0;
    const nearer = x * direction[0] + y * direction[1] + z * direction[2];
    const aside = Math.abs(x * across[0] + y * across[1] + z * across[2]) / widest;
    const above = Math.abs(x * upright[0] + y * upright[1] + z * upright[2]) / tallest;
    const needed = nearer + (aside > above ? aside : above);
    if (needed > distance) distance = needed;
  }
  return distance;
}
