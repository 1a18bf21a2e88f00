import type { CloudFrame, Delta, Family, Opened, RunState, ShownFamily } from '../worker/protocol.ts';
import { ChunkedColumn, LifespanStore } from './chunks.ts';

/** Steps in one block of extremes. */
const BLOCK = 256;
/** By number; the fourth is `auto`, which is never shown. */
const SHOWN_FAMILIES: readonly (ShownFamily | undefined)[] = [
  'witness',
  'delaunay',
  'surface',
  undefined,
  'dilated',
];

/** The name of a shown family in the numbering of the protocol. */
export function shownFamilyName(code: number): ShownFamily {
  return SHOWN_FAMILIES[code] ?? 'delaunay';
}

/** Betti numbers over another field that differ from those that are shown. */
export interface Torsion {
  /** A prime p: they are over Z/p. */
  readonly field: number;
  /** Components, loops, voids, … over that field. */
  readonly betti: readonly number[];
}

/** What pumping a landmark came to. */
export interface Pump {
  readonly weightSquared: number;
  /** The smallest sliver measure around it without a weight, 0 where it would be no vertex; and with the chosen one. */
  readonly before: number;
  readonly after: number;
  /** The largest weight of all at its step, as a part of the distance to the nearest landmark. */
  readonly amplitude: number;
  /** Weights at which a simplex was found to enter or leave what is around it; not all that there are. */
  readonly thresholds: number;
}
const PUMP_NUMBERS = 5;

/** What a step shows. */
export interface StepSummary {
  readonly step: number;
  readonly epsilon: number;
  readonly family: ShownFamily;
  readonly betti: readonly number[];
  readonly torsion?: Torsion;
  /** The track whose deaths count at this step. */
  readonly track: 0 | 1;
}

/**
 * The growing record of a run on the page: a mirror of the Timeline that knows no DOM. Steps are 1-based; appending
 * copies nothing that is there; any step is a filter on lifespans.
 */
export class RunRecord {
  /** Betti numbers a step. */
  readonly bettiCount: number;
  /** The prime of the numbers that tell torsion; 0: there is none. */
  readonly otherField: number;
  readonly frame: CloudFrame;
  readonly family: Family;
  readonly stepsPlanned: number;
  /** How many of them the memory is expected to hold, how much all would take, and how much there is. */
  readonly stepsAffordable: number;
  readonly estimatedBytes: number;
  readonly memoryLimitBytes: number;
  /** The length of a plateau at which the run stops; 0: at none. */
  readonly minLength: number;
  /** The landmarks as elements that never die. */
  readonly points = new LifespanStore(1, 0);
  readonly edges: LifespanStore;
  readonly triangles: LifespanStore;
  readonly rows = new LifespanStore(3, 1);
  state: RunState = 'preparing';
  stepCount = 0;
  hash = '';
  /** What the run holds. */
  memoryBytes = 0;
  /** The ε at which the run ends by itself; 0: nowhere, or not known yet. */
  noise = 0;
  endedAtNoise = false;
  endedAtPlateau = false;
  /** Plateaus at which it stopped and was let go on. */
  plateausPassed = 0;
  /** Landmarks whose weights were chosen; 0 where that is not done. */
  pumpCount = 0;
  /** Of a session, once its steps are computed again: whether they are those that were saved. */
  agreesWithSession: boolean | undefined;

  /** Extremes of the Betti numbers over blocks of steps, `bettiCount` entries a block. */
  private readonly blockLeast: number[] = [];
  private readonly blockMost: number[] = [];
  private readonly landmarks = new ChunkedColumn<Uint32Array>((length) => new Uint32Array(length));
  private readonly epsilons = new ChunkedColumn<Float64Array>((length) => new Float64Array(length));
  private readonly families = new ChunkedColumn<Uint8Array>((length) => new Uint8Array(length));
  private readonly bettis = new ChunkedColumn<Uint32Array>((length) => new Uint32Array(length));
  private readonly otherBettis = new ChunkedColumn<Uint32Array>((length) => new Uint32Array(length));

  private readonly pumps = new ChunkedColumn<Float64Array>((length) => new Float64Array(length));

  constructor(opened: Opened) {
    this.bettiCount = opened.bettiCount;
    this.otherField = opened.otherField;
    this.frame = opened.frame;
    this.family = opened.family;
    this.stepsPlanned = opened.stepsPlanned;
    this.stepsAffordable = opened.stepsAffordable;
    this.estimatedBytes = opened.estimatedBytes;
    this.memoryLimitBytes = opened.memoryLimitBytes;
    this.minLength = opened.minLength;
    const tracks = opened.family === 'auto' ? 2 : 1;
    this.edges = new LifespanStore(2, tracks);
    this.triangles = new LifespanStore(3, tracks);
  }

