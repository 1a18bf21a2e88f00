import type { ModuleRun, PlateauModule } from 'plateau-module';
import type {
  CloudSource,
  Delta,
  ExportFormat,
  OpenedRun,
  RunOptions,
} from '../../web/src/worker/protocol.ts';
import { allDeltas, expected, file, opened, runThrough, sample } from './module.ts';

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

/** A run whose files are read at some of its steps. */
export interface ExportCase {
  readonly name: string;
  readonly source: CloudSource;
  readonly options?: RunOptions;
  readonly steps: readonly number[];
}

/** Far from the origin and tiny: what single precision would lose. */
const farAway = Array.from({ length: 60 }, (_, i) => {
  const [x, y, z] = [(i * 7) % 11, (i * 5) % 13, (i * 3) % 17];
  return `${1e6 + x * 1e-4} ${-3e5 + y * 1e-4} ${z * 1e-4}`;
}).join('\n');

/** Surfaces, curves, complexes, the plane. */
export const cases: readonly ExportCase[] = [
  { name: 'torus', source: sample('torus', 400), steps: [1, 2, 5, 30, 60, 120, 400] },
  { name: 'helix', source: sample('helix', 500), steps: [3, 40, 80, 250, 500] },
  {
    name: 'surface of a torus',
    source: sample('torus', 200),
    options: { family: 'surface' },
    steps: [1, 60, 200],
  },
  {
    name: 'witness complex',
    source: sample('sphere', 120),
    options: { family: 'witness', nu: [1, 4, 5, 5] },
    steps: [4, 120],
  },
  { name: 'plane', source: sample('circle-noise', 200), steps: [1, 7, 50, 200] },
  { name: 'far away', source: file('far.xyz', farAway), steps: [1, 20, 60] },
];

/** The file, where none is refused. */
export function bytesOf(run: ModuleRun, format: ExportFormat, step?: number): Uint8Array<ArrayBuffer> {
  return expected(run.exportFile(format, step)).bytes;
}

export type Check = (run: ModuleRun, told: Told, step: number) => void | Promise<void>;

/** Finishes a run of the case and looks at its steps. */
export async function eachStep(module: PlateauModule, one: ExportCase, check: Check): Promise<void> {
  const run = new module.Run(one.source, one.options ?? {});
  const answer = opened(run);
  runThrough(run, Infinity);
  const told = new Told(run, answer);
  for (const step of one.steps) await check(run, told, step);
  run.delete();
}
