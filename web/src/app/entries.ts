/** What is written into fields, as values; a sentence is thrown where it makes no sense. */

/** A number above 0, or undefined where nothing or 0 is written. */
export function positive(input: HTMLInputElement, name: string): number | undefined {
  const text = input.value.trim().replace(',', '.');
  if (text === '') return undefined;
  const value = Number(text);
  if (!Number.isFinite(value) || value < 0) throw new Error(`${name} takes a number from 0 on.`);
  return value > 0 ? value : undefined;
}

export function wholeFrom(least: number, input: HTMLInputElement, name: string): number | undefined {
  if (input.value.trim() === '' && !input.validity.badInput) return undefined;
  const value = input.valueAsNumber;
  if (!Number.isInteger(value) || value < least)
    throw new Error(`${name} takes a whole number from ${least} on.`);
  return value;
}

/** "1, 0.5" as numbers from 0 on. */
export function numberList(text: string, name: string): readonly number[] {
  const numbers = text
    .split(/[\s,;]+/)
    .filter((entry) => entry !== '')
    .map(Number);
  if (numbers.some((value) => !Number.isFinite(value) || value < 0)) {
    throw new Error(`${name} takes numbers from 0 on, separated by commas.`);
  }
  return numbers;
}
