// Builds and runs every benchmark: native ones of tests/bench/*.cpp, then tests/bench/*.mjs, which time the module
// against them. node scripts/bench.mjs [arguments for Google Benchmark]
import { basename, join } from 'node:path';
import { buildNative, buildWasm, isCurrent, nativeFolder } from './build.mjs';
import { projectFiles } from './lib/files.mjs';
import { Failure, main, run } from './lib/run.mjs';
import { setup } from './setup.mjs';

await main(async () => {
  const natives = projectFiles(/^tests\/bench\/[^/]+\.cpp$/);
  const scripts = projectFiles(/^tests\/bench\/[^/]+\.mjs$/);
  if (natives.length + scripts.length === 0) throw new Failure('There is no benchmark in tests/bench.');
  await setup(['native', 'wasm', 'web']);
  await buildNative();
  if (scripts.length > 0 && !isCurrent('wasm')) await buildWasm();
  for (const source of natives)
    await run(join(nativeFolder, 'bin', basename(source, '.cpp')), process.argv.slice(2));
  for (const script of scripts) await run(process.execPath, [script]);
});
