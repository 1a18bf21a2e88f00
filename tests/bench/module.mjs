// One whole run of the module under Node, in a process of its own: the same line as run_bench prints.
// node tests/bench/module.mjs CLOUD N FAMILY; the cloud comes from run_bench, named by PLATEAU_BENCH.
/* global WebAssembly */
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';

const root = new URL('../../', import.meta.url);
const { default: createModule } = await import(new URL('build/wasm/bin/plateau.mjs', root).href);

const [cloud, size, family] = process.argv.slice(2);
const text = execFileSync(process.env.PLATEAU_BENCH, ['--write', cloud, size], { maxBuffer: 1 << 30 });
const bytes = text.buffer.slice(text.byteOffset, text.byteOffset + text.byteLength);

let memory;
const module = await createModule({
  instantiateWasm(imports, receive) {
    const program = new WebAssembly.Module(readFileSync(new URL('build/wasm/bin/plateau.wasm', root)));
    const instance = new WebAssembly.Instance(program, imports);
    // The name is the linker's and may be short: the only memory there is.
    memory = Object.values(instance.exports).find((each) => each instanceof WebAssembly.Memory);
    receive(instance);
    return instance.exports;
  },
});

const run = new module.Run({ kind: 'file', name: 'cloud.xyz', bytes }, { family });
let answer = run.open(Infinity);
while (answer.kind === 'reading') answer = run.open(Infinity);
if (answer.kind === 'failed') throw new Error(answer.failure.message);
const from = performance.now();
const processor = process.cpuUsage();
const progress = run.run(Infinity, 0xffffffff);
const seconds = (performance.now() - from) / 1000;
const { user, system } = process.cpuUsage(processor);
// Node.js compiles and collects in threads of its own.
const share = Math.min(1, (user + system) / 1e6 / seconds);
if (progress.kind === 'failed') throw new Error(progress.failure.message);
if (progress.state !== 'finished') throw new Error(progress.stopped?.message ?? progress.state);
run.delete();
// Linear memory never shrinks: its size is its peak.
console.log(JSON.stringify({ seconds, megabytes: memory.buffer.byteLength / 1e6, share }));
