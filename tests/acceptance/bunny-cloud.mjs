// The Stanford bunny (Stanford 3D Scanning Repository; npm package `bunny`, closed, 1,839 vertices): points drawn
// uniformly from its faces.
import bunny from 'bunny';

const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/** Mulberry32: small, seeded, and the same everywhere. */
function randomUnit(seed) {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

const corners = bunny.cells.map((cell) => cell.map((vertex) => bunny.positions[vertex]));

/** Volume that the mesh encloses, in input units cubed. */
export const bunnyVolume = corners.reduce((sum, [p, q, r]) => sum + dot(p, cross(q, r)) / 6, 0);

/** n points, uniform by area. */
export function bunnyPoints(n, seed = 1) {
  const random = randomUnit(seed);
  let area = 0;
  const areas = corners.map(([p, q, r]) => (area += Math.hypot(...cross(minus(q, p), minus(r, p))) / 2));
  return Array.from({ length: n }, () => {
    const target = random() * area;
    let [low, high] = [0, areas.length - 1];
    while (low < high) {
      const middle = (low + high) >> 1;
      if (areas[middle] < target) low = middle + 1;
      else high = middle;
    }
    const [p, q, r] = corners[low];
    let [s, t] = [random(), random()];
    if (s + t > 1) [s, t] = [1 - s, 1 - t];
    return p.map((x, i) => x + s * (q[i] - x) + t * (r[i] - x));
  });
}

export const asText = (points) => points.map((p) => p.join(' ') + '\n').join('');
