import { mkdirSync, writeFileSync } from 'node:fs';

/** Random points of a torus, as a binary PLY file; its path. */
export function torusFile(size: number): string {
  let seed = 12345;
  const unit = (): number => (seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0) / 2 ** 32;
  const points = new Float32Array(3 * size);
  for (let i = 0; i < size;) {
    const [u, v] = [2 * Math.PI * unit(), 2 * Math.PI * unit()];
    const r = 1 + 0.4 * Math.cos(v);
    if (unit() * 1.4 > r) continue;
    points.set([r * Math.cos(u), r * Math.sin(u), 0.4 * Math.sin(v)], 3 * i);
    i += 1;
  }
  const axes = ['x', 'y', 'z'].map((axis) => `property float ${axis}\n`).join('');
  const head = `ply\nformat binary_little_endian 1.0\nelement vertex ${size}\n${axes}end_header\n`;
  const path = `build/scans/torus-${size}.ply`;
  mkdirSync('build/scans', { recursive: true });
  writeFileSync(path, Buffer.concat([Buffer.from(head), Buffer.from(points.buffer)]));
  return path;
}
