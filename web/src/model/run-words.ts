import type { RunOptions } from '../worker/protocol.ts';

type Value = string | number | boolean | readonly number[];

/** An option of a run by its word: that of the command's `--word` and of a link's `word=`. */
interface Word {
  readonly word: string;
  readonly option: keyof RunOptions;
  readonly read: (text: string) => Value | undefined;
}

function number(text: string): number | undefined {
  const value = Number(text);
  return text.trim() !== '' && Number.isFinite(value) ? value : undefined;
}

function list(text: string): readonly number[] | undefined {
  const values = text.split(',').map(number);
  return values.every((value) => value !== undefined) ? values : undefined;
}

const name = (text: string): string | undefined => (/^[a-z0-9]+$/.test(text) ? text : undefined);
const flag = (text: string): boolean | undefined => (text === '1' ? true : undefined);

/** Which values make sense together is for the core to say. */
const WORDS: readonly Word[] = [
  { word: 'family', option: 'family', read: name },
  { word: 'nu', option: 'nu', read: list },
  { word: 'first', option: 'first', read: number },
  { word: 'steps', option: 'maxSteps', read: number },
  { word: 'until', option: 'untilEpsilon', read: number },
  { word: 'rho', option: 'rho', read: number },
  { word: 'metric', option: 'metric', read: name },
  { word: 'knn', option: 'knn', read: number },
  { word: 'box', option: 'box', read: list },
  { word: 'max-dim', option: 'maxDimension', read: number },
  { word: 'field', option: 'field', read: number },
  { word: 'dilation', option: 'dilation', read: number },
  { word: 'pump', option: 'pump', read: flag },
  { word: 'omega-bar', option: 'omegaBar', read: number },
  { word: 'zeta2', option: 'zeta2', read: number },
  { word: 'sliver', option: 'sliver', read: name },
  { word: 'min-length', option: 'minLength', read: number },
];

/** The options that were given, as pairs of word and text; a flag is 1. */
export function wordsOf(options: RunOptions): readonly (readonly [word: string, text: string])[] {
  return WORDS.flatMap(({ word, option }) => {
    const value = options[option];
    if (value === undefined || value === false) return [];
    return [[word, value === true ? '1' : String(value)] as const];
  });
}

/** The options that the pairs name; a sentence is thrown for a value that makes no sense. Other pairs are passed over. */
export function optionsOf(pairs: URLSearchParams): RunOptions {
  const options: Partial<Record<keyof RunOptions, Value>> = {};
  for (const { word, option, read } of WORDS) {
    const text = pairs.get(word);
    if (text === null) continue;
    const value = read(text);
    if (value === undefined) throw new Error(`This link says ${word}=${text}, which makes no sense.`);
    options[option] = value;
  }
  return options as RunOptions;
}

/** The options as the command takes them. */
export function commandWords(options: RunOptions): string {
  return wordsOf(options)
    .map(([word, text]) => (word === 'pump' ? '--pump' : `--${word} ${text}`))
    .join(' ');
}
