/** A point of the board; whole numbers, x to the right, y upwards. */
export interface Point {
  readonly x: number;
  readonly y: number;
}

/** The board in its own units. Whole coordinates make exact ties possible, and links short. */
export const BOARD = { width: 120, height: 80 } as const;

const round = (value: number, largest: number): number => Math.min(largest, Math.max(0, Math.round(value)));

/** The nearest point that the board has. */
export function onBoard(x: number, y: number): Point {
  return { x: round(x, BOARD.width), y: round(y, BOARD.height) };
}

/** "20,30 45,12"; semicolons and underscores separate as well, for addresses. */
export function parsePoints(text: string): Point[] {
  const entries = text.split(/[\s;_]+/).filter((entry) => entry !== '');
  return entries.map((entry) => {
    const match = /^(\d+(?:\.\d+)?),(\d+(?:\.\d+)?)$/.exec(entry);
    if (!match) throw new Error(`"${entry}" is no point: write x,y with a space between points.`);
    return onBoard(Number(match[1]), Number(match[2]));
  });
}

export function formatPoints(points: readonly Point[]): string {
  return points.map(({ x, y }) => `${x},${y}`).join(' ');
}

/** As the core takes them: x and y in turn. */
export function flat(points: readonly Point[]): Float64Array {
  return Float64Array.from(points.flatMap(({ x, y }) => [x, y]));
}

export function samePlace(a: Point, b: Point): boolean {
  return a.x === b.x && a.y === b.y;
}

/** Whether a cell has anything to be drawn. */
export const drawn = ({ corners }: { readonly corners: readonly Point[] }): boolean => corners.length > 2;
