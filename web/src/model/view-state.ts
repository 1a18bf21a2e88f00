import type { AxisKind } from './scale-axis.ts';

/** How a run is looked at, beside the step: what a session keeps for the page. */
export interface ViewState {
  /** Where the eye is and what it looks at, in units of the frame: six numbers. */
  readonly pose?: readonly number[];
  readonly axis: AxisKind;
}

export function viewText({ pose, axis }: ViewState): string {
  const rounded = pose?.map((value) => Number(value.toPrecision(6)));
  return JSON.stringify({ version: 1, axis, ...(rounded ? { pose: rounded } : {}) });
}

/** What a file says may be anything: what makes no sense is left out. */
export function viewOf(text: string): ViewState {
  let read: unknown;
  try {
    read = JSON.parse(text);
  } catch {
    read = undefined;
  }
  const { pose, axis } = (typeof read === 'object' && read !== null ? read : {}) as Record<string, unknown>;
  const numbers = Array.isArray(pose) ? pose.filter((value): value is number => Number.isFinite(value)) : [];
  return {
    axis: axis === 'linear' ? 'linear' : 'log',
    ...(numbers.length === 6 ? { pose: numbers } : {}),
  };
}
