import type { CloudFrame, Projection } from './protocol.ts';

/** Points in a row of the texture: as wide as every WebGL 2 allows; the shaders know it. */
export const FRAME_WIDTH = 2048;
/** Each face of a cube around the cloud is divided into so many by so many windows. */
const WINDOWS = 32;

type Coordinates = Float64Array | Float32Array;

interface Box {
  readonly center: readonly number[];
  readonly extent: number;
}

function boxOf(coordinates: Coordinates, dimension: number): Box {
  const low: number[] = [];
  const high: number[] = [];
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
  const center = low.map((least, axis) => least / 2 + (high[axis] ?? 0) / 2);
  const extent = Math.max(0, ...low.map((least, axis) => (high[axis] ?? 0) - least));
  return { center, extent: extent || 1 };
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

/** Poles of the unit sphere: a cloud of more than three dimensions may turn anything towards the eye. */
const ALL_AROUND = Float32Array.of(1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1);

/** What is drawn: n rows of coordinates along up to 8 axes; `shares` where they are those of a projection. */
export type Drawn = Omit<Projection, 'coordinates'> & { readonly coordinates: Coordinates };

/** The points as the page draws them. Here, because a million of them would make the page wait. */
export function frameOf(count: number, { axes, coordinates, shares }: Drawn): CloudFrame {
  const { center, extent } = boxOf(coordinates, axes);
  const texels = FRAME_WIDTH * Math.max(1, Math.ceil(count / FRAME_WIDTH)) * 4;
  const positions = new Float32Array(texels);
  const beyond = new Float32Array(axes > 4 ? texels : 0);
  let farthest = 0;
  for (let point = 0; point < count; ++point) {
    let sum = 0;
    for (let axis = 0; axis < axes; ++axis) {
      const value = ((coordinates[point * axes + axis] ?? 0) - (center[axis] ?? 0)) / extent;
      if (axis < 4) positions[4 * point + axis] = value;
      else beyond[4 * point + axis - 4] = value;
      sum += value * value;
    }
    if (sum > farthest) farthest = sum;
  }
  const radius = Math.sqrt(farthest) || 1;
  for (const words of [positions, beyond])
    for (let i = 0; i < words.length; ++i) words[i] = (words[i] ?? 0) / radius;
  const outline = axes > 3 ? ALL_AROUND.slice() : outlineOf(positions, count);
  return { scale: 1 / (extent * radius), count, axes, shares, positions, beyond, outline };
}
