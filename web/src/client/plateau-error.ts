import type { Failure } from '../worker/protocol.ts';

/** The code of failures that no C++ knows of: the worker died, or an answer came out of turn. */
export const WORKER_FAILED = 0;

/** A failure with a sentence for people; `code` is that of core/base/result.h or WORKER_FAILED. */
export class PlateauError extends Error {
  readonly code: number;

  constructor(failure: Failure) {
    super(failure.message);
    this.name = 'PlateauError';
    this.code = failure.code;
  }
}
