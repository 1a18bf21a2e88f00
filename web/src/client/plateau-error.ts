import type { Failure } from '../worker/protocol.ts';

/** What went wrong, for programs; the message beside it is for people and may change. */
export type ErrorCode =
  /** The input holds no point at all. */
  | 'empty-input'
  /** There are fewer points than the task needs. */
  | 'too-few-points'
  /** A coordinate is not a number, infinite, or too large to be squared. */
  | 'not-a-number'
  /** Rows of a table have different lengths. */
  | 'ragged-rows'
  /** The text or the bytes break the rules of their format. */
  | 'malformed-input'
  /** A file of another kind. */
  | 'unknown-format'
  /** The number of coordinates is none that the family takes, or a table does not say which columns they are. */
  | 'unsupported-dimension'
  /** An option or another value is unknown, of the wrong type, or out of its range. */
  | 'invalid-option'
  /** The run will not fit into the memory, or has filled it. What was computed stays. */
  | 'out-of-memory'
  /** A file or an address could not be read: it is gone, refused, or from another origin that does not allow it. */
  | 'cannot-read'
  /** A file could not be written. */
  | 'cannot-write'
  /** A fault of the program; please report it. */
  | 'internal'
  /** The run was closed, and what waited for it with it. */
  | 'closed'
  /** The worker or the WebAssembly module could not be started, or died. The next opening starts anew. */
  | 'worker-failed'
  /** The browser lacks something that nothing can stand in for. */
  | 'unsupported-browser'
  /** There is no WebGL 2: the shape cannot be drawn, all else works. */
  | 'no-graphics'
  /** An attribute has a value that it cannot have; its default is taken. */
  | 'bad-attribute'
  /** The run has fewer plateaus than the one that was asked for. */
  | 'no-such-plateau';

/** The worker died, or an answer came out of turn: no C++ knows of it. */
export const WORKER_FAILED = 'worker-failed' satisfies ErrorCode;

/** In the order of core/base/result.h, whose numbers begin with 1. */
const NAMES: readonly ErrorCode[] = [
  'empty-input',
  'too-few-points',
  'not-a-number',
  'ragged-rows',
  'malformed-input',
  'unknown-format',
  'unsupported-dimension',
  'invalid-option',
  'out-of-memory',
  'cannot-read',
  'cannot-write',
  'internal',
];

/** The name of a failure's number. */
export function codeOf({ code }: Failure): ErrorCode {
  return NAMES[code - 1] ?? 'internal';
}

/** A failure with a sentence for people. */
export class PlateauError extends Error {
  constructor(
    readonly code: ErrorCode,
    message: string,
    options?: ErrorOptions,
  ) {
    super(message, options);
    this.name = 'PlateauError';
  }

  /**
   * What the core or the client has refused.
   *
   * @internal
   */
  static of(failure: Failure): PlateauError {
    return new PlateauError(codeOf(failure), failure.message);
  }
}
