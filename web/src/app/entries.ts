/** What is written into fields, as values; a sentence is thrown where it makes no sense. */

/** A number from 0 on, or undefined where nothing is written. */
export function fromZero(input: HTMLInputElement, name: string): number | undefined {
  const text = input.value.trim().replace(',', '.');
  if (text === '') return undefined;
  const value = Number(text);
  if (!Number.isFinite(value) || value < 0) throw new Error(`${name} takes a number from 0 on.`);
  return value;
}

/** A number above 0, or undefined where nothing or 0 is written. */
export function positive(input: HTMLInputElement, name: string): number | undefined {
  return fromZero(input, name) || undefined;
}

export function wholeFrom(least: number, input: HTMLInputElement, name: string): number | undefined {
  if (input.value.trim() === '' && !input.validity.badInput) return undefined;
  const value = input.valueAsNumber;
  if (!Number.isInteger(value) || value < least)
    throw new Error(`${name} takes a whole number from ${least} on.`);
  return value;
}

/** What stands between commas, semicolons or blanks. */
function numbersIn(text: string): readonly number[] {
  return text
    .split(/[\s,;]+/)
    .filter((entry) => entry !== '')
    .map(Number);
}

/** "1, 6, 6, 4" as numbers; a sentence where it is no list of whole numbers from `least` on. */
export function parseList(text: string, least: number, name: string): readonly number[] {
  const numbers = numbersIn(text);
  if (numbers.some((value) => !Number.isInteger(value) || value < least)) {
    throw new Error(`${name} takes whole numbers from ${least} on, separated by commas.`);
  }
  return numbers;
}

/** "1, 0.5" as numbers from 0 on. */
export function numberList(text: string, name: string): readonly number[] {
  const numbers = numbersIn(text);
  if (numbers.some((value) => !Number.isFinite(value) || value < 0)) {
    throw new Error(`${name} takes numbers from 0 on, separated by commas.`);
  }
  return numbers;
}
