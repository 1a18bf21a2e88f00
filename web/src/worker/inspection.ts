/**
 * Answers to "why is this simplex here, why not that one?", and exact pictures in the plane. Types only: this file
 * compiles to nothing.
 */

/** Why a simplex is in a complex or not, the first that is true. */
export type Verdict =
  /** It is in the complex. */
  | 'present'
  /** A vertex is no landmark yet. */
  | 'notInserted'
  /** No simplex of the complex has as many vertices. */
  | 'tooManyVertices'
  /** It is not in the Delaunay triangulation of the landmarks. */
  | 'notDelaunay'
  /** No witness has its vertices near enough. */
  | 'notWitnessed';

/** Where a simplex is with respect to the surface that is extracted from the complex. */
export type SurfacePlace =
  /** No surface is shown at that step. */
  | 'none'
  /** A part of it. */
  | 'on'
  /** Of kept triangles, but shut off from outside on both sides. */
  | 'inside'
  /** Of triangles that hang on sharp edges only. */
  | 'peeled'
  /** Of triangles whose radius-edge ratio exceeds rho. */
  | 'tooLong'
  /** An edge or vertex without a triangle. */
  | 'bare'
  /** A tetrahedron: the surface has triangles only. */
  | 'solid';

/** The best witness of a simplex, or the closest miss. */
export interface BestWitness {
  /** Index in the input, from 0 on. */
  readonly witness: number;
  /** The largest rank of a vertex in its list of nearest landmarks, from 1 on; family `dilated`: 0. */
  readonly rank: number;
  /** Family `dilated`: how far it is from the cell of the simplex, in units of the input. */
  readonly distance: number;
  /** The rank of each vertex of `about`; family `dilated`: none. */
  readonly ranks: Uint32Array;
}

/** Why a simplex is in the complex shown at a step, or why not. Landmarks are named by the step that inserted them. */
export interface Inspection {
  /** At which it was asked. */
  readonly step: number;
  /** The landmarks asked for, ascending. */
  readonly simplex: Uint32Array;
  /** Whether it is there, and if not the first reason that holds. */
  readonly verdict: Verdict;
  /**
   * What the verdict is about: the simplex itself, or a smallest one of its faces that are missing; `notInserted`: the
   * vertices that are no landmarks.
   */
  readonly about: Uint32Array;
  /** In the complex from `birth` on and before `death` (0xFFFFFFFF: still at the last step so far); both 0: never. */
  readonly birth: number;
  /** See `birth`. */
  readonly death: number;
  /** A witness needs all vertices of `about` among so many of its nearest landmarks. */
  readonly allowed: number;
  /** Ranks beyond this one were not looked at; 0 where none were. */
  readonly horizon: number;
  /** Family `dilated`: instead a witness may be so far from the cell of `about`, in units of the input. */
  readonly zeta?: number;
  /** Witnesses of `about` by (rank, index) or (distance, index): the first 1,000 of `witnessCount`. */
  readonly witnesses: Uint32Array;
  /** How many witnesses `about` has. */
  readonly witnessCount: number;
  /** One a witness, see `BestWitness`. */
  readonly ranks: Uint32Array;
  /** One a witness, see `BestWitness`. */
  readonly distances: Float64Array;
  /** The first of the witnesses; where there is none the closest miss, unless that is beyond the horizon. */
  readonly best?: BestWitness;
  /** `notDelaunay`: every ball with the vertices of `about` on its boundary has one of these inside; all are needed. */
  readonly blockers: Uint32Array;
  /** `notDelaunay`: no ball has the vertices of `about` on its boundary, they are in a line or in a plane. */
  readonly flat: boolean;
  /** Of what is present. */
  readonly surface: SurfacePlace;
  /** All this in one to four plain sentences. */
  readonly text: string;
}

/** Witnesses and landmarks of a picture in the plane; x, y of one after the other. */
export interface PlaneScene {
  readonly witnesses: Float64Array | readonly number[];
  /** Any points, two of them never in one place; equal distances go to the one that comes first. */
  readonly landmarks: Float64Array | readonly number[];
  /** nu_0, nu_1, nu_2, at most 32; absent: 1, 2, 3, the plain witness complex. */
  readonly nu?: readonly number[];
  /** Whether the complex is taken within the Delaunay triangulation of the landmarks; absent: yes. */
  readonly delaunay?: boolean;
}

/** A scene, and what of the plane is drawn. */
export interface PlaneView extends PlaneScene {
  /** left, bottom, right, top */
  readonly box: readonly [number, number, number, number];
}

/** Entries of something one after the other: those of number i are from first[i] on and before first[i + 1]. */
export interface PlaneWitnesses {
  readonly first: Uint32Array;
  /** Witnesses by their place in the array, ascending for each simplex. */
  readonly witnesses: Uint32Array;
}

/** Convex polygons one after the other; number i has the corners from first[i] on and before first[i + 1]. */
export interface PlanePolygons {
  readonly first: Uint32Array;
  /** x, y of each corner, counter-clockwise. */
  readonly corners: Float64Array;
}

/** Landmarks and witnesses are named by their places in the arrays of the scene, from 0 on. */
export interface PlanePicture {
  /** Two landmarks an edge, ascending, in lexicographic order; likewise below. */
  readonly delaunayEdges: Uint32Array;
  readonly delaunayTriangles: Uint32Array;
  /** Landmarks in the list of each witness: as many as nu asks for, at least 3, at most all. */
  readonly listLength: number;
  /** The nearest landmarks of each witness, nearest first. */
  readonly lists: Uint32Array;
  /** The nu-witness complex. A landmark that no witness has among its nearest nu_0 is no vertex. */
  readonly vertices: Uint32Array;
  readonly edges: Uint32Array;
  readonly triangles: Uint32Array;
  /** All witnesses of each vertex, edge, triangle; there is at least one. */
  readonly vertexWitnesses: PlaneWitnesses;
  readonly edgeWitnesses: PlaneWitnesses;
  readonly triangleWitnesses: PlaneWitnesses;
  /** Components and loops. */
  readonly betti: Uint32Array;
  /** The Voronoi cell of each landmark within the box; no corners where nothing of it is there. */
  readonly cells: PlanePolygons;
  /** For each edge of `delaunayEdges` where its ends are the two nearest landmarks, within the box. */
  readonly pairCells: PlanePolygons;
}
