// The layers hold, and the check that says so notices each kind of violation. Run by node --test.
import assert from 'node:assert/strict';
import { cpSync, existsSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { layers, violationsIn } from './check.mjs';

const root = fileURLToPath(new URL('../..', import.meta.url));
let copy;

before(() => {
  copy = mkdtempSync(join(tmpdir(), 'plateau-layers-'));
  for (const folder of ['core', 'wasm', 'web/src']) {
    if (existsSync(join(root, folder))) cpSync(join(root, folder), join(copy, folder), { recursive: true });
  }
});
after(() => rmSync(copy, { recursive: true, force: true }));

test('every include and import follows the table', () => {
  const { violations, files } = violationsIn(root);
  assert.deepEqual(violations, []);
  assert.ok(files > 20, `only ${files} files were seen`);
});

test('the table itself goes one way', () => {
  const seen = new Set();
  for (const [room, allowed] of Object.entries(layers.cpp)) {
    for (const other of allowed)
      assert.ok(seen.has(other), `${room} names ${other}, which does not come before it`);
    seen.add(room.replace('core/', ''));
  }
});

/** Plants files into the copy and expects exactly one violation, which says what the pattern says. */
function planted(name, files, pattern) {
  test(`a planted violation is rejected: ${name}`, () => {
    for (const [path, text] of Object.entries(files)) {
      mkdirSync(dirname(join(copy, path)), { recursive: true });
      writeFileSync(join(copy, path), text);
    }
    try {
      const known = new Set(violationsIn(root).violations);
      const found = violationsIn(copy).violations.filter((violation) => !known.has(violation));
      assert.equal(found.length, 1, `found: ${found.join('; ') || 'nothing'}`);
      assert.match(found[0], pattern);
    } finally {
      for (const path of Object.keys(files)) rmSync(join(copy, path));
    }
  });
}

planted(
  'a room includes a later one',
  { 'core/homology/planted.h': '#include "session/session.h"\n' },
  /^core\/homology\/planted\.h: core\/homology may not include session\/session\.h/,
);
planted(
  'the module reaches past the session',
  { 'wasm/planted.cpp': '#include "complex/simplex_table.h"\n' },
  /^wasm\/planted\.cpp: wasm may not include/,
);
planted(
  'a reader of point files knows the session',
  { 'core/io/planted.h': '#include "session/session.h"\n' },
  /^core\/io\/planted\.h: core\/io may not include session\/session\.h/,
);
planted(
  'CGAL outside its room',
  { 'core/complex/planted.h': '#include <CGAL/Object.h>\n' },
  /<CGAL\/Object\.h> is not for/,
);
planted(
  'a standard stream in the core',
  { 'core/session/planted.h': '#include <iostream>\n' },
  /<iostream> is not for/,
);
planted('an unknown room', { 'core/attic/planted.h': '#pragma once\n' }, /core\/attic is not a room/);
planted(
  'two headers that need each other',
  {
    'core/base/planted_a.h': '#include "base/planted_b.h"\n',
    'core/base/planted_b.h': '#include "base/planted_a.h"\n',
  },
  /^cycle: core\/base\/planted_a\.h -> core\/base\/planted_b\.h -> core\/base\/planted_a\.h$/,
);
planted('a file that is too long', { 'core/base/planted.h': '\n'.repeat(401) }, /401 lines/);
planted(
  'the worker imports the view',
  {
    'web/src/worker/planted.ts': "import { draw } from '../view/planted';\n",
    'web/src/view/planted.ts': 'export {};\n',
  },
  /^web\/src\/worker\/planted\.ts: worker may not import/,
);
planted(
  'three outside the view',
  { 'web/src/model/planted.ts': "import { Vector3 } from 'three/webgpu';\n" },
  /three\/webgpu is only for view/,
);
