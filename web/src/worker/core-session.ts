import type { Failed, ModuleRun, PlateauModule, Progress } from 'plateau-module';
import type { Inspection, PlanePicture, PlaneScene, PlaneView } from './inspection.ts';
import type {
  CloudSource,
  Delta,
  ExportFormat,
  Failure,
  OpenedRun,
  Plateaus,
  RunOptions,
} from './protocol.ts';

/** An expected failure of the core, thrown so that the runtime answers it in one place. */
export class CoreFailure extends Error {
  constructor(readonly failure: Failure) {
    super(failure.message);
  }
}

function unwrapped<T extends object>(value: T | Failed): T {
  if ('failure' in value) throw new CoreFailure(value.failure);
  return value;
}

/** What belongs to no run: see `PlanePicture`. */
export function planePicture(module: PlateauModule, view: PlaneView): PlanePicture {
  return unwrapped(module.planePicture(view)).picture;
}

/** `vertices`: places in the array of landmarks. */
export function planeWhy(module: PlateauModule, scene: PlaneScene, vertices: readonly number[]): Inspection {
  return unwrapped(module.planeWhy(scene, vertices)).inspection;
}

/** One run inside the module. `dispose` frees its memory there; nothing may be called after it. */
export class CoreSession {
  private readonly run: ModuleRun;

  constructor(module: PlateauModule, source: CloudSource, options: RunOptions) {
    this.run = new module.Run(source, options);
  }

  /** Undefined while there is more to read. */
  open(budgetMs: number): OpenedRun | undefined {
    const answer = unwrapped(this.run.open(budgetMs));
    return answer.kind === 'opened' ? answer.opened : undefined;
  }

  advance(budgetMs: number, maxSteps = 0xffffffff): Progress {
    const progress = unwrapped(this.run.run(budgetMs, maxSteps));
    // Every delta hands the hash out. It keeps up with the run, so that a page that was hidden meanwhile does not wait
    // for that of all steps at once.
    this.run.hash();
    return progress;
  }

  runPastNoise(): void {
    unwrapped(this.run.runPastNoise());
  }

  /** What was appended since the last call, in a size that a page digests within one frame. */
  delta(maxSimplices: number): Delta {
    return unwrapped(this.run.delta(maxSimplices));
  }

  plateaus(): Plateaus {
    return unwrapped(this.run.plateaus());
  }

  exportFile(format: ExportFormat, step: number | undefined, view?: string): Uint8Array<ArrayBuffer> {
    return unwrapped(this.run.exportFile(format, step, view)).bytes;
  }

  inspect(step: number, vertices: readonly number[]): Inspection {
    return unwrapped(this.run.inspect(step, vertices)).inspection;
  }

  dispose(): void {
    this.run.delete();
  }
}
