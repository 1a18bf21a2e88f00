import type { CloudFrame } from './protocol.ts';

/** Points in a row of the texture: as wide as every WebGL 2 allows; the shaders know it. */
export const FRAME_WIDTH = 2048;
/** Each face of a cube around the cloud is divided into so many by so many windows. */
const WINDOWS = 32;

interface Box {
  readonly center: readonly [number, number, number];
  readonly extent: number;
}

function boxOf(coordinates: Float64Array, dimension: number): Box {
  const axes = Math.min(dimension, 3);
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let axis = 0; axis < axes; ++axis) {
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
  const middle = (axis: number): number => (axis < axes ? (low[axis] ?? 0) / 2 + (high[axis] ?? 0) / 2 : 0);
  let extent = 0;
  for (let axis = 0; axis < axes; ++axis) extent = Math.max(extent, (high[axis] ?? 0) - (low[axis] ?? 0));
  return { center: [middle(0), middle(1), middle(2)], extent: extent || 1 };
}

/** The window of the cube through which a point is seen from the center. */
function windowOf(x: number, y: number, z: number): number {
  const [ax, ay, az] = [Math.abs(x), Math.abs(y), Math.abs(z)];
  const most = Math.max(ax, ay, az);
  if (most === 0) return 0;
  const place = (value: number): number =>
    Math.min(WINDOWS - 1, Math.floor(((value / most + 1) / 2) * WINDOWS));
  const [face, u, v] =
    most === ax ? [x > 0 ? 0 : 1, y, z] : most === ay ? [y > 0 ? 2 : 3, x, z] : [z > 0 ? 4 : 5, x, y];
  return (face * WINDOWS + place(u)) * WINDOWS + place(v);
}

/** Through each window only the farthest point counts. */
function outlineOf(positions: Float32Array, count: number): Float32Array {
  const farthest = new Int32Array(6 * WINDOWS * WINDOWS).fill(-1);
  const radius = new Float64Array(farthest.length).fill(-1);
  for (let i = 0; i < count; ++i) {
    const [x = 0, y = 0, z = 0] = [positions[4 * i], positions[4 * i + 1], positions[4 * i + 2]];
    const window = windowOf(x, y, z);
    const away = x * x + y * y + z * z;
    if (away <= (radius[window] ?? 0)) continue;
    radius[window] = away;
    farthest[window] = i;
  }
  const kept = farthest.filter((point) => point >= 0);
  const outline = new Float32Array(3 * kept.length);
  kept.forEach((point, i) => outline.set(positions.subarray(4 * point, 4 * point + 3), 3 * i));
  return outline;
}

/**
 * n rows of coordinates as the page draws them: the first three, or no points where there are only distances. Here,
 * because a million of them would make the page wait.
 */
export function frameOf(coordinates: Float64Array, dimension: number): CloudFrame {
  const count = dimension === 0 ? 0 : coordinates.length / dimension;
  const axes = Math.min(dimension, 3);
  const { center, extent } = boxOf(coordinates, dimension);
  const positions = new Float32Array(FRAME_WIDTH * Math.max(1, Math.ceil(count / FRAME_WIDTH)) * 4);
  let farthest = 0;
  for (let point = 0; point < count; ++point) {
    let sum = 0;
    for (let axis = 0; axis < axes; ++axis) {
      const value = ((coordinates[point * dimension + axis] ?? 0) - (center[axis] ?? 0)) / extent;
      positions[4 * point + axis] = value;
      sum += value * value;
    }
    if (sum > farthest) farthest = sum;
  }
  const radius = Math.sqrt(farthest) || 1;
  for (let i = 0; i < 4 * count; ++i) positions[i] = (positions[i] ?? 0) / radius;
  return { scale: 1 / (extent * radius), count, positions, outline: outlineOf(positions, count) };
}
