import type { RunOptions } from '../worker/protocol.ts';
import type { ViewState } from '../model/view-state.ts';
import type { SourceChoice } from './source.ts';

/** What happens to the playhead when a cloud is opened. */
export type Arrival =
  /** The film begins. */
  | 'play'
  /** The film waits at its beginning. */
  | 'wait'
  /** The playhead follows the computation and ends at the longest plateau: the answer. */
  | 'answer'
  /** It follows the computation to the next significant plateau. */
  | 'seek'
  /** It follows the computation to the scale where it was: other settings are compared there. */
  | 'return';

/** What was opened and how: all that is needed to open it again. */
export interface Opening {
  readonly choice: SourceChoice;
  readonly options: RunOptions;
}

/** What is shown of it, and how it is looked at. */
export interface Restored {
  /** 0: where the answer is. */
  readonly step: number;
  /** Steps that are computed also where plateaus end the run before. */
  readonly reached: number;
  readonly view: ViewState;
}

/** A session that is opened again with other settings is its points. */
export function openingOf(choice: SourceChoice, options: RunOptions): Opening {
  return { choice: choice.kind === 'file' ? { ...choice, newOptions: true } : choice, options };
}
