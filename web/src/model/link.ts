import type { RunOptions } from '../worker/protocol.ts';
import { optionsOf, wordsOf } from './run-words.ts';
import type { ViewState } from './view-state.ts';

/** Of a link that this version understands. */
const VERSION = '1';
/** Longer ones are cut off by too many programs; a session file takes their place. */
export const LONGEST_LINK = 32 * 1024;

/** What a link holds. */
export interface Linked {
  readonly source:
    | { readonly kind: 'sample'; readonly shape: string; readonly size: number; readonly noise?: number }
    /** Packed points, and a name for them. */
    | { readonly kind: 'points'; readonly points: string; readonly name: string };
  readonly options: RunOptions;
  /** 0: where the answer is. */
  readonly step: number;
  /** Steps to compute also where plateaus end the run before; 0: none beyond the first end. */
  readonly reached: number;
  readonly view: ViewState;
}

/** The fragment of a link, without its #. */
export function fragmentOf({ source, options, step, reached, view }: Linked): string {
  const pairs = new URLSearchParams({ v: VERSION });
  if (source.kind === 'sample') {
    pairs.set('shape', source.shape);
    pairs.set('n', String(source.size));
    if (source.noise) pairs.set('noise', String(source.noise));
  } else {
    pairs.set('name', source.name);
  }
  for (const [word, text] of wordsOf(options)) pairs.set(word, text);
  if (step > 0) pairs.set('step', String(step));
  if (reached > 0) pairs.set('reached', String(reached));
  if (view.axis !== 'log') pairs.set('axis', view.axis);
  if (view.pose) pairs.set('pose', view.pose.map((value) => Number(value.toPrecision(5))).join(','));
  // Last: where a program cuts a link off, the points are what is missing, and that is noticed.
  if (source.kind === 'points') pairs.set('points', source.points);
  return pairs.toString().replaceAll('%2C', ',');
}

/** What a fragment holds; undefined if it is no link of this page. Throws a sentence where it makes no sense. */
export function linkedIn(fragment: string): Linked | undefined {
  const pairs = new URLSearchParams(fragment.replace(/^#/, ''));
  const version = pairs.get('v');
  if (version === null) return undefined;
  if (version !== VERSION)
    throw new Error('This link was made by another version of Plateau. Reload the page to get the newest.');
  const points = pairs.get('points');
  const shape = pairs.get('shape');
  const whole = (word: string, fallback: number): number => {
    const value = Number(pairs.get(word) ?? fallback);
    if (!Number.isInteger(value) || value < 0)
      throw new Error(`This link says ${word}=${pairs.get(word)}, which makes no sense.`);
    return value;
  };
  if (points === null && shape === null)
    throw new Error('This link names neither a shape nor points: it may have been cut off.');
  const noise = Number(pairs.get('noise') ?? 0);
  const pose = (pairs.get('pose') ?? '').split(',').map(Number);
  return {
    source:
      points !== null
        ? { kind: 'points', points, name: pairs.get('name') ?? 'Shared points' }
        : { kind: 'sample', shape: shape ?? '', size: whole('n', 0), ...(noise > 0 ? { noise } : {}) },
    options: optionsOf(pairs),
    step: whole('step', 0),
    reached: whole('reached', 0),
    view: {
      axis: pairs.get('axis') === 'linear' ? 'linear' : 'log',
      ...(pose.length === 6 && pose.every(Number.isFinite) ? { pose } : {}),
    },
  };
}
