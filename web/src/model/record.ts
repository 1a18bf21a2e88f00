import type { Delta, Family, Opened, RunState, ShownFamily } from '../worker/protocol.ts';
import { ChunkedColumn, LifespanStore, NEVER } from './chunks.ts';

/** Steps in one block of extremes. */
const BLOCK = 256;
const SHOWN_FAMILIES: readonly ShownFamily[] = ['witness', 'delaunay', 'surface'];

/** The name of a shown family in the numbering of the protocol. */
export function shownFamilyName(code: number): ShownFamily {
  return SHOWN_FAMILIES[code] ?? 'delaunay';
}

/** What a step shows. */
export interface StepSummary {
  readonly step: number;
  readonly epsilon: number;
  readonly family: ShownFamily;
  readonly betti: readonly number[];
  /** The track whose deaths count at this step. */
  readonly track: 0 | 1;
}

/**
 * The growing record of a run on the page: a mirror of the Timeline that knows no DOM. Steps are 1-based; appending
 * copies nothing that is there; any step is a filter on lifespans.
 */
export class RunRecord {
  readonly dimension: number;
  readonly coordinates: Float64Array;
  readonly family: Family;
  readonly stepsPlanned: number;
  /** The landmarks as elements that never die. */
  readonly points = new LifespanStore(1, 0);
  readonly edges: LifespanStore;
  readonly triangles: LifespanStore;
  readonly rows = new LifespanStore(3, 1);
  state: RunState = 'preparing';
  stepCount = 0;
  hash = '';

  /** Extremes of the Betti numbers over blocks of steps, `dimension` entries a block. */
  private readonly blockLeast: number[] = [];
  private readonly blockMost: number[] = [];
  private readonly landmarks = new ChunkedColumn<Uint32Array>((length) => new Uint32Array(length));
  private readonly epsilons = new ChunkedColumn<Float64Array>((length) => new Float64Array(length));
  private readonly families = new ChunkedColumn<Uint8Array>((length) => new Uint8Array(length));
  private readonly bettis = new ChunkedColumn<Uint32Array>((length) => new Uint32Array(length));

  constructor(opened: Opened) {
    this.dimension = opened.dimension;
    this.coordinates = opened.coordinates;
    this.family = opened.family;
    this.stepsPlanned = opened.stepsPlanned;
    const tracks = opened.family === 'auto' ? 2 : 1;
    this.edges = new LifespanStore(2, tracks);
    this.triangles = new LifespanStore(3, tracks);
  }

  append(delta: Delta): void {
    if (delta.firstStep !== this.stepCount + 1) {
      throw new Error(`steps from ${delta.firstStep} do not follow step ${this.stepCount}`);
    }
    this.landmarks.append(delta.landmark);
    delta.landmark.forEach((landmark, i) =>
      this.points.append(
        () => landmark,
        delta.firstStep + i,
        () => NEVER,
      ),
    );
    this.epsilons.append(delta.epsilon);
    this.families.append(delta.shownFamily);
    this.bettis.append(delta.betti);
    this.extendBlocks(delta);
    this.appendSimplices(this.edges, delta.edges, delta.edgeDeath);
    this.appendSimplices(this.triangles, delta.triangles, delta.triangleDeath);
    for (let i = 0; i + 3 < delta.deaths.length; i += 4) {
      const [dimension = 0, track = 0, index = 0, step = 0] = delta.deaths.subarray(i, i + 4);
      (dimension === 1 ? this.edges : this.triangles).setDeath(index, track, step);
    }
    const { rowVertices, rowFrom, rowTo } = delta;
    for (let row = 0; row < rowFrom.length; ++row) {
      this.rows.append(
        (k) => this.landmark(rowVertices[3 * row + k] ?? 1),
        rowFrom[row] ?? 0,
        () => rowTo[row] ?? 0,
      );
    }
    for (let i = 0; i + 1 < delta.endedRows.length; i += 2) {
      this.rows.setDeath(delta.endedRows[i] ?? 0, 0, delta.endedRows[i + 1] ?? 0);
    }
    this.stepCount = delta.stepCount;
    this.state = delta.state;
    this.hash = delta.hash;
  }

  /** Input index (0-based) of the landmark of a step. */
  landmark(step: number): number {
    return this.landmarks.at(step - 1);
  }

  epsilon(step: number): number {
    return this.epsilons.at(step - 1);
  }

  /** The least and the largest β_k over the steps, both ends included; whole blocks at a time. */
  bettiExtremes(firstStep: number, lastStep: number, k: number): readonly [number, number] {
    let least = Infinity;
    let most = -Infinity;
    const see = (low: number, high: number): void => {
      least = Math.min(least, low);
      most = Math.max(most, high);
    };
    for (let step = firstStep; step <= lastStep;) {
      const block = Math.floor((step - 1) / BLOCK);
      if ((step - 1) % BLOCK === 0 && step + BLOCK - 1 <= lastStep) {
        see(
          this.blockLeast[block * this.dimension + k] ?? 0,
          this.blockMost[block * this.dimension + k] ?? 0,
        );
        step += BLOCK;
      } else {
        const value = this.betti(step, k);
        see(value, value);
        step += 1;
      }
    }
    return [least, most];
  }

  betti(step: number, k: number): number {
    return this.bettis.at((step - 1) * this.dimension + k);
  }

  summary(step: number): StepSummary {
    const family = shownFamilyName(this.families.at(step - 1));
    return {
      step,
      epsilon: this.epsilon(step),
      family,
      betti: Array.from({ length: this.dimension }, (_, k) => this.betti(step, k)),
      track: this.family === 'auto' && family === 'delaunay' ? 1 : 0,
    };
  }

  private extendBlocks(delta: Delta): void {
    for (let i = 0; i < delta.betti.length; ++i) {
      const step = delta.firstStep + Math.floor(i / this.dimension);
      const at = Math.floor((step - 1) / BLOCK) * this.dimension + (i % this.dimension);
      const value = delta.betti[i] ?? 0;
      this.blockLeast[at] = Math.min(this.blockLeast[at] ?? Infinity, value);
      this.blockMost[at] = Math.max(this.blockMost[at] ?? 0, value);
    }
  }

  private appendSimplices(
    store: LifespanStore,
    tuples: Uint32Array,
    death: readonly [Uint32Array, Uint32Array],
  ): void {
    const width = store.vertices;
    for (let i = 0; i * width < tuples.length; ++i) {
      const birth = tuples[i * width + width - 1] ?? 0;
      store.append(
        (k) => this.landmark(tuples[i * width + k] ?? 1),
        birth,
        (track) => death[track]?.[i] ?? 0,
      );
    }
  }
}
