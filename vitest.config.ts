import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vitest/config';

const root = fileURLToPath(new URL('.', import.meta.url));

export default defineConfig({
  resolve: { alias: [{ find: /^plateau-module$/, replacement: `${root}build/wasm/bin/plateau.mjs` }] },
  test: {
    include: ['tests/{wasm,web,parity}/**/*.test.ts'],
    testTimeout: 120_000,
    // Two cores: each file has a module of its own to load.
    maxWorkers: 2,
  },
});
