/** Points in a box whose coordinates are multiples of 1/1024; tests/core/cloud_files.cpp makes the same. */
export function scatteredPoints(size: number): number[] {
  let state = 12345;
  return Array.from({ length: 3 * size }, () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return (state >>> 20) / 1024 - 2;
  });
}

/** A file as the tests write it, sharing no code with the readers. */
export interface CloudFile {
  readonly what: string;
  readonly name: string;
  readonly bytes: Uint8Array;
}

type Order = 'rows' | 'columns';

function ordered(points: readonly number[], order: Order): readonly number[] {
  if (order === 'rows') return points;
  return [0, 1, 2].flatMap((axis) => points.filter((_, k) => k % 3 === axis));
}

function floats(points: readonly number[], littleEndian: boolean, order: Order = 'rows'): Uint8Array {
  const view = new DataView(new ArrayBuffer(4 * points.length));
  ordered(points, order).forEach((value, k) => view.setFloat32(4 * k, value, littleEndian));
  return new Uint8Array(view.buffer);
}

function doubles(points: readonly number[], littleEndian: boolean, order: Order = 'rows'): Uint8Array {
  const view = new DataView(new ArrayBuffer(8 * points.length));
  ordered(points, order).forEach((value, k) => view.setFloat64(8 * k, value, littleEndian));
  return new Uint8Array(view.buffer);
}

function joined(...parts: readonly (string | Uint8Array)[]): Uint8Array {
  return Uint8Array.from(parts.flatMap((part) => [...Buffer.from(part)]));
}

function rows(points: readonly number[], before: string, separator: string): string {
  let text = '';
  for (let k = 0; k < points.length; k += 3) {
    text += `${before}${points.slice(k, k + 3).join(separator)}\n`;
  }
  return text;
}

/** LZF data of literals alone, and one copy where the first bytes repeat. */
function lzf(bytes: Uint8Array): Uint8Array {
  const parts: number[] = [];
  for (let k = 0; k < bytes.length; k += 32) {
    const run = bytes.slice(k, k + 32);
    const [a, b, c] = bytes.slice(k - 3, k);
    const repeats = k >= 3 && run.length > 3 && a === run[0] && b === run[1] && c === run[2];
    if (repeats) parts.push(1 << 5, 2, run.length - 4, ...run.slice(3));
    else parts.push(run.length - 1, ...run);
  }
  return Uint8Array.from(parts);
}

function uint32(value: number): Uint8Array {
  return Uint8Array.of(value & 255, (value >> 8) & 255, (value >> 16) & 255, value >>> 24);
}

function npy(points: readonly number[], type: string, order: Order, values: Uint8Array): Uint8Array {
  const shape = `(${points.length / 3}, 3)`;
  const fortran = order === 'columns' ? 'True' : 'False';
  const text = `{'descr': '${type}', 'fortran_order': ${fortran}, 'shape': ${shape}, }`.padEnd(117) + '\n';
  return joined(Uint8Array.of(0x93), 'NUMPY', Uint8Array.of(1, 0, text.length, 0), text, values);
}

/** The points in every format and encoding that can be read. */
export function cloudFiles(points: readonly number[]): readonly CloudFile[] {
  const count = points.length / 3;
  const ply = (format: string, type: string): string =>
    `ply\nformat ${format} 1.0\nelement vertex ${count}\n` +
    ['x', 'y', 'z'].map((axis) => `property ${type} ${axis}\n`).join('') +
    'end_header\n';
  const pcd = (size: number, data: string): string =>
    `# .PCD v0.7\nVERSION 0.7\nFIELDS x y z\nSIZE ${size} ${size} ${size}\nTYPE F F F\nCOUNT 1 1 1\n` +
    `WIDTH ${count}\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS ${count}\nDATA ${data}\n`;
  const byColumns = floats(points, true, 'columns');
  const compressed = lzf(byColumns);
  const contents: readonly [string, string, Uint8Array][] = [
    ['xyz', 'xyz', joined(rows(points, '', ' '))],
    ['txt with a comment', 'txt', joined('# a scan\n', rows(points, '', '\t'))],
    ['csv with names', 'csv', joined('x,y,z\n', rows(points, '', ','))],
    ['ply ascii', 'ply', joined(ply('ascii', 'double'), rows(points, '', ' '))],
    ['ply little endian', 'ply', joined(ply('binary_little_endian', 'float'), floats(points, true))],
    ['ply big endian', 'ply', joined(ply('binary_big_endian', 'double'), doubles(points, false))],
    ['off', 'off', joined(`OFF\n${count} 0 0\n`, rows(points, '', ' '))],
    ['obj', 'obj', joined('o scan\n', rows(points, 'v ', ' '))],
    ['pcd ascii', 'pcd', joined(pcd(4, 'ascii'), rows(points, '', ' '))],
    ['pcd binary', 'pcd', joined(pcd(8, 'binary'), doubles(points, true))],
    [
      'pcd compressed',
      'pcd',
      joined(pcd(4, 'binary_compressed'), uint32(compressed.length), uint32(byColumns.length), compressed),
    ],
    ['npy by rows', 'npy', npy(points, '<f8', 'rows', doubles(points, true))],
    ['npy by columns', 'npy', npy(points, '<f4', 'columns', byColumns)],
    ['npy big endian', 'npy', npy(points, '>f8', 'rows', doubles(points, false))],
  ];
  return contents.map(([what, extension, bytes]) => ({
    what,
    name: `${what.replaceAll(' ', '-')}.${extension}`,
    bytes,
  }));
}
