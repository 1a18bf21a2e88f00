import type { PlateauClient, RemoteRun } from '../client/plateau-client.ts';
import { npyOf } from '../package/cloud.ts';
import type { Inspection, PlanePolygons, PlaneScene, PlaneWitnesses } from '../worker/inspection.ts';
import type { Delta } from '../worker/protocol.ts';
import type {
  Cell,
  FarthestOrder,
  PlaneCore,
  PlanePicture,
  PlaneQuestion,
  Reason,
  Simplex,
} from './plane.ts';
import { BOARD, flat, type Point } from './points.ts';

/** While a run computes on, what it has is asked for so often. */
const LOOK_AGAIN_MS = 8;
/** A little more than the board, so that no cell ends in sight. */
const BEYOND = 10;
const BOX = [-BEYOND, -BEYOND, BOARD.width + BEYOND, BOARD.height + BEYOND] as const;

/** Entries of so many in turn. */
function rows(values: Uint32Array, width: number): number[][] {
  return Array.from({ length: width > 0 ? values.length / width : 0 }, (_, i) => [
    ...values.subarray(width * i, width * (i + 1)),
  ]);
}

function simplices(values: Uint32Array, width: number, { first, witnesses }: PlaneWitnesses): Simplex[] {
  return rows(values, width).map((vertices, i) => ({
    vertices,
    witnesses: [...witnesses.subarray(first[i], first[i + 1])],
  }));
}

function polygons({ first, corners }: PlanePolygons, of: readonly (readonly number[])[]): Cell[] {
  return of.map((names, i) => {
    const [begin = 0, end = 0] = [first[i], first[i + 1]];
    const places: Point[] = [];
    for (let k = begin; k < end; ++k) places.push({ x: corners[2 * k] ?? 0, y: corners[2 * k + 1] ?? 0 });
    return { of: names, corners: places };
  });
}

function sceneOf({ landmarks, witnesses, nu, delaunay }: PlaneQuestion): PlaneScene {
  return { landmarks: flat(landmarks), witnesses: flat(witnesses), nu, delaunay };
}

function reasonOf(vertices: readonly number[], inspection: Inspection): Reason {
  const about = [...inspection.about];
  const own = ownReason(inspection);
  return about.length > 0 && about.length < vertices.length
    ? { kind: 'missing-face', face: about, because: own }
    : own;
}

function ownReason({ verdict, witnesses, witnessCount, best, allowed, blockers, text }: Inspection): Reason {
  switch (verdict) {
    case 'present':
      return { kind: 'present', witnesses: [...witnesses].sort((a, b) => a - b), count: witnessCount };
    case 'notDelaunay':
      return { kind: 'not-delaunay', inside: [...blockers] };
    case 'notWitnessed':
      return { kind: 'no-witness', closest: best?.witness, rank: best?.rank ?? 0, needed: allowed };
    case 'notInserted':
    case 'tooManyVertices':
      return { kind: 'untold', sentence: text };
  }
}

/** The core in the worker, asked through a client. */
export class ClientPlaneCore implements PlaneCore {
  constructor(protected readonly client: PlateauClient) {}

  async picture(question: PlaneQuestion): Promise<PlanePicture> {
    const answer = await this.client.planePicture({ ...sceneOf(question), box: BOX });
    const delaunayEdges = rows(answer.delaunayEdges, 2);
    return {
      question,
      delaunayEdges,
      delaunayTriangles: rows(answer.delaunayTriangles, 3),
      lists: rows(answer.lists, answer.listLength),
      vertices: simplices(answer.vertices, 1, answer.vertexWitnesses),
      edges: simplices(answer.edges, 2, answer.edgeWitnesses),
      triangles: simplices(answer.triangles, 3, answer.triangleWitnesses),
      cells: polygons(
        answer.cells,
        question.landmarks.map((_, i) => [i]),
      ),
      pairCells: polygons(answer.pairCells, delaunayEdges),
      betti: [...answer.betti],
    };
  }

  async why(question: PlaneQuestion, vertices: readonly number[]): Promise<Reason> {
    return reasonOf(vertices, await this.client.planeWhy(sceneOf(question), vertices));
  }

  async farthest(witnesses: readonly Point[]): Promise<FarthestOrder> {
    const bytes = npyOf({ points: flat(witnesses), dimension: 2 });
    const source = { kind: 'file', name: 'witnesses.npy', bytes } as const;
    const run = await this.client.open(source, { family: 'witness', nu: [1, 2, 3] });
    const deltas = await this.through(run);
    return {
      order: deltas.flatMap(({ landmark }) => [...landmark]),
      epsilon: deltas.flatMap(({ epsilon }) => [...epsilon]),
    };
  }

  /** All that a run has to tell, to its end; then it is closed. */
  protected async through(run: RemoteRun): Promise<Delta[]> {
    const deltas: Delta[] = [];
    try {
      for (;;) {
        const delta = await run.fetchDelta();
        deltas.push(delta);
        if (delta.state === 'finished' || delta.state === 'stopped') return deltas;
        if (delta.stepCount === 0) await new Promise((resolve) => setTimeout(resolve, LOOK_AGAIN_MS));
      }
    } finally {
      await run.close();
    }
  }
}
