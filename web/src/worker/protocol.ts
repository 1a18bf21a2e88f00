/**
 * Messages between the page and the worker. Types only: this file compiles to nothing.
 * Every message carries the run it belongs to; every request that has a `requestId` is answered by exactly one event
 * with the same id (its answer or `failed`).
 */

import type { Inspection, PlanePicture, PlaneScene, PlaneView } from './inspection.ts';

export type Family = 'witness' | 'delaunay' | 'surface' | 'auto' | 'dilated';
/** Which complex a step shows; never `auto`. */
export type ShownFamily = 'witness' | 'delaunay' | 'surface' | 'dilated';

/** How far two points are from each other; all but `euclidean` are for family `witness`. */
export type Metric =
  | 'euclidean'
  | 'l1'
  | 'linf'
  | 'angular'
  | 'projective'
  | 'periodic'
  | 'geodesic'
  /** The file is a distance matrix. */
  | 'matrix';

export interface RunOptions {
  /** Which complex is followed; absent: as the points need it. */
  readonly family?: Family;
  /** How far two points are from each other; absent: `euclidean`. */
  readonly metric?: Metric;
  /** Metric `geodesic`: to how many nearest others every point is joined. */
  readonly knn?: number;
  /** Metric `periodic`: the period of every axis, or one for all; 0: none. Absent: the unit box. */
  readonly box?: readonly number[];
  /** Family `witness`: the last Betti number, at most 6. */
  readonly maxDimension?: number;
  /** Families `witness` and `dilated`: Betti numbers over Z/p for this prime p. */
  readonly field?: number;
  /** ν of the witness complex, an entry a dimension; absent: as the family needs it. */
  readonly nu?: readonly number[];
  /** Family `dilated`: radius of the witnesses as a part of epsilon; absent: 0.2. */
  readonly dilation?: number;
  /** Family `dilated`: weights are chosen so that flat simplices stay out; absent: weights 0. */
  readonly pump?: boolean;
  /** Pumping: the largest weight as a part of the distance to the nearest landmark; absent: 0.25. */
  readonly omegaBar?: number;
  /** Pumping: radius of the witnesses as a part of epsilon; absent: that of the theory. */
  readonly zeta2?: number;
  /** Pumping: how flat a simplex is. */
  readonly sliver?: 'literal' | 'normalized';
  /** Stop where a plateau becomes this long: the natural logarithm of the ratio of its ε; 0 = off. */
  readonly minLength?: number;
  /** 0-based input index of the first landmark. */
  readonly first?: number;
  /** How many landmarks at most; absent: all points. */
  readonly maxSteps?: number;
  /** Stop after the first step with epsilon at most this, in input units. */
  readonly untilEpsilon?: number;
  /** Drop triangles with a radius-edge ratio above this; 0 = off. */
  readonly rho?: number;
  /** A cloud of at least this many points ends where epsilon falls to its noise; absent: never. */
  readonly noiseStopFrom?: number;
  /** Bytes that the run may take, if that is less than the module allows. */
  readonly memoryLimit?: number;
}

export type CloudSource =
  | {
      readonly kind: 'file';
      readonly name: string;
      readonly bytes: ArrayBuffer;
      /** 1-based columns that are coordinates; absent: as the reader decides. */
      readonly columns?: readonly number[];
      /** A table of more than three columns is taken as a whole; absent: it asks which are meant. */
      readonly anyDimension?: boolean;
      /** A session file is run with the options of the request; absent: with its own, all but the memory. */
      readonly newOptions?: boolean;
    }
  | {
      readonly kind: 'sample';
      readonly shape: string;
      readonly size: number;
      readonly noise?: number;
      readonly seed?: number;
    };

/** From C++: the code's name and number are those of core/base/result.h; the message is for people. */
export interface Failure {
  readonly code: number;
  readonly message: string;
}

export type ExportFormat =
  /** A line a step. */
  | 'betti-csv'
  /** The plateaus in the order of their steps. */
  | 'plateaus-json'
  /** What a step shows: the closed surface, else landmarks with edges and triangles. */
  | 'mesh-ply'
  /** The same as OFF. */
  | 'mesh-off'
  /** The same as binary glTF. */
  | 'mesh-glb'
  /** The complex with edges, triangles and tetrahedra; of every run. */
  | 'complex-vtk'
  /** The surface in numbers, JSON; of families `auto` and `surface`. */
  | 'surface-report'
  /** A file that opens as this run. */
  | 'session';

/** For the worker of the package, before anything else: the program that it runs, compiled once for all workers. */
export interface LoadModule {
  readonly kind: 'loadModule';
  readonly compiled: WebAssembly.Module;
}

