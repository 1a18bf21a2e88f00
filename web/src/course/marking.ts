/** What the core says of an answer. */
export interface Mark {
  /** `open`: it cannot be told yet, or not of this figure. */
  readonly verdict: 'right' | 'wrong' | 'open';
  /** Why, from the figure as it stands. */
  readonly reason: string;
}

export const marked = (right: boolean, reason: string): Mark => ({
  verdict: right ? 'right' : 'wrong',
  reason,
});
export const undecided = (reason: string): Mark => ({ verdict: 'open', reason });

/** Marks an answer by asking the core about the figure at this moment; `answer` is empty where the figure is the answer. */
export type Marker = (answer: string, figure: string) => Promise<Mark>;

/** All numbers of an answer; a line before a number is its sign, unless it joins it to what stands before it. */
export function numbersIn(answer: string): number[] {
  const found = answer.match(/(?<![\p{L}\d])[-−]?\d+(?:\.\d+)?|\d+(?:\.\d+)?/gu) ?? [];
  return found.map((text) => Number(text.replace('−', '-')));
}

/** An answer that is one number; undefined if it is not. */
export function numberIn(answer: string): number | undefined {
  const numbers = numbersIn(answer);
  return numbers.length === 1 ? numbers[0] : undefined;
}

export function same(a: readonly number[], b: readonly number[]): boolean {
  return a.length === b.length && a.every((value, i) => value === b[i]);
}
