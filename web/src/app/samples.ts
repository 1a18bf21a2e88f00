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
}

/** The one shape that is not computed but measured. */
export const BUNNY = 'bunny';

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
];

/** The shapes that the module computes: all but the measured one. */
export const COMPUTED_SAMPLES = SAMPLES.filter(({ shape }) => shape !== BUNNY);
