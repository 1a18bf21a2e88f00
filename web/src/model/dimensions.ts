/** As many axes as the core projects onto. */
export const MOST_AXES = 8;

/** Which axes of the projection point right, up and towards the eye; 0-based. */
export type AxisChoice = readonly [number, number, number];
export const FIRST_AXES: AxisChoice = [0, 1, 2];

/** How fast the hidden axes turn into sight, compared with the first: in no ratio, so that no picture comes again soon. */
const SPEEDS = [1, 0.7639, 0.5557, 0.4271, 0.3263];

/**
 * Three rows of MOST_AXES numbers, orthonormal: the directions, in the axes of the projection, that point right, up and
 * towards the eye after each hidden axis has turned into one of the chosen ones by about the angle, in radians.
 */
export function rowsOf(axes: number, choice: AxisChoice, angle: number): Float32Array {
  const rows = new Float64Array(3 * MOST_AXES);
  choice.forEach((axis, row) => (rows[row * MOST_AXES + axis] = 1));
  const hidden = Array.from({ length: axes }, (_, axis) => axis).filter((axis) => !choice.includes(axis));
  hidden.forEach((axis, i) => {
    const shown = choice[i % 3] ?? 0;
    const turn = angle * (SPEEDS[i] ?? 1);
    const [cos, sin] = [Math.cos(turn), Math.sin(turn)];
    for (let row = 0; row < 3; ++row) {
      const a = rows[row * MOST_AXES + shown] ?? 0;
      const b = rows[row * MOST_AXES + axis] ?? 0;
      rows[row * MOST_AXES + shown] = a * cos - b * sin;
      rows[row * MOST_AXES + axis] = a * sin + b * cos;
    }
  });
  return Float32Array.from(rows);
}

/** What the rows keep of the whole spread, from 0 to 1. */
export function keptBy(rows: Float32Array, shares: readonly number[]): number {
  let kept = 0;
  for (const [i, value] of rows.entries()) kept += value * value * (shares[i % MOST_AXES] ?? 0);
  return Math.min(1, kept);
}

/** The choice with one of its axes replaced; what pointed there before takes the other's place. */
export function withAxis(choice: AxisChoice, place: 0 | 1 | 2, axis: number): AxisChoice {
  const swapped = choice[place];
  const next = choice.map((old) => (old === axis ? swapped : old));
  next[place] = axis;
  return [next[0] ?? 0, next[1] ?? 1, next[2] ?? 2];
}