export type WorkerRequest =
  /** Reads the source, starts the run, and computes on until `pause`, `close` or the end. */
  | {
      readonly kind: 'open';
      readonly runId: number;
      readonly requestId: number;
      readonly source: CloudSource;
      readonly options: RunOptions;
    }
  | { readonly kind: 'pause'; readonly runId: number; readonly requestId: number }
  | { readonly kind: 'resume'; readonly runId: number; readonly requestId: number }
  /** Lifts the stop at the noise: a run that ended there goes on. */
  | { readonly kind: 'runPastNoise'; readonly runId: number; readonly requestId: number }
  /** A run that ended at a plateau goes on to the next one that is long enough, or to its end. */
  | { readonly kind: 'runToNextPlateau'; readonly runId: number; readonly requestId: number }
  /** What was appended since the last answer; pulled by the page, at most one under way. */
  | { readonly kind: 'fetchDelta'; readonly runId: number; readonly requestId: number }
  | { readonly kind: 'fetchPlateaus'; readonly runId: number; readonly requestId: number }
  /**
   * `step` is 1-based and for mesh, complex, report and session; absent: the middle of the longest plateau. `view` is
   * for the session: text that comes back as it is when the file is opened.
   */
  | {
      readonly kind: 'export';
      readonly runId: number;
      readonly requestId: number;
      readonly format: ExportFormat;
      readonly step?: number;
      readonly view?: string;
    }
  /** Why the simplex of these landmarks (steps) is there at the step, or why not. */
  | {
      readonly kind: 'inspect';
      readonly runId: number;
      readonly requestId: number;
      readonly step: number;
      readonly vertices: readonly number[];
    }
  /** Of no run: 0. */
  | { readonly kind: 'drawPlane'; readonly runId: 0; readonly requestId: number; readonly view: PlaneView }
  /** `vertices`: places in the array of landmarks. */
  | {
      readonly kind: 'inspectPlane';
      readonly runId: 0;
      readonly requestId: number;
      readonly scene: PlaneScene;
      readonly vertices: readonly number[];
    }
  | { readonly kind: 'close'; readonly runId: number; readonly requestId: number };

export type RunState = 'preparing' | 'running' | 'finished' | 'stopped';

/** Coordinates for the eye alone. */
export interface Projection {
  /** At most 8; fewer, even none, where the cloud spreads in fewer directions. */
  readonly axes: number;
  /** n rows of `axes` numbers, input units. */
  readonly coordinates: Float32Array;
  /** One an axis, falling: what it keeps of the whole spread, 0 to 1. */
  readonly shares: readonly number[];
}

/** What a session file says of its run. */
export interface SavedSession {
  /** The step that was shown; 0: none. */
  readonly step: number;
  /** Steps that were complete when it was saved, and their hash: see Delta.agreesWithSession. */
  readonly reached: number;
  readonly hash: string;
  /** What the page gave when it was saved; empty if nothing. From a file: it may be anything. */
  readonly view: string;
  /** With which the run was opened. */
  readonly options: RunOptions;
}

/** What the module says of a run that it has opened. */
export interface OpenedRun {
  /** n */
  readonly points: number;
  /** Coordinates a point; 0 where there are only distances. */
  readonly dimension: number;
  /** Betti numbers a step. */
  readonly bettiCount: number;
  /** They are over Z/field. */
  readonly field: number;
  /** The prime of `otherBetti`; 0: the complex is embedded, there is no torsion. */
  readonly otherField: number;
  readonly metric: Metric;
  /** n rows of `dimension` numbers, input units. */
  readonly coordinates: Float64Array;
  /** What to draw where there are not 2 or 3 coordinates. */
  readonly projection?: Projection;
  readonly family: Family;
  readonly nu: readonly number[];
  readonly stepsPlanned: number;
  /** The length of a plateau at which it stops; 0: at none. */
  readonly minLength: number;
  /** What all planned steps are expected to take, and what the run may take. */
  readonly estimatedBytes: number;
  readonly memoryLimitBytes: number;
  /** How many of the planned steps are expected to fit into the memory. */
  readonly stepsAffordable: number;
  /** Readable remarks of the reader, e.g. "took columns 1-3 of 6". */
  readonly warnings: readonly string[];
  /** When the source is a session file whose options were taken. */
  readonly session?: SavedSession;
}

/** The cloud moved and scaled into the unit sphere, for single precision, which would lose clouds far from the origin. */
export interface CloudFrame {
  /** Units of the frame for one unit of the input. */
  readonly scale: number;
  readonly count: number;
  /** 2 or 3: the coordinates of the input; else those of a projection, up to 8. */
  readonly axes: number;
  /** Of a projection, one an axis: what it keeps of the whole spread, 0 to 1; else empty. */
  readonly shares: readonly number[];
  /** The first four numbers of each point, filled up to whole rows of FRAME_WIDTH points: a texture as it is. */
  readonly positions: Float32Array;
  /** The other four, or nothing where there are none. */
  readonly beyond: Float32Array;
  /** Points, three numbers each, that stand out so far that what shows them shows all. */
  readonly outline: Float32Array;
}

