import type { PlaneQuestion } from './plane.ts';

/** What a landmark is called: p1 is the first one; the one that a button puts in is a. */
export type Naming = (landmark: number) => string;

export const witnessName = (index: number): string => `w${index + 1}`;

export function namesOf({ extra }: Pick<PlaneQuestion, 'extra'>): Naming {
  return (landmark) => (landmark === extra ? 'a' : `p${landmark + 1}`);
}

const EXTRA = 'a';
const numberOf = (name: string): number => (name === EXTRA ? Infinity : Number(name));

/** The landmarks that a reader or an address asks for: "1 2", "p1, p2", "3 a". They keep their names when others come. */
export function parseAsked(text: string): string[] {
  const words = text.split(/[\s,;_]+/).filter((word) => word !== '');
  const names = words.map((word) => {
    const match = /^(?:p?([1-9]\d*)|a)$/i.exec(word);
    if (!match) throw new Error(`"${word}" is no landmark: write one to three of their numbers, as 1 2.`);
    return match[1] ?? EXTRA;
  });
  return [...new Set(names)].sort((one, other) => numberOf(one) - numberOf(other) || 0);
}

export function askedNames(landmarks: readonly number[], { extra }: PlaneQuestion): string[] {
  return parseAsked(landmarks.map((index) => (index === extra ? EXTRA : String(index + 1))).join(' '));
}

/** The landmarks of these names, as far as the question has them; the one that is called a has no number. */
export function landmarksNamed(names: readonly string[], { landmarks, extra }: PlaneQuestion): number[] {
  return names.flatMap((name) => {
    if (name === EXTRA) return extra ?? [];
    const index = Number(name) - 1;
    return index < landmarks.length && index !== extra ? [index] : [];
  });
}

/** The same names after a landmark of the list has gone: it is left out, and those behind it move up. */
export function withoutLandmark(names: readonly string[], gone: number): string[] {
  return names.flatMap((name) => {
    const number = Number(name);
    if (name === EXTRA || number <= gone) return [name];
    return number === gone + 1 ? [] : [String(number - 1)];
  });
}
