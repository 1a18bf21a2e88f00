import type { RunOptions } from '../worker/protocol.ts';
import { optionsOf, wordsOf } from './run-words.ts';
import type { ViewState } from './view-state.ts';

/** Of a link that this version understands. */
const VERSION = '1';
/** Longer ones are cut off by too many programs; a session file takes their place. */
export const LONGEST_LINK = 32 * 1024;
/** The words of a second run begin with this. */
const BESIDE = 'b.';
/** In place of the points of a second run: those of the first. */
const SAME = 'same';

/** Where the points of a run come from. */
export type LinkedSource =
  | { readonly kind: 'sample'; readonly shape: string; readonly size: number; readonly noise?: number }
  /** Packed points, and a name for them. */
  | { readonly kind: 'points'; readonly points: string; readonly name: string };

/** A second run that is compared with the first. */
export interface LinkedBeside {
  /** None: the points of the first run. */
  readonly source: LinkedSource | undefined;
  readonly options: RunOptions;
  /** Where the playhead of both stands: a place of ln(1/ε). */
  readonly scale: number;
  /** From where its shape is looked at; none: as the first. */
  readonly pose?: readonly number[];
}

/** What a link holds. */
export interface Linked {
  readonly source: LinkedSource;
  readonly options: RunOptions;
  /** 0: where the answer is. */
  readonly step: number;
  /** Steps to compute also where plateaus end the run before; 0: none beyond the first end. */
  readonly reached: number;
  readonly view: ViewState;
  readonly beside?: LinkedBeside;
}

type Pair = readonly [word: string, text: string];

function poseWords(pose: readonly number[] | undefined): Pair[] {
  return pose ? [['pose', pose.map((value) => Number(value.toPrecision(5))).join(',')]] : [];
}

function sourceWords(source: LinkedSource): Pair[] {
  if (source.kind === 'points') return [['name', source.name]];
  const { shape, size, noise } = source;
  return [['shape', shape], ['n', String(size)], ...(noise ? [['noise', String(noise)] as const] : [])];
}

/** Last: where a program cuts a link off, the points are what is missing, and that is noticed. */
function pointWords(source: LinkedSource | undefined): Pair[] {
  return source?.kind === 'points' ? [['points', source.points]] : [];
}

/** The fragment of a link, without its #. */
export function fragmentOf({ source, options, step, reached, view, beside }: Linked): string {
  const pairs = new URLSearchParams({ v: VERSION });
  const add = (words: readonly Pair[], prefix = ''): void =>
    words.forEach(([word, text]) => pairs.append(prefix + word, text));
  add([...sourceWords(source), ...wordsOf(options)]);
  if (step > 0) add([['step', String(step)]]);
  if (reached > 0) add([['reached', String(reached)]]);
  if (view.axis !== 'log') add([['axis', view.axis]]);
  add(poseWords(view.pose));
  if (beside) {
    const { scale, pose } = beside;
    add(beside.source ? sourceWords(beside.source) : [[SAME, '1']], BESIDE);
    add([...wordsOf(beside.options), ['scale', String(scale)], ...poseWords(pose)], BESIDE);
    add(pointWords(beside.source), BESIDE);
  }
  add(pointWords(source));
  return pairs.toString().replaceAll('%2C', ',');
}

function whole(pairs: URLSearchParams, word: string, fallback: number): number {
  const value = Number(pairs.get(word) ?? fallback);
  if (!Number.isInteger(value) || value < 0)
    throw new Error(`This link says ${word}=${pairs.get(word)}, which makes no sense.`);
  return value;
}

function sourceIn(pairs: URLSearchParams): LinkedSource {
  const points = pairs.get('points');
  if (points !== null) return { kind: 'points', points, name: pairs.get('name') ?? 'Shared points' };
  const shape = pairs.get('shape');
  if (shape === null)
    throw new Error('This link names neither a shape nor points: it may have been cut off.');
  const noise = Number(pairs.get('noise') ?? 0);
  return { kind: 'sample', shape, size: whole(pairs, 'n', 0), ...(noise > 0 ? { noise } : {}) };
}

function poseIn(pairs: URLSearchParams): { readonly pose?: readonly number[] } {
  const pose = (pairs.get('pose') ?? '').split(',').map(Number);
  return pose.length === 6 && pose.every(Number.isFinite) ? { pose } : {};
}

function besideIn(all: URLSearchParams): LinkedBeside | undefined {
  const own = [...all].filter(([word]) => word.startsWith(BESIDE));
  if (own.length === 0) return undefined;
  const pairs = new URLSearchParams(own.map(([word, text]) => [word.slice(BESIDE.length), text]));
  const scale = Number(pairs.get('scale') ?? 0);
  return {
    source: pairs.has(SAME) ? undefined : sourceIn(pairs),
    options: optionsOf(pairs),
    scale: Number.isFinite(scale) ? scale : 0,
    ...poseIn(pairs),
  };
}

/** What a fragment holds; undefined if it is no link of this page. Throws a sentence where it makes no sense. */
export function linkedIn(fragment: string): Linked | undefined {
  const pairs = new URLSearchParams(fragment.replace(/^#/, ''));
  const version = pairs.get('v');
  if (version === null) return undefined;
  if (version !== VERSION)
    throw new Error('This link was made by another version of Plateau. Reload the page to get the newest.');
  const source = sourceIn(pairs);
  const beside = besideIn(pairs);
  return {
    source,
    options: optionsOf(pairs),
    step: whole(pairs, 'step', 0),
    reached: whole(pairs, 'reached', 0),
    view: { axis: pairs.get('axis') === 'linear' ? 'linear' : 'log', ...poseIn(pairs) },
    ...(beside ? { beside } : {}),
  };
}
