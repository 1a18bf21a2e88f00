// Static checks: ESLint and the TypeScript compiler; with --cpp also clang-tidy, which takes minutes.
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { nativeFolder } from './build.mjs';
import { cppSources, scriptFiles, tsconfigs } from './lib/files.mjs';
import { Failure, isScript, main, run } from './lib/run.mjs';
import { setup } from './setup.mjs';

/** ESLint over page, scripts and tests; every tsconfig compiles. */
export async function lint() {
  const files = scriptFiles().filter((path) => /\.(ts|mjs)$/.test(path));
  console.log(`ESLint: ${files.length} files.`);
  await run('eslint', ['--max-warnings=0', ...files], { echo: false });
  for (const config of tsconfigs()) {
    if (!/base/.test(config)) await run('tsc', ['--noEmit', '-p', config]);
  }
}

/** clang-tidy over the core, with the flags of the native build. */
export async function lintCpp() {
  if (!existsSync(join(nativeFolder, 'compile_commands.json'))) {
    throw new Failure('clang-tidy reads the flags of the native build: run npm run build:native first.');
  }
  // The flags are those of g++, and clang does not know all of its warnings.
  const args = [
    '-p',
    nativeFolder,
    '--quiet',
    '--warnings-as-errors=*',
    '--extra-arg=-Wno-unknown-warning-option',
  ];
  for (const source of cppSources()) await run('clang-tidy', [...args, source]);
}

if (isScript(import.meta.url)) {
  await main(async () => {
    const cpp = process.argv.includes('--cpp');
    await setup(cpp ? ['style', 'native', 'web'] : ['web']);
    await lint();
    if (cpp) await lintCpp();
  });
}
