/** The built-in shapes as the visitor chooses them; names and sizes are those of core/cloud/samples.cpp. */
export interface Sample {
  readonly shape: string;
  readonly label: string;
  readonly size: number;
}

export const SAMPLES: readonly Sample[] = [
  { shape: 'helix', label: 'Helix on a torus', size: 3000 },
  { shape: 'torus', label: 'Torus', size: 5000 },
  { shape: 'double-torus', label: 'Double torus', size: 15000 },
  { shape: 'tanglecube', label: 'Tanglecube', size: 15000 },
  { shape: 'sphere', label: 'Sphere', size: 3000 },
  { shape: 'trefoil', label: 'Trefoil knot', size: 3000 },
  { shape: 'swiss-roll', label: 'Swiss roll', size: 5000 },
  { shape: 'circle-noise', label: 'Noisy circle', size: 1000 },
  { shape: 'nested-circles', label: 'Nested circles', size: 1000 },
  { shape: 'corner-curve', label: 'Curve with corners', size: 1000 },
];
