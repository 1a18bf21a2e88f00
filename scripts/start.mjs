// npm start: from a fresh clone to the page. Uses nothing but Node.js itself.
// node scripts/start.mjs [--port N] [--yes]
import { join } from 'node:path';
import { buildWasm, buildWeb, isCurrent } from './build.mjs';
import { main, root } from './lib/run.mjs';
import { portFrom, serve } from './serve.mjs';
import { setup } from './setup.mjs';

await main(async () => {
  const words = process.argv.slice(2);
  const port = portFrom(words);
  // Where both are current nothing is built, and the machine needs no compiler.
  const build = !isCurrent('wasm') || !isCurrent('web');
  if (build) {
    await setup(['wasm', 'web'], { yes: words.includes('--yes') });
    if (!isCurrent('wasm')) await buildWasm();
    if (!isCurrent('web')) await buildWeb();
  }
  const { address } = await serve(join(root, 'web', 'dist'), { port });
  console.log(`\nPlateau is at ${address}  (Ctrl-C ends it)`);
});