export interface Opened extends OpenedRun {
  readonly frame: CloudFrame;
}

/** What one or more steps appended. Steps and the vertices of simplices are 1-based; indices into tables 0-based. */
export interface Delta {
  readonly state: RunState;
  /** Why the run stopped early, when state is `stopped`. */
  readonly stopped?: Failure;
  readonly firstStep: number;
  readonly stepCount: number;
  /** 64-bit hash of all complete steps, 16 hex digits. */
  readonly hash: string;
  /** Of a session file, once its steps are computed again: whether they have the hash that it says. */
  readonly agreesWithSession?: boolean;
  /** What the run holds now, also for steps that later deltas tell. */
  readonly memoryBytes: number;
  /** Where the run ends by itself: the median distance of a point to its nearest other one. 0: nowhere, or not known yet. */
  readonly noise: number;
  /** Finished because epsilon fell to the noise. */
  readonly endedAtNoise: boolean;
  /** Finished because a plateau has become as long as was asked for. */
  readonly endedAtPlateau: boolean;
  /** One entry a new step. */
  readonly landmark: Uint32Array;
  readonly epsilon: Float64Array;
  /** 0 witness, 1 delaunay, 2 surface, 4 dilated. */
  readonly shownFamily: Uint8Array;
  /** `bettiCount` numbers a new step. */
  readonly betti: Uint32Array;
  /** The same over Z/otherField; where they differ there is torsion. Empty where there can be none. */
  readonly otherBetti: Uint32Array;
  /**
   * Where landmarks are pumped, of each new one: the square of its weight, the smallest sliver measure around it
   * before (without a weight) and after, the relative amplitude of all weights at its step, and how many thresholds
   * were found. Else empty.
   */
  readonly pumps: Float64Array;
  /** Two vertices (steps, ascending) an edge; the birth is the last vertex. */
  readonly edges: Uint32Array;
  /** Death in track 0 and track 1 of the new edges, 0xFFFFFFFF while alive at stepCount; track 1 is empty unless family is auto. */
  readonly edgeDeath: readonly [Uint32Array, Uint32Array];
  readonly triangles: Uint32Array;
  readonly triangleDeath: readonly [Uint32Array, Uint32Array];
  /** Deaths of older edges and triangles: (dimension, track, index, step) each. */
  readonly deaths: Uint32Array;
  /** New surface rows: three vertices (steps), counter-clockwise from outside; from; to (0xFFFFFFFF while alive). */
  readonly rowVertices: Uint32Array;
  readonly rowFrom: Uint32Array;
  readonly rowTo: Uint32Array;
  /** Ends of older rows: (row index, to) each. */
  readonly endedRows: Uint32Array;
}

/** Plateaus so far, in step order. */
export interface Plateaus {
  readonly firstStep: Uint32Array;
  readonly lastStep: Uint32Array;
  readonly middleStep: Uint32Array;
  readonly epsilonFirst: Float64Array;
  readonly epsilonLast: Float64Array;
  /** epsilon+(first) / epsilon+(last + 1). */
  readonly ratio: Float64Array;
  readonly family: Uint8Array;
  /** `bettiCount` numbers a plateau. */
  readonly betti: Uint32Array;
  /** As many: over Z/otherField where those that last longest in the plateau are others; else zeros. */
  readonly torsion: Uint32Array;
  /** Indices into the arrays above, longest first. */
  readonly ranked: Uint32Array;
}

export type WorkerEvent =
  /** The module is loaded; runId 0. */
  | { readonly kind: 'ready'; readonly runId: 0 }
  | { readonly kind: 'opened'; readonly runId: number; readonly requestId: number; readonly opened: Opened }
  | { readonly kind: 'paused'; readonly runId: number; readonly requestId: number }
  | { readonly kind: 'resumed'; readonly runId: number; readonly requestId: number }
  | { readonly kind: 'lifted'; readonly runId: number; readonly requestId: number }
  | { readonly kind: 'delta'; readonly runId: number; readonly requestId: number; readonly delta: Delta }
  | {
      readonly kind: 'plateaus';
      readonly runId: number;
      readonly requestId: number;
      readonly plateaus: Plateaus;
    }
  | {
      readonly kind: 'exported';
      readonly runId: number;
      readonly requestId: number;
      readonly bytes: Uint8Array;
    }
  | {
      readonly kind: 'inspected';
      readonly runId: number;
      readonly requestId: number;
      readonly inspection: Inspection;
    }
  | {
      readonly kind: 'planeDrawn';
      readonly runId: 0;
      readonly requestId: number;
      readonly picture: PlanePicture;
    }
  | { readonly kind: 'closed'; readonly runId: number; readonly requestId: number }
  | {
      readonly kind: 'failed';
      readonly runId: number;
      readonly requestId: number;
      readonly failure: Failure;
    };
