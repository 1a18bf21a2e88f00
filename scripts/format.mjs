// Formats every source file; with --check it only says which are not formatted.
import { cppFiles, scriptFiles } from './lib/files.mjs';
import { isScript, main, run } from './lib/run.mjs';
import { setup } from './setup.mjs';

/** Formats the tree, or fails on the first tool that finds an unformatted file. */
export async function format({ check = false } = {}) {
  const cpp = cppFiles();
  const scripts = scriptFiles();
  console.log(
    `${check ? 'Checking' : 'Formatting'} ${cpp.length} C++ files and ${scripts.length} scripts and page files.`,
  );
  const quiet = { echo: false };
  if (cpp.length > 0)
    await run('clang-format', [...(check ? ['--dry-run', '-Werror'] : ['-i']), ...cpp], quiet);
  if (scripts.length > 0) {
    await run('prettier', ['--log-level=warn', check ? '--check' : '--write', ...scripts], quiet);
  }
}

if (isScript(import.meta.url)) {
  await main(async () => {
    await setup(['style', 'web']);
    await format({ check: process.argv.includes('--check') });
  });
}
