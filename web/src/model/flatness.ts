/** Sines below this are rounding: the points were computed or written with 9 digits or more. */
const ROUNDING = 1e-9;

type Triple = readonly [number, number, number];

function cross(a: Triple, b: Triple): Triple {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

function dot(a: Triple, b: Triple): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

function length(a: Triple): number {
  return Math.sqrt(dot(a, a));
}

/** The directions from the first point to the others, one after another; rows of 2 or 3 coordinates. */
function* directions(coordinates: Float64Array, dimension: number): Generator<Triple> {
  const at = (i: number, axis: number): number =>
    axis < dimension ? (coordinates[i + axis] ?? 0) - (coordinates[axis] ?? 0) : 0;
  for (let i = dimension; i < coordinates.length; i += dimension) yield [at(i, 0), at(i, 1), at(i, 2)];
}

/**
 * Do all points lie on one line, or in space in one plane, up to rounding? Ends at the first point that does not, so
 * it is quick for all other clouds.
 */
export function flatness(coordinates: Float64Array, dimension: number): 'line' | 'plane' | undefined {
  let along: Triple | undefined;
  let normal: Triple | undefined;
  for (const direction of directions(coordinates, dimension)) {
    const size = length(direction);
    if (size === 0) continue;
    if (!along) {
      along = direction;
    } else if (!normal) {
      const across = cross(along, direction);
      if (length(across) <= ROUNDING * size * length(along)) continue;
      if (dimension === 2) return undefined;
      normal = across;
    } else if (Math.abs(dot(normal, direction)) > ROUNDING * size * length(normal)) {
      return undefined;
    }
  }
  return normal ? 'plane' : 'line';
}
