import type { RemoteRun } from '../client/plateau-client.ts';
import { PlateauError } from '../client/plateau-error.ts';
import { RunRecord, shownFamilyName, type StepSummary, type Torsion } from '../model/record.ts';
import { shapeInWords } from '../model/words.ts';
import type { Inspection } from '../worker/inspection.ts';
import type {
  Delta,
  ExportFormat,
  Family,
  Metric,
  OpenedRun,
  Plateaus,
  ShownFamily,
} from '../worker/protocol.ts';

/** What one insertion made of the shape. */
export interface Step {
  /** From 1 on. */
  readonly step: number;
  /** Which point became a landmark: its index in the input, from 0 on. */
  readonly landmark: number;
  /** How far the farthest point is from its nearest landmark, in units of the input. */
  readonly epsilon: number;
  /** Which complex the numbers are of. */
  readonly family: ShownFamily;
  /** Betti numbers: components, loops, voids, … */
  readonly betti: readonly number[];
  /** Those over another field, where they differ: the shape has torsion. */
  readonly torsion?: Torsion;
}

/** A range of scales at which the Betti numbers stand still. */
export interface Plateau {
  /** The first step with these Betti numbers. */
  readonly firstStep: number;
  /** The last step with them. */
  readonly lastStep: number;
  /** Where to look at it: in the middle of its scales. */
  readonly middleStep: number;
  /** ε of the first step, units of the input: the coarsest scale. */
  readonly epsilonFirst: number;
  /** ε of the last step: the finest scale. */
  readonly epsilonLast: number;
  /** ln of the ratio of the scales between which it lasts. */
  readonly length: number;
  /** Which complex the numbers are of. */
  readonly family: ShownFamily;
  /** Betti numbers: components, loops, voids, … */
  readonly betti: readonly number[];
  /** Those over another field, where they differ: the shape has torsion. */
  readonly torsion?: Torsion;
  /** What a shape with these Betti numbers looks like, such as "torus-like closed surface". */
  readonly shape: string;
}

/** How a run ended. */
export interface RunEnd {
  /** How many steps there are. */
  readonly steps: number;
  /** 16 hexadecimal digits over all steps, the same wherever the same was computed. */
  readonly hash: string;
  /** Why it ended too early, if it did: its memory was full. */
  readonly stopped?: PlateauError;
}

const NONE = new Uint32Array(0);

/** Steps without their simplices: who draws takes those, too. */
function withoutSimplices(delta: Delta): Delta {
  const deaths = [NONE, NONE] as const;
  return {
    ...delta,
    ...{ edges: NONE, edgeDeath: deaths, triangles: NONE, triangleDeath: deaths, deaths: NONE },
    ...{ rowVertices: NONE, rowFrom: NONE, rowTo: NONE, endedRows: NONE },
  };
}

function listOf(plateaus: Plateaus, { bettiCount, otherField: field }: RunRecord): Plateau[] {
  return Array.from(plateaus.ranked, (i) => {
    const numbersOf = (all: Uint32Array): number[] => [...all.subarray(i * bettiCount, (i + 1) * bettiCount)];
    const betti = numbersOf(plateaus.betti);
    const other = numbersOf(plateaus.torsion);
    const torsion = other[0] ? { field, betti: other } : undefined;
    const family = shownFamilyName(plateaus.family[i] ?? 1);
    return {
      firstStep: plateaus.firstStep[i] ?? 0,
      lastStep: plateaus.lastStep[i] ?? 0,
      middleStep: plateaus.middleStep[i] ?? 0,
      epsilonFirst: plateaus.epsilonFirst[i] ?? 0,
      epsilonLast: plateaus.epsilonLast[i] ?? 0,
      length: Math.log(plateaus.ratio[i] ?? 1),
      family,
      betti,
      ...(torsion ? { torsion } : {}),
      shape: shapeInWords(family, betti, torsion?.betti),
    };
  });
}

/**
 * A cloud whose steps are computed, by themselves and in the background, until the last one. They can be read while
 * they come, `for await (const step of run)`, or be waited for. Close the run when it is no longer needed.
 */