  /** No further step comes by itself. */
  get ended(): boolean {
    return this.state === 'finished' || this.state === 'stopped';
  }

  append(delta: Delta): void {
    if (delta.firstStep !== this.stepCount + 1) {
      throw new Error(`steps from ${delta.firstStep} do not follow step ${this.stepCount}`);
    }
    this.landmarks.append(delta.landmark);
    const steps = Uint32Array.from(delta.landmark, (_, i) => delta.firstStep + i);
    this.points.append(delta.landmark, steps, []);
    this.epsilons.append(delta.epsilon);
    this.families.append(delta.shownFamily);
    this.bettis.append(delta.betti);
    this.otherBettis.append(delta.otherBetti);
    this.pumps.append(delta.pumps);
    this.pumpCount = this.pumps.length / PUMP_NUMBERS;
    this.extendBlocks(delta);
    this.appendSimplices(this.edges, delta.edges, delta.edgeDeath);
    this.appendSimplices(this.triangles, delta.triangles, delta.triangleDeath);
    const { deaths, endedRows } = delta;
    for (let i = 0; i + 3 < deaths.length; i += 4) {
      const store = deaths[i] === 1 ? this.edges : this.triangles;
      store.setDeath(deaths[i + 2] ?? 0, deaths[i + 1] ?? 0, deaths[i + 3] ?? 0);
    }
    this.rows.append(this.landmarksOf(delta.rowVertices), delta.rowFrom, [delta.rowTo]);
    for (let i = 0; i + 1 < endedRows.length; i += 2) {
      this.rows.setDeath(endedRows[i] ?? 0, 0, endedRows[i + 1] ?? 0);
    }
    this.stepCount = delta.stepCount;
    this.state = delta.state;
    this.hash = delta.hash;
    this.memoryBytes = delta.memoryBytes;
    this.noise = delta.noise;
    this.endedAtNoise = delta.endedAtNoise;
    this.endedAtPlateau = delta.endedAtPlateau;
    this.agreesWithSession = delta.agreesWithSession;
  }

  /** The run goes on beyond the noise. */
  runPastNoise(): void {
    this.noise = 0;
    this.endedAtNoise = false;
    if (this.state === 'finished') this.state = 'running';
  }

  /** The run goes on after an end at a plateau. */
  runToNextPlateau(): void {
    if (!this.endedAtPlateau) return;
    this.endedAtPlateau = false;
    this.plateausPassed += 1;
    this.state = 'running';
  }

  /** What pumping the landmark of a step came to; the step is at most `pumpCount`. */
  pump(step: number): Pump {
    const first = (step - 1) * PUMP_NUMBERS;
    const [weightSquared = 0, before = 0, after = 0, amplitude = 0, thresholds = 0] = [0, 1, 2, 3, 4].map(
      (i) => this.pumps.at(first + i),
    );
    return { weightSquared, before, after, amplitude, thresholds };
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
          this.blockLeast[block * this.bettiCount + k] ?? 0,
          this.blockMost[block * this.bettiCount + k] ?? 0,
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
    return this.bettis.at((step - 1) * this.bettiCount + k);
  }

  summary(step: number): StepSummary {
    const family = shownFamilyName(this.families.at(step - 1));
    const torsion = this.torsion(step);
    return {
      step,
      epsilon: this.epsilon(step),
      family,
      betti: Array.from({ length: this.bettiCount }, (_, k) => this.betti(step, k)),
      ...(torsion ? { torsion } : {}),
      track: this.family === 'auto' && family === 'delaunay' ? 1 : 0,
    };
  }

  private torsion(step: number): Torsion | undefined {
    if (this.otherField === 0) return undefined;
    const first = (step - 1) * this.bettiCount;
    const betti = Array.from({ length: this.bettiCount }, (_, k) => this.otherBettis.at(first + k));
    return betti.some((count, k) => count !== this.betti(step, k))
      ? { field: this.otherField, betti }
      : undefined;
  }

  private extendBlocks(delta: Delta): void {
    for (let i = 0; i < delta.betti.length; ++i) {
      const step = delta.firstStep + Math.floor(i / this.bettiCount);
      const at = Math.floor((step - 1) / BLOCK) * this.bettiCount + (i % this.bettiCount);
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
    const births = new Uint32Array(tuples.length / width);
    for (let i = 0; i < births.length; ++i) births[i] = tuples[(i + 1) * width - 1] ?? 0;
    store.append(this.landmarksOf(tuples), births, death);
  }

  /** Input indices of the landmarks of these steps. */
  private landmarksOf(steps: Uint32Array): Uint32Array {
    const indices = new Uint32Array(steps.length);
    for (let i = 0; i < steps.length; ++i) indices[i] = this.landmark(steps[i] ?? 1);
    return indices;
  }
}
