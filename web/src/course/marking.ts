/** What the core says of an answer. */
export interface Mark {
  readonly right: boolean;
  /** Why, from the figure as it stands. */
  readonly reason: string;
}

/** Marks an answer by asking the core about the figure at this moment; `answer` is empty where the figure is the answer. */
export type Marker = (answer: string, figure: string) => Promise<Mark>;

/** All numbers of an answer, signs and words aside. */
export function numbersIn(answer: string): number[] {
  return (answer.match(/\d+(?:\.\d+)?/g) ?? []).map(Number);
}

/** An answer that is one number; undefined if it is not. */
export function numberIn(answer: string): number | undefined {
  const numbers = numbersIn(answer);
  return numbers.length === 1 ? numbers[0] : undefined;
}

export function same(a: readonly number[], b: readonly number[]): boolean {
  return a.length === b.length && a.every((value, i) => value === b[i]);
}
