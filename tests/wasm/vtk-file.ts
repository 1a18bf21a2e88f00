/** A legacy VTK file of version 3.0 as its specification describes it, read without regard to who wrote it. */
export interface VtkFile {
  readonly title: string;
  /** Three numbers a point. */
  readonly points: Float64Array;
  readonly cells: readonly (readonly number[])[];
  readonly types: readonly number[];
  readonly cellData: ReadonlyMap<string, readonly number[]>;
  readonly pointData: ReadonlyMap<string, readonly number[]>;
}

export function readVtk(bytes: Uint8Array): VtkFile {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  let at = 0;
  const line = (): string => {
    const end = bytes.indexOf(10, at);
    const text = new TextDecoder().decode(bytes.subarray(at, end));
    at = end + 1;
    return text;
  };
  const words = (keyword: string): string[] => {
    const [first, ...rest] = line().split(' ');
    if (first !== keyword) throw new Error(`${keyword} is expected, not ${first ?? ''}`);
    return rest;
  };
  const numbers = (count: number, type: string): number[] => {
    const size = { int: 4, double: 8 }[type];
    if (size === undefined) throw new Error(`no type ${type}`);
    const read = Array.from({ length: count }, (_, i) =>
      type === 'int' ? view.getInt32(at + size * i) : view.getFloat64(at + size * i),
    );
    at += size * count;
    if (bytes[at++] !== 10) throw new Error('a line end is missing behind numbers');
    return read;
  };
  const fields = (tuples: number): Map<string, number[]> => {
    const [, count] = words('FIELD');
    return new Map(
      Array.from({ length: Number(count) }, () => {
        const [name = '', width, rows, type = ''] = line().split(' ');
        if (Number(rows) !== tuples) throw new Error(`${name} has ${String(rows)} rows, not ${tuples}`);
        return [name, numbers(Number(width) * tuples, type)];
      }),
    );
  };

  if (line() !== '# vtk DataFile Version 3.0') throw new Error('no VTK file');
  const title = line();
  if (title.length >= 256) throw new Error('the title is too long');
  words('BINARY');
  if (words('DATASET')[0] !== 'UNSTRUCTURED_GRID') throw new Error('no unstructured grid');
  const [pointCount, pointType = ''] = words('POINTS');
  const points = Float64Array.from(numbers(3 * Number(pointCount), pointType));
  const [cellCount, size] = words('CELLS');
  const lists = numbers(Number(size), 'int');
  const cells: number[][] = [];
  for (let i = 0; i < lists.length; i += 1 + (lists[i] ?? 0))
    cells.push(lists.slice(i + 1, i + 1 + (lists[i] ?? 0)));
  if (cells.length !== Number(cellCount)) throw new Error('another number of cells');
  if (words('CELL_TYPES')[0] !== cellCount) throw new Error('another number of types');
  const types = numbers(cells.length, 'int');
  if (words('CELL_DATA')[0] !== cellCount) throw new Error('another number of cell data');
  const cellData = fields(cells.length);
  if (words('POINT_DATA')[0] !== pointCount) throw new Error('another number of point data');
  const pointData = fields(Number(pointCount));
  if (at !== bytes.length) throw new Error(`${bytes.length - at} bytes are left over`);
  return { title, points, cells, types, cellData, pointData };
}
