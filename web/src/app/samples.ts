import type { RunOptions } from '../worker/protocol.ts';

/** The built-in shapes as the visitor chooses them; names and sizes are those of core/cloud/samples.cpp. */
export interface Sample {
  readonly shape: string;
  readonly label: string;
  readonly size: number;
  /** Points of the preview. */
  readonly preview: number;
  readonly provenance: string;
  /** What to look for, in a sentence. */
  readonly lookFor: string;
  /** How it is best looked at; absent: as any points. */
  readonly options?: RunOptions;
}

/** Two that are not computed but measured. */
export const BUNNY = 'bunny';
export const COLORS = 'colors';

/** In more dimensions a few hundred landmarks tell what there is to tell. */
const MANIFOLD: RunOptions = { maxSteps: 400 };

export const SAMPLES: readonly Sample[] = [
  {
    shape: 'helix',
    label: 'Helix on a torus',
    size: 3000,
    preview: 900,
    provenance: 'Guibas and Oudot 2008; 17 turns',
    lookFor: 'Two answers: from afar the ring that the curve winds on, closer by the curve itself.',
  },
  {
    shape: 'torus',
    label: 'Torus',
    size: 5000,
    preview: 900,
    provenance: 'Random by area; radii 1 and 0.4',
    lookFor: 'A ring: one piece, two independent loops and one enclosed space.',
  },
  {
    shape: 'double-torus',
    label: 'Double torus',
    size: 15000,
    preview: 1400,
    provenance: 'Random by area; unlike handles',
    lookFor: 'A ring with a large hole first; closer by, a second, small handle appears: genus 2.',
  },
  {
    shape: 'tanglecube',
    label: 'Tanglecube',
    size: 15000,
    preview: 1600,
    provenance: 'Random by area; an algebraic surface',
    lookFor: 'A cube of tubes with five handles: ten independent loops and one enclosed space.',
  },
  {
    shape: BUNNY,
    label: 'Stanford bunny',
    size: 6000,
    preview: 1800,
    provenance: 'Stanford 3D Scanning Repository; random on its mesh',
    lookFor: 'A scanned body: sphere-like, whatever its ears look like.',
  },
  {
    shape: 'sphere',
    label: 'Sphere',
    size: 3000,
    preview: 700,
    provenance: 'Random by area; radius 1',
    lookFor: 'A closed surface without a handle: one piece and one enclosed space.',
  },
  {
    shape: 'trefoil',
    label: 'Trefoil knot',
    size: 3000,
    preview: 700,
    provenance: 'Even along its parameter',
    lookFor: 'A knotted loop: knotted or not, it is one piece with one loop.',
  },
  {
    shape: 'swiss-roll',
    label: 'Swiss roll',
    size: 5000,
    preview: 1400,
    provenance: 'Random by area; one and a half turns',
    lookFor: 'From afar a solid roll; a sheet with a border encloses nothing, so no closed surface is left.',
  },
  {
    shape: 'circle-noise',
    label: 'Noisy circle',
    size: 1000,
    preview: 300,
    provenance: 'Random; radius 1, noise 0.05',
    lookFor: 'One loop, seen through noise, until the noise itself shows.',
  },
  {
    shape: 'nested-circles',
    label: 'Nested circles',
    size: 1000,
    preview: 240,
    provenance: 'Even, a little shaken; radii 1 and 0.4',
    lookFor: 'Two loops, one inside the other: two pieces and two loops.',
  },
  {
    shape: 'corner-curve',
    label: 'Curve with corners',
    size: 1000,
    preview: 240,
    provenance: 'Even, a little shaken; a five-pointed star',
    lookFor: 'One loop with sharp corners: one piece and one loop all the same.',
  },
  {
    shape: 'mobius',
    label: 'Möbius band',
    size: 15000,
    preview: 1200,
    provenance: 'Even by area; a surface with a border',
    lookFor: 'A band with half a turn: one piece and one loop. No closed surface would show it.',
    options: { family: 'dilated', ...MANIFOLD },
  },
  {
    shape: 'hemisphere',
    label: 'Hemisphere',
    size: 15000,
    preview: 900,
    provenance: 'Even by area; a surface with a border',
    lookFor: 'A bowl: one piece that has neither a loop nor a void, for its rim is open.',
    options: { family: 'dilated', ...MANIFOLD },
  },
  {
    shape: 'clifford',
    label: 'Clifford torus',
    size: 20000,
    preview: 1200,
    provenance: 'Random by area; in four dimensions',
    lookFor: 'A flat torus that fits into no space of three dimensions: two loops and one enclosed space.',
    options: MANIFOLD,
  },
  {
    shape: 'klein',
    label: 'Klein bottle',
    size: 20000,
    preview: 1200,
    provenance: 'Random; in four dimensions',
    lookFor: 'Over Z/2 the numbers of a torus, over Z/3 not: torsion tells them apart.',
    options: MANIFOLD,
  },
  {
    shape: 'rp2',
    label: 'Projective plane',
    size: 20000,
    preview: 1200,
    provenance: 'Random; in four dimensions',
    lookFor: 'A loop and a void over Z/2, neither over Z/3: it turns over on its way around.',
    options: MANIFOLD,
  },
  {
    shape: 's3',
    label: 'Three-sphere',
    size: 20000,
    preview: 1200,
    provenance: 'Random; in four dimensions',
    lookFor: 'No loop and no void, but what encloses four dimensions: β₃ is 1.',
    options: MANIFOLD,
  },
  {
    shape: 's2xs1',
    label: 'Sphere times circle',
    size: 30000,
    preview: 1600,
    provenance: 'Random; in five dimensions',
    lookFor: 'A sphere at every point of a circle: a loop, a void, and what both span, β₃.',
    options: MANIFOLD,
  },
  {
    shape: 'two-scales',
    label: 'Circle and torus',
    size: 20000,
    preview: 1600,
    provenance: 'Random; in four dimensions',
    lookFor: 'Two answers: from afar a circle, closer by the torus that winds along it.',
    options: MANIFOLD,
  },
  {
    shape: COLORS,
    label: 'Named hues',
    size: 652,
    preview: 652,
    provenance: 'The xkcd survey; differences by CIEDE2000, no coordinates',
    lookFor:
      'The circle of hues, from differences alone: one piece and one loop while ε is between 18 and 8.',
    // Smaller differences than 1 nobody sees.
    options: { metric: 'matrix', nu: [1, 5, 6, 6], untilEpsilon: 1 },
  },
];

/** The shapes that the module computes: all but the measured ones. */
export const COMPUTED_SAMPLES = SAMPLES.filter(({ shape }) => shape !== BUNNY && shape !== COLORS);
