import { readFileSync } from 'node:fs';
import { expect, test } from 'vitest';

const folder = new URL('../../build/wasm/bin/', import.meta.url);

interface SweepModule {
  sweep(rounds: number): { calls: number; mismatches: number };
  gridHash(edge: number, spacing: number): string;
}

async function loadSweep(): Promise<SweepModule> {
  const address = new URL('predicate_sweep.mjs', folder).href;
  const { default: create } = (await import(/* @vite-ignore */ address)) as {
    default: (options: { wasmBinary: Uint8Array }) => Promise<SweepModule>;
  };
  return create({ wasmBinary: readFileSync(new URL('predicate_sweep.wasm', folder)) });
}

test('every predicate has the sign of the exact determinant in WebAssembly', async () => {
  const module = await loadSweep();
  const { calls, mismatches } = module.sweep(4000);
  expect(calls).toBe(5 * 3 * 4000 * 6);
  expect(mismatches).toBe(0);
});

test('the Delaunay triangulation of a grid of spacing 0.1 ends, and is the native one', async () => {
  const module = await loadSweep();
  // The same constant as in tests/core/predicate_sweep_test.cpp.
  expect(module.gridHash(20, 0.1)).toBe('062319d005b19696');
}, 60_000);
