import type { ModuleRun } from 'plateau-module';
import type { Delta, OpenedRun } from '../../web/src/worker/protocol.ts';
import { allDeltas } from './module.ts';

/** What a step shows, from what the module told of its run; vertices are steps, 1-based. */
export interface Shown {
  readonly family: number;
  readonly betti: readonly number[];
  readonly edges: readonly string[];
  readonly triangles: readonly string[];
  /** Of the edges and triangles above, by their vertices: 0xFFFFFFFF while alive at the end. */
  readonly death: ReadonlyMap<string, number>;
  /** Rows of the surface, each turned so that its least vertex comes first. */
  readonly surface: readonly string[];
}

/** The whole record of a finished run, asked for once. */
export class Told {
  private readonly delta: Delta;
  readonly steps: number;

  constructor(
    run: ModuleRun,
    private readonly opened: OpenedRun,
  ) {
    const [delta, ...more] = allDeltas(run, 1e9);
    if (!delta || more.length > 0) throw new Error('one delta was asked for');
    this.delta = delta;
    this.steps = delta.stepCount;
  }

  /** Coordinates of the landmark of a step, three of them. */
  position(step: number): number[] {
    const { dimension, coordinates } = this.opened;
    const landmark = this.landmark(step);
    return [0, 1, 2].map((axis) =>
      axis < dimension ? (coordinates[landmark * dimension + axis] ?? NaN) : 0,
    );
  }

  landmark(step: number): number {
    return this.delta.landmark[step - 1] ?? NaN;
  }

  epsilon(step: number): number {
    return this.delta.epsilon[step - 1] ?? NaN;
  }

  at(step: number): Shown {
    const { delta, opened } = this;
    const family = delta.shownFamily[step - 1] ?? NaN;
    const track = opened.family === 'auto' && family === 1 ? 1 : 0;
    const death = new Map<string, number>();
    const living = (tuples: Uint32Array, deaths: Uint32Array, width: number): string[] => {
      const found: string[] = [];
      for (let i = 0; i * width < tuples.length; ++i) {
        const simplex = [...tuples.subarray(i * width, (i + 1) * width)];
        const birth = simplex[width - 1] ?? Infinity;
        if (birth > step || step >= (deaths[i] ?? 0)) continue;
        found.push(simplex.join());
        death.set(simplex.join(), deaths[i] ?? 0);
      }
      return found.sort();
    };
    const edges = living(delta.edges, delta.edgeDeath[track], 2);
    const triangles = living(delta.triangles, delta.triangleDeath[track], 3);
    const surface = [...delta.rowFrom.keys()]
      .filter((row) => (delta.rowFrom[row] ?? Infinity) <= step && step < (delta.rowTo[row] ?? 0))
      .map((row) => turned([...delta.rowVertices.subarray(3 * row, 3 * row + 3)]))
      .sort();
    const count = opened.bettiCount;
    const betti = [...delta.betti.subarray((step - 1) * count, step * count)];
    return { family, betti, edges, triangles, death, surface };
  }
}

/** The same triangle with its least vertex first; its sense stays. */
export function turned(triangle: readonly number[]): string {
  const least = triangle.indexOf(Math.min(...triangle));
  return [...triangle.slice(least), ...triangle.slice(0, least)].join();
}