export class Run implements AsyncIterable<Step> {
  /** How many points the cloud has. */
  readonly points: number;
  /** Coordinates a point; 0 where there are only distances. */
  readonly dimension: number;
  /** One point after another, units of the input. */
  readonly coordinates: Float64Array;
  /** How far two points are from each other. */
  readonly metric: Metric;
  /** Which complex is followed. */
  readonly family: Family;
  /** ν of the witness complex, an entry a dimension. */
  readonly nu: readonly number[];
  /** How many steps there will be, unless the run ends before. */
  readonly stepsPlanned: number;
  /** What the reader of a file has to say of it. */
  readonly warnings: readonly string[];
  private readonly record: RunRecord;
  private stopped: PlateauError | undefined;
  private pulling: Promise<void> | undefined;
  private paused: { readonly over: Promise<void>; readonly end: () => void } | undefined;
  private closing: Promise<void> | undefined;

  /** @internal */
  constructor(
    private readonly remote: RemoteRun,
    private readonly onClose: () => void,
  ) {
    const opened: OpenedRun = remote.opened;
    this.points = opened.points;
    this.dimension = opened.dimension;
    this.coordinates = opened.coordinates;
    this.metric = opened.metric;
    this.family = opened.family;
    this.nu = opened.nu;
    this.stepsPlanned = opened.stepsPlanned;
    this.warnings = opened.warnings;
    this.record = new RunRecord(remote.opened);
  }

  /** Every step in turn, from the first; those to come are waited for. */
  async *[Symbol.asyncIterator](): AsyncIterator<Step> {
    for (let step = 1; ; ++step) {
      while (step > this.record.stepCount && !this.record.ended) await this.pull();
      if (step > this.record.stepCount) return;
      yield this.at(step);
    }
  }

  /** The last step, once it is computed; a run that filled its memory ends too, and says so. */
  async end(): Promise<RunEnd> {
    while (!this.record.ended) await this.pull();
    const { stopped } = this;
    return { steps: this.record.stepCount, hash: this.record.hash, ...(stopped ? { stopped } : {}) };
  }

  /** All plateaus of the whole run, the longest first. */
  async plateaus(): Promise<readonly Plateau[]> {
    await this.end();
    return listOf(await this.remote.fetchPlateaus(), this.record);
  }

  /**
   * A file in the format of the command. `step` is for what shows one, mesh, complex and report, and for a session; it
   * is the middle of the longest plateau unless given.
   */
  exportFile(format: ExportFormat, step?: number): Promise<Uint8Array> {
    return this.remote.exportFile(format, step);
  }

  /**
   * Why the simplex of these landmarks, named by their steps, is in the complex shown at the step, or why not; waits for
   * the step if it is still to come. See `Inspection.text` for the answer in words.
   */
  async inspect(step: number, vertices: readonly number[]): Promise<Inspection> {
    while (step > this.record.stepCount && !this.record.ended) await this.pull();
    return this.remote.inspect(step, vertices);
  }

  /** Computes no further until `resume`. */
  async pause(): Promise<void> {
    if (!this.paused) {
      let end = (): void => undefined;
      const over = new Promise<void>((resolve) => {
        end = resolve;
      });
      this.paused = { over, end };
    }
    await this.remote.pause();
  }

  /** Computes on after `pause`. */
  async resume(): Promise<void> {
    try {
      await this.remote.resume();
    } finally {
      this.wake();
    }
  }

  /** Ends the run and frees its memory. What waits for steps fails, and whatever is asked later. */
  close(): Promise<void> {
    this.closing ??= this.closed();
    return this.closing;
  }

  /**
   * Its worker has died: who waits for the end of a pause is told with the next question.
   *
   * @internal
   */
  lose(): void {
    this.wake();
  }

  private async closed(): Promise<void> {
    // A dead worker has nothing to free.
    const freed = this.remote.close().catch(() => undefined);
    this.wake();
    await freed;
    this.onClose();
  }

  private wake(): void {
    this.paused?.end();
    this.paused = undefined;
  }

  private at(step: number): Step {
    const { epsilon, family, betti, torsion }: StepSummary = this.record.summary(step);
    const about = { step, landmark: this.record.landmark(step), epsilon, family, betti };
    return torsion ? { ...about, torsion } : about;
  }

  /** Waits for what comes next: whoever asks meanwhile waits for the same. */
  private pull(): Promise<void> {
    this.pulling ??= this.pulled().finally(() => {
      this.pulling = undefined;
    });
    return this.pulling;
  }

  private async pulled(): Promise<void> {
    const delta = await this.remote.fetchDelta();
    this.record.append(withoutSimplices(delta));
    if (delta.stopped) this.stopped = PlateauError.of(delta.stopped);
    if (delta.landmark.length === 0 && !this.record.ended) await this.paused?.over;
  }
}
