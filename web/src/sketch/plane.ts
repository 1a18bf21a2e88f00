import type { Point } from './points.ts';

/** What the core is asked for: everything that a board shows. */
export interface PlaneQuestion {
  readonly landmarks: readonly Point[];
  readonly witnesses: readonly Point[];
  readonly nu: readonly number[];
  /** Only simplices of the Delaunay triangulation. */
  readonly delaunay: boolean;
  /** Which landmark is called a: the one that a button puts in. */
  readonly extra?: number | undefined;
}

/** Landmarks and witnesses are named by their place, from 0. */
export interface Simplex {
  readonly vertices: readonly number[];
  /** All that witness it as nu asks, ascending. */
  readonly witnesses: readonly number[];
}

export interface Cell {
  /** One landmark, or the two of a cell of order two. */
  readonly of: readonly number[];
  readonly corners: readonly Point[];
}

/** What the core says of the points. */
export interface PlanePicture {
  readonly question: PlaneQuestion;
  readonly delaunayEdges: readonly (readonly number[])[];
  readonly delaunayTriangles: readonly (readonly number[])[];
  /** One a witness: its nearest landmarks in order. */
  readonly lists: readonly (readonly number[])[];
  /** Landmarks that have a witness. */
  readonly vertices: readonly Simplex[];
  readonly edges: readonly Simplex[];
  readonly triangles: readonly Simplex[];
  readonly cells: readonly Cell[];
  readonly pairCells: readonly Cell[];
  /** Components and loops. */
  readonly betti: readonly number[];
}

/** Why a set of landmarks is a simplex of the complex, or why not. */
export type Reason =
  | { readonly kind: 'present'; readonly witnesses: readonly number[]; readonly count: number }
  | { readonly kind: 'missing-face'; readonly face: readonly number[]; readonly because: Reason | undefined }
  /** Every disc with the corners on its rim holds one of these landmarks. */
  | { readonly kind: 'not-delaunay'; readonly inside: readonly number[] }
  | {
      readonly kind: 'no-witness';
      /** Who comes closest; absent where there is no witness at all. */
      readonly closest: number | undefined;
      /** The place of the last corner in its list, from 1, and the last place that nu allows. */
      readonly rank: number;
      readonly needed: number;
    }
  | { readonly kind: 'untold'; readonly sentence: string };

/** The order in which the witnesses become landmarks, farthest first, and the scale after each. */
export interface FarthestOrder {
  readonly order: readonly number[];
  readonly epsilon: readonly number[];
}

/** Who computes: nothing of a picture is decided anywhere else. */
export interface PlaneCore {
  picture(question: PlaneQuestion): Promise<PlanePicture>;
  why(question: PlaneQuestion, vertices: readonly number[]): Promise<Reason>;
  farthest(witnesses: readonly Point[]): Promise<FarthestOrder>;
}
