import { deflateRawSync } from 'node:zlib';

/** A file that is no point cloud, or a broken one, and what the visitor is told. */
export interface BadFile {
  readonly what: string;
  readonly name: string;
  readonly content: string | Uint8Array;
  readonly told: RegExp;
}

function bytes(...parts: readonly (string | readonly number[] | Uint8Array)[]): Uint8Array {
  return Uint8Array.from(parts.flatMap((part) => [...(typeof part === 'string' ? Buffer.from(part) : part)]));
}

/** Bytes without a pattern, always the same. */
function noise(length: number): Uint8Array {
  let state = 7;
  return Uint8Array.from({ length }, () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state >>> 24;
  });
}

const PNG = [0x89, 0x50, 0x4e, 0x47, 13, 10, 26, 10, 0, 0, 0, 13, 0x49, 0x48, 0x44, 0x52];
const ZIP = bytes('PK', [3, 4, 20, 0, 0, 0, 8, 0], noise(16), deflateRawSync(Buffer.from('0 0 0\n')));
const PLY = (count: number | string, format = 'ascii'): string =>
  `ply\nformat ${format} 1.0\nelement vertex ${count}\nproperty float x\nproperty float y\nproperty float z\nend_header\n`;
const PCD = (count: number, data: string): string =>
  `VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH ${count}\nHEIGHT 1\nPOINTS ${count}\nDATA ${data}\n`;
const NPY = (shape: string, type = '<f8'): Uint8Array => {
  const header = `{'descr': '${type}', 'fortran_order': False, 'shape': ${shape}, }`.padEnd(117) + '\n';
  return bytes([0x93], 'NUMPY', [1, 0, header.length, 0], header);
};

export const BAD_FILES: readonly BadFile[] = [
  { what: 'nothing', name: 'empty.xyz', content: '', told: /empty/i },
  { what: 'only white space', name: 'blank.txt', content: '\n \n\n', told: /no points|empty/i },
  { what: 'one point', name: 'one.xyz', content: '1 2 3\n', told: /one point/ },
  { what: 'NaN', name: 'nan.xyz', content: '0 0 0\n1 nan 0\n1 1 1\n', told: /Line 2.*not a finite number/ },
  {
    what: 'infinity',
    name: 'inf.csv',
    content: '0,0,0\n1,1,1\n1,-inf,0\n',
    told: /Line 3.*not a finite number/,
  },
  { what: 'ragged rows', name: 'ragged.csv', content: '0,0,0\n1,1,1\n\n1,0\n', told: /Line 4 has 2 columns/ },
  { what: 'a word among numbers', name: 'word.xyz', content: '0 0 0\n1 1 one\n', told: /Line 2.*one/ },
  { what: 'equal points', name: 'same.xyz', content: '1 2 3\n'.repeat(9), told: /All 9 points are the same/ },
  { what: 'numbers beyond all use', name: 'huge.xyz', content: '0 0 0\n1 1e200 1\n', told: /Line 2.*1e150/ },
  { what: 'a number beyond doubles', name: 'over.xyz', content: '0 0 0\n1 1e999 1\n', told: /Line 2/ },
  { what: 'one column', name: 'column.txt', content: '1\n2\n3\n', told: /column/ },
  {
    what: 'a letter',
    name: 'letter.txt',
    content: 'Dear reader,\nthis is no point cloud.\n',
    told: /number should be/,
  },
  { what: 'a picture', name: 'photo.png', content: bytes(PNG, noise(40)), told: /PNG/ },
  {
    what: 'a picture that says it is points',
    name: 'photo.xyz',
    content: bytes(PNG, noise(40)),
    told: /PNG/,
  },
  { what: 'an archive', name: 'scans.zip', content: ZIP, told: /zip/i },
  { what: 'a document', name: 'paper.pdf', content: '%PDF-1.7\n1 0 obj\n', told: /PDF/ },
  { what: 'bytes without meaning', name: 'random.bin', content: noise(300), told: /binary data/ },
  { what: 'bytes that say they are points', name: 'random.xyz', content: noise(300), told: /binary data/ },
  {
    what: 'binary after a good beginning',
    name: 'broken.csv',
    content: bytes('0,0,0\n1,1,1\n', noise(90)),
    told: /binary data/,
  },
  {
    what: 'ply cut in its header',
    name: 'head.ply',
    content: PLY(3).slice(0, 60),
    told: /Line 5 of the PLY header/,
  },
  {
    what: 'ply cut in its points',
    name: 'cut.ply',
    content: PLY(3) + '0 0 0\n1 1 1\n',
    told: /promises 3 rows .* ends after 2/,
  },
  {
    what: 'binary ply cut in its points',
    name: 'cut-binary.ply',
    content: bytes(PLY(3, 'binary_little_endian'), noise(20)),
    told: /promises 3 rows .* ends after 1/,
  },
  {
    what: 'ply that promises too much',
    name: 'lies.ply',
    content: PLY(4_000_000_000) + '0 0 0\n',
    told: /promises 4000000000 rows/,
  },
  { what: 'ply without a count', name: 'count.ply', content: PLY('many'), told: /Line 3 of the PLY header/ },
  {
    what: 'ply without coordinates',
    name: 'bare.ply',
    content: PLY(2).replace(/property.*\n/g, ''),
    told: /no properties x and y/,
  },
  {
    what: 'npy cut in its values',
    name: 'cut.npy',
    content: bytes(NPY('(4, 3)'), noise(50)),
    told: /promises .* only 6 are there/,
  },
  {
    what: 'npy cut in its header',
    name: 'head.npy',
    content: NPY('(4, 3)').slice(0, 40),
    told: /ends within its header/,
  },
  {
    what: 'npy that promises too much',
    name: 'lies.npy',
    content: NPY('(9000000000000000000, 3)'),
    told: /promises .* only 0 are there/,
  },
  {
    what: 'npy of words',
    name: 'words.npy',
    content: NPY('(4, 3)', '<U8'),
    told: /values of type .*real numbers/,
  },
  {
    what: 'pcd cut in its points',
    name: 'cut.pcd',
    content: bytes(PCD(5, 'binary'), noise(30)),
    told: /promises 5 points/,
  },
  {
    what: 'pcd cut when packed',
    name: 'packed.pcd',
    content: bytes(PCD(5, 'binary_compressed'), [9, 0]),
    told: /promises 5 points/,
  },
  {
    what: 'pcd packed by another rule',
    name: 'rubbish.pcd',
    content: bytes(PCD(5, 'binary_compressed'), [20, 0, 0, 0, 60, 0, 0, 0], noise(20)),
    told: /damaged/,
  },
  {
    what: 'pcd that promises too much',
    name: 'lies.pcd',
    content: PCD(4_000_000_000, 'ascii') + '0 0 0\n',
    told: /promises 4000000000 points/,
  },
  {
    what: 'off that promises too much',
    name: 'lies.off',
    content: 'OFF\n900 0 0\n0 0 0\n',
    told: /promises 900 vertices/,
  },
  { what: 'obj without vertices', name: 'faces.obj', content: 'f 1 2 3\n', told: /no points/ },
];
