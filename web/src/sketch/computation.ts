import type { FarthestOrder, PlaneCore, PlanePicture, PlaneQuestion } from './plane.ts';
import { formatPoints, samePlace, type Point } from './points.ts';
import type { SketchState } from './sketch-state.ts';

/** What the core has said of a state. */
export interface Computed {
  readonly state: SketchState;
  readonly landmarks: readonly Point[];
  readonly picture: PlanePicture;
  readonly scale: FarthestOrder | undefined;
}

/** The settings beside the state that a picture depends on. */
export interface Setting {
  readonly extra: Point | undefined;
  /** Only simplices of the Delaunay triangulation. */
  readonly delaunay: boolean;
}

/** Asks the core for the picture of the latest state, one question at a time: what a drag passes through is left out. */
export class Computation {
  private wanted: { state: SketchState; setting: Setting } | undefined;
  private working: Promise<void> | undefined;
  private scaleOf = '';
  private scale: FarthestOrder | undefined;

  constructor(
    private readonly core: PlaneCore,
    private readonly show: (computed: Computed) => void,
    private readonly fail: (error: unknown) => void,
  ) {}

  want(state: SketchState, setting: Setting): void {
    this.wanted = { state, setting };
    this.working ??= this.work().finally(() => (this.working = undefined));
  }

  /** Until nothing is asked any more. */
  async settled(): Promise<void> {
    while (this.working) await this.working;
  }

  private async work(): Promise<void> {
    // A moment's changes are one.
    await Promise.resolve();
    while (this.wanted) {
      const { state, setting } = this.wanted;
      this.wanted = undefined;
      try {
        const scale = state.step > 0 ? await this.scaleFor(state.witnesses) : undefined;
        const question = questionOf(state, setting, scale);
        const picture = await this.core.picture(question);
        if (!this.wanted) this.show({ state, landmarks: question.landmarks, picture, scale });
      } catch (error) {
        if (!this.wanted) this.fail(error);
      }
    }
  }

  private async scaleFor(witnesses: readonly Point[]): Promise<FarthestOrder> {
    const name = formatPoints(witnesses);
    if (this.scale && this.scaleOf === name) return this.scale;
    this.scale = await this.core.farthest(witnesses);
    this.scaleOf = name;
    return this.scale;
  }
}

/** The landmarks of a state: its own, or the first witnesses farthest first; and a, if it is in. */
export function questionOf(
  { landmarks, witnesses, nu, step, withExtra }: SketchState,
  { extra, delaunay }: Setting,
  scale: FarthestOrder | undefined,
): PlaneQuestion {
  const own =
    step > 0 ? (scale?.order ?? []).slice(0, step).flatMap((index) => witnesses[index] ?? []) : landmarks;
  // Two landmarks in one place would be one.
  const comes = extra && withExtra && !own.some((place) => samePlace(place, extra));
  if (!comes) return { landmarks: own, witnesses, nu, delaunay };
  return { landmarks: [...own, extra], witnesses, nu, delaunay, extra: own.length };
}
