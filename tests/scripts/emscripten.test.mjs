// Setup sees the one conflict that has a way around it, and no other. Run by node --test.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { conflictsWithNode } from '../../scripts/lib/emscripten.mjs';

test("apt's refusal over nodejs:any is recognized", () => {
  const refusal = [
    'The following packages have unmet dependencies:',
    ' node-acorn : Depends: nodejs:any or',
    '                       nodejs (< 12.22.5~dfsg-4~) but 20.20.2-1nodesource1 is to be installed',
    'E: Unable to correct problems, you have held broken packages.',
  ];
  assert.ok(conflictsWithNode(refusal.join('\n')));
});

test('other refusals are not', () => {
  assert.ok(!conflictsWithNode('E: Unable to locate package emscripten'));
  assert.ok(!conflictsWithNode('The following packages have unmet dependencies:\n g++ : Depends: g++-12'));
});
