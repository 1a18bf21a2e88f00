import bunny from 'bunny';

type Triple = readonly [number, number, number];

/** Mulberry32: small, seeded, and the same everywhere. */
function randomUnit(seed: number): () => number {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

function area(p: Triple, q: Triple, r: Triple): number {
  const [a, b, c] = [q[0] - p[0], q[1] - p[1], q[2] - p[2]];
  const [d, e, f] = [r[0] - p[0], r[1] - p[1], r[2] - p[2]];
  const [x, y, z] = [b * f - c * e, c * d - a * f, a * e - b * d];
  return Math.sqrt(x * x + y * y + z * z) / 2;
}

/** A point of the unit ball, by rejection from the cube. */
function inBall(random: () => number): Triple {
  for (;;) {
    const x = 2 * random() - 1;
    const y = 2 * random() - 1;
    const z = 2 * random() - 1;
    if (x * x + y * y + z * z <= 1) return [x, y, z];
  }
}

/** A point of the triangle, uniform by area. */
function inTriangle(p: Triple, q: Triple, r: Triple, random: () => number): Triple {
  let [s, t] = [random(), random()];
  if (s + t > 1) [s, t] = [1 - s, 1 - t];
  const along = (axis: 0 | 1 | 2): number => p[axis] + s * (q[axis] - p[axis]) + t * (r[axis] - p[axis]);
  // Upright, as the page looks at things: the mesh has its height along y.
  return [along(0), -along(2), along(1)];
}

/** Points of the Stanford bunny as the text of an .xyz file, uniform by area; noise is the radius of a ball. */
export function bunnyText(size: number, noise: number, seed = 1): string {
  const origin: Triple = [0, 0, 0];
  const corner = (vertex: number): Triple => bunny.positions[vertex] ?? origin;
  const triangles = bunny.cells.map(([p, q, r]) => [corner(p), corner(q), corner(r)] as const);
  let whole = 0;
  const areas = triangles.map(([p, q, r]) => (whole += area(p, q, r)));
  const random = randomUnit(seed);
  const randomOffset = randomUnit(~seed);
  const lines: string[] = [];
  for (let i = 0; i < size; ++i) {
    const target = random() * whole;
    let [low, high] = [0, areas.length - 1];
    while (low < high) {
      const middle = (low + high) >> 1;
      if ((areas[middle] ?? 0) < target) low = middle + 1;
      else high = middle;
    }
    const [p, q, r] = triangles[low] ?? [origin, origin, origin];
    const point = inTriangle(p, q, r, random);
    const offset = noise > 0 ? inBall(randomOffset) : origin;
    lines.push(point.map((x, axis) => x + noise * (offset[axis] ?? 0)).join(' '));
  }
  return lines.join('\n') + '\n';
}
