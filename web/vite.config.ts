import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { defineConfig, type Plugin } from 'vite';

const root = fileURLToPath(new URL('.', import.meta.url));

/** The page in parts: `<!-- part: help -->` stands for parts/help.html. */
const parts: Plugin = {
  name: 'parts',
  transformIndexHtml: {
    order: 'pre',
    handler: (html) =>
      html.replace(/<!-- part: ([a-z]+) -->/g, (_, name: string) =>
        readFileSync(`${root}parts/${name}.html`, 'utf8'),
      ),
  },
};

export default defineConfig({
  root,
  // Relative addresses: the built page works from any folder of any server.
  base: './',
  plugins: [parts],
  resolve: {
    alias: [
      { find: /^plateau-module$/, replacement: `${root}../build/wasm/bin/plateau.mjs` },
      { find: /^plateau-module\/wasm$/, replacement: `${root}../build/wasm/bin/plateau.wasm?url` },
    ],
  },
  server: { fs: { allow: [`${root}..`] } },
  worker: { format: 'es' },
  build: {
    outDir: 'dist',
    emptyOutDir: true,
    target: 'es2022',
    // Nothing as a data: address, or the content-security policy would have to allow it.
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
    chunkSizeWarningLimit: 900,
  },
});
