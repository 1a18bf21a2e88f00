// What is measured, and what it should reach. A row is { runner, cloud, points, what }.

/** T_D, CGAL alone inserting the same landmarks in the same order with the same hints: what the rest is divided by. */
export const BASE = 'T_D';
export const families = ['delaunay', 'surface', 'auto', 'witness'];
const parts = ['lists', 'lists+D', 'lists+D+complex'];
const clouds = ['torus', 'cube'];
const modularSizes = [10_000, 100_000];

export const smallSizes = [1_000, 10_000];
export const fullSizes = [...smallSizes, 100_000, 1_000_000];

/** How often a row of this size runs at most; its median counts. What is short is noisy. */
export const mostRounds = (points) => (points <= 1_000 ? 9 : 3);
/** A row that has taken so many seconds is not repeated. */
export const ENOUGH_SECONDS = 20;

/** A million points: only what a target or the chart asks for. */
const millionRows = {
  torus: [BASE, 'delaunay', 'surface', 'witness'],
  cube: [BASE, 'delaunay'],
};

function nativeRows(cloud, points) {
  if (points > 100_000) return millionRows[cloud];
  return [BASE, ...(points >= 10_000 ? parts : []), ...families];
}

/** Rows in groups: those of a group run in turn, so that they are alike in what else the machine does. */
export function groupsOf(sizes) {
  // A short run tells the module's ratio by the torus alone.
  const long = sizes.includes(100_000);
  return sizes.flatMap((points) =>
    clouds.map((cloud) => {
      const native = nativeRows(cloud, points).map((what) => ({ runner: 'native', cloud, points, what }));
      const modular = modularSizes.includes(points) && (long || cloud === 'torus') ? families : [];
      return [...native, ...modular.map((what) => ({ runner: 'module', cloud, points, what }))];
    }),
  );
}

/** The rebuild is sampled; more points would take minutes for a single sample. */
export function rebuildsOf(sizes) {
  const points = Math.max(...sizes.filter((size) => size <= 10_000));
  if (!Number.isFinite(points)) return [];
  return ['witness', 'delaunay'].map((what) => ({ runner: 'rebuild', cloud: 'torus', points, what }));
}

const manyParts =
  'D(L) with its plain mirror and the complex are paid before any number is counted (the rows of parts); what is left is spread over many small searches, none of which stands out in a profile.';
const doubling = 'Arrays double when they are full: a peak depends on where the last doubling fell.';
const lists =
  'Lists and simplices are most of it, and they wait for memory: neighbors in space lie far apart by their steps.';

/** `reach` and `then`: at most so much; `why` is printed where `reach` is missed. */
export const targets = [
  ...[10_000, 100_000].flatMap((points) => [
    { cloud: 'torus', what: 'delaunay', points, unit: 'T_D', reach: 1.8, then: 1.3, why: manyParts },
    { cloud: 'cube', what: 'delaunay', points, unit: 'T_D', reach: 3.5, then: 2, why: manyParts },
    { cloud: 'torus', what: 'surface', points, unit: 'T_D', reach: 3, then: 2, why: manyParts },
  ]),
  { cloud: 'torus', what: 'witness', points: 1_000_000, unit: 's', reach: 60, then: 25, why: lists },
  { cloud: 'torus', what: 'witness', points: 1_000_000, unit: 'MB', reach: 1500, why: lists },
  { cloud: 'torus', what: 'delaunay', points: 1_000_000, unit: 's', reach: 90, then: 45, why: manyParts },
  { cloud: 'cube', what: 'delaunay', points: 1_000_000, unit: 's', reach: 90, then: 45, why: manyParts },
];

/** From ten times fewer points, as factors. Five percent are the noise of the clock. */
export const growthReach = (what) => ({
  reach: 1.05,
  why:
    what === 'witness'
      ? lists
      : 'Not profiled; presumably what fits into the caches with 10,000 points no longer does.',
});
export const memoryReach = { reach: 10.5, why: doubling };
export const moduleReach = {
  reach: 1.6,
  then: 1.3,
  why:
    'A module that was just loaded runs on code that is compiled in haste, until the better one is ready: that is most of a ' +
    'short run. A second run in the same module was seen to take 1.1 to 1.5 times the processor time of the native one.',
};
/** At least so many times faster. */
export const rebuildReach = {
  reach: 3_000,
  then: 10_000,
  why: 'The whole run is slower than its own targets above, or the rebuild of this family needs no triangulation.',
};
