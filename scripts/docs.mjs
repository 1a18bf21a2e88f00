// Writes docs/api anew from the types of the package: node scripts/docs.mjs
import { isScript, main, run } from './lib/run.mjs';
import { setup } from './setup.mjs';

/** The reference of the package and the element; `out`: elsewhere than in docs/api. */
export async function writeDocs({ out } = {}) {
  await run('typedoc', ['--logLevel', 'Warn', ...(out ? ['--out', out] : [])]);
}

if (isScript(import.meta.url)) {
  await main(async () => {
    await setup(['web']);
    await writeDocs();
  });
}
