/**
 * The face of the WebAssembly module (build/wasm/bin/plateau.mjs), written by hand against run.h.
 * Everything that comes back is a plain object of typed arrays that JavaScript owns: it can be transferred.
 */
import type { Inspection, PlanePicture, PlaneScene, PlaneView } from '../web/src/worker/inspection.ts';
import type {
  CloudSource,
  Delta,
  ExportFormat,
  Failure,
  OpenedRun,
  Plateaus,
  RunOptions,
  RunState,
} from '../web/src/worker/protocol.ts';

export interface Failed {
  readonly kind: 'failed';
  readonly failure: Failure;
}

export interface Progress {
  readonly kind: 'progress';
  readonly state: RunState;
  readonly stepsDone: number;
  readonly stepsPlanned: number;
  readonly epsilon: number;
  readonly stopped?: Failure;
}

export interface ModuleRun {
  /** Reads on for about `budgetMs`; call again while it says 'reading'. */
  open(
    budgetMs: number,
  ): { readonly kind: 'reading' } | { readonly kind: 'opened'; readonly opened: OpenedRun } | Failed;
  /** Until the budget (milliseconds, steps) is spent, at least one unit of work: whole steps, or a part of a long one. */
  run(budgetMs: number, maxSteps: number): Progress | Failed;
  /** Lifts the stop at the noise: what ended there goes on. */
  runPastNoise(): { readonly kind: 'lifted' } | Failed;
  /** What was appended since the last call, at most about `maxSimplices` simplices. */
  delta(maxSimplices: number): Delta | Failed;
  plateaus(): Plateaus | Failed;
  /** `view`: text that a session file keeps for the page. */
  exportFile(
    format: ExportFormat,
    step: number | undefined,
    view?: string,
  ): { readonly kind: 'file'; readonly bytes: Uint8Array<ArrayBuffer> } | Failed;
  /** Why the simplex of these landmarks (steps) is there at the step, or why not. */
  inspect(step: number, vertices: ArrayLike<number>): Inspected | Failed;
  /** 16 hexadecimal digits over all complete steps. */
  hash(): string;
  /** Frees the run's memory inside the module. */
  delete(): void;
}

export interface Inspected {
  readonly kind: 'inspection';
  readonly inspection: Inspection;
}

export interface SampleShape {
  readonly name: string;
  readonly dimension: number;
  readonly defaultSize: number;
  /** One sentence for the visitor. */
  readonly lookFor: string;
}

export interface PlateauModule {
  readonly Run: new (source: CloudSource, options: RunOptions) => ModuleRun;
  sampleShapes(): SampleShape[];
  planePicture(view: PlaneView): { readonly kind: 'planePicture'; readonly picture: PlanePicture } | Failed;
  /** `vertices`: places in the array of landmarks. */
  planeWhy(scene: PlaneScene, vertices: ArrayLike<number>): Inspected | Failed;
}

export interface ModuleOptions {
  /** For Node: the bytes of plateau.wasm. */
  readonly wasmBinary?: ArrayBuffer | Uint8Array;
  /** For the browser: where plateau.wasm was put. */
  readonly locateFile?: (name: string) => string;
  /** For a module that is compiled already: instantiates it and hands the instance to `receive`. */
  readonly instantiateWasm?: (
    imports: WebAssembly.Imports,
    receive: (instance: WebAssembly.Instance) => void,
  ) => object;
}

export default function createModule(options?: ModuleOptions): Promise<PlateauModule>;
