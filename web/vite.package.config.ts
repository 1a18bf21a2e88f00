import { fileURLToPath } from 'node:url';
import { defineConfig, type Plugin } from 'vite';

const root = fileURLToPath(new URL('.', import.meta.url));
const from = (path: string): string => `${root}src/${path}`;

/**
 * Name of the built file -> where it begins. Each is one ES module that needs nothing but plateau.wasm beside it; the
 * measured shapes are files of their own, which the element loads when they are asked for.
 */
const entries: Readonly<Record<string, string>> = {
  node: from('package/node.ts'),
  browser: from('package/browser.ts'),
  'plateau-view': from('embed/plateau-view.ts'),
  frame: from('embed/frame.ts'),
};

/** Emscripten's program asks for its module beside itself, which would be copied into every file; here it is handed over. */
const moduleIsHandedOver: Plugin = {
  name: 'module-is-handed-over',
  transform: (code, id) =>
    id.endsWith('/plateau.mjs')
      ? code.replace('new URL("plateau.wasm",import.meta.url).toString()', '"plateau.wasm"')
      : undefined,
};

/** Not this build, but one that takes the package in shall find the module by its address and bring it along. */
const addressForBundlers: Plugin = {
  name: 'address-for-bundlers',
  generateBundle: (_, bundle) => {
    for (const file of Object.values(bundle)) {
      if (file.type !== 'chunk') continue;
      file.code = file.code.replace(/\/\* @vite-ignore \*\/\s*(?=["'`]\.\/plateau\.wasm)/g, '');
    }
  },
};

/** One file of the package: vite build --config web/vite.package.config.ts --mode NAME. */
export default defineConfig(({ mode }) => ({
  root,
  publicDir: false,
  plugins: [moduleIsHandedOver, addressForBundlers],
  resolve: { alias: [{ find: /^plateau-module$/, replacement: `${root}../build/wasm/bin/plateau.mjs` }] },
  worker: { format: 'es', plugins: () => [moduleIsHandedOver] },
  build: {
    outDir: '../build/package',
    emptyOutDir: false,
    // Safari below 16.4 cannot even read static blocks: it shall get as far as being told that it is too old.
    target: mode === 'node' ? 'node20' : ['es2022', 'safari16.0'],
    minify: mode !== 'node',
    assetsInlineLimit: 0,
    lib: { entry: { [mode]: entries[mode] ?? '' }, formats: ['es'] },
    rolldownOptions: {
      external: [/^node:/],
      output: { minify: mode !== 'node', chunkFileNames: '[name].js' },
    },
    chunkSizeWarningLimit: 900,
  },
}));
