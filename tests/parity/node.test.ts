import { beforeAll, describe, expect, test } from 'vitest';
import type { PlateauModule } from 'plateau-module';
import { file, loadModule, opened, runThrough } from '../wasm/module.ts';
import { clouds, commandHash, familiesFor } from './cases.ts';

let module: PlateauModule;
beforeAll(async () => {
  module = await loadModule();
});

describe.each(clouds())('the module computes what the command computes: $name', (cloud) => {
  test.each(familiesFor(cloud))('%s', (family) => {
    const expected = commandHash(cloud.text, family);
    expect(expected).toMatch(/^[0-9a-f]{16}$/);
    for (const budget of [1, Infinity]) {
      const run = new module.Run(file('cloud.xyz', cloud.text), { family });
      opened(run);
      runThrough(run, budget);
      expect(run.hash()).toBe(expected);
      run.delete();
    }
  });
});
