// The module against the native build: the same clouds, the same runs, in turn; medians and their ratio.
// node tests/bench/module.mjs [N]
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

const root = new URL('../../', import.meta.url);
const native = fileURLToPath(new URL('build/native/bin/run_bench', root));
const { default: createModule } = await import(new URL('build/wasm/bin/plateau.mjs', root).href);
const module = await createModule({ wasmBinary: readFileSync(new URL('build/wasm/bin/plateau.wasm', root)) });

const size = process.argv[2] ?? '10000';
const rounds = 3;
const median = (values) => [...values].sort((a, b) => a - b)[values.length >> 1];

function moduleMilliseconds(bytes, family) {
  const source = { kind: 'file', name: 'cloud.xyz', bytes: bytes.slice(0) };
  const run = new module.Run(source, { family });
  let answer = run.open(Infinity);
  while (answer.kind === 'reading') answer = run.open(Infinity);
  if (answer.kind === 'failed') throw new Error(answer.failure.message);
  const from = performance.now();
  const progress = run.run(Infinity, 0xffffffff);
  const time = performance.now() - from;
  if (progress.kind === 'failed') throw new Error(progress.failure.message);
  run.delete();
  return time;
}

console.log(`module under Node against native, n = ${size} (medians of ${rounds})`);
for (const cloud of ['torus', 'cube']) {
  const text = execFileSync(native, ['--write', cloud, size], { maxBuffer: 1 << 30 });
  const bytes = text.buffer.slice(text.byteOffset, text.byteOffset + text.byteLength);
  for (const family of ['delaunay', 'auto']) {
    const times = { native: [], module: [] };
    for (let round = 0; round < rounds; round++) {
      times.native.push(Number(execFileSync(native, ['--session', cloud, size, family])));
      times.module.push(moduleMilliseconds(bytes, family));
    }
    const [a, b] = [median(times.native), median(times.module)];
    const row = `  ${cloud.padEnd(6)} ${family.padEnd(9)}`;
    console.log(
      `${row} native ${a.toFixed(0).padStart(7)} ms  module ${b.toFixed(0).padStart(7)} ms  ratio ${(b / a).toFixed(2)}`,
    );
  }
}
