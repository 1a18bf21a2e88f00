// A change to the core can move the line that a fault is put into; the full test would notice late.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { defect, readMutants } from '../../scripts/mutants.mjs';

test('every fault of mutants.json fits the sources', () => {
  const mutants = readMutants();
  assert.ok(mutants.length >= 20, `${mutants.length} faults`);
  const unfit = mutants.filter(defect).map((mutant) => `${mutant.file}, ${mutant.why}: ${defect(mutant)}`);
  assert.deepEqual(unfit, []);
});
