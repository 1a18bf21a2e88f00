import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { defineConfig, type Plugin } from 'vite';
import { COURSE_FILES, coursePage } from './course/pages.ts';

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

/** The frame and the formulas of the course. */
const course: Plugin = {
  name: 'course',
  transformIndexHtml: {
    order: 'pre',
    handler: (html, { path }) => {
      const file = /^\/course\/([a-z-]+)\.html$/.exec(path)?.[1];
      return file === undefined ? html : coursePage(html, file);
    },
  },
};

const pages = ['index', ...COURSE_FILES.map((file) => `course/${file}`)];

export default defineConfig({
  root,
  // Relative addresses: the built page works from any folder of any server.
  base: './',
  plugins: [parts, course],
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
    // Safari below 16.4 cannot even read static blocks: it shall get as far as being told that it is too old.
    target: ['es2022', 'safari16.0'],
    // Nothing as a data: address, or the content-security policy would have to allow it.
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
    chunkSizeWarningLimit: 900,
    rolldownOptions: {
      input: pages.map((page) => `${root}${page}.html`),
      // By itself, so that its name does not depend on which module happens to use it first.
      output: { codeSplitting: { groups: [{ name: 'three', test: /node_modules[\\/]three[\\/]/ }] } },
    },
  },
});
