// docs/api says what the types say, and names every event and every error. Run by node --test.
import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, readdirSync, rmSync, statSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, relative } from 'node:path';
import { test } from 'node:test';
import { writeDocs } from '../../scripts/docs.mjs';
import { root } from '../../scripts/lib/run.mjs';

const committed = join(root, 'docs', 'api');

/** Path below the folder -> text. */
function pages(folder) {
  const files = readdirSync(folder, { recursive: true })
    .map((name) => join(folder, name))
    .filter((path) => statSync(path).isFile());
  return Object.fromEntries(files.sort().map((path) => [relative(folder, path), readFileSync(path, 'utf8')]));
}

test('the reference in docs/api is what the types make of it now', async () => {
  const folder = mkdtempSync(join(tmpdir(), 'plateau-docs-'));
  try {
    await writeDocs({ out: folder });
    assert.deepEqual(pages(committed), pages(folder), 'run npm run docs');
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
});

const source = (path) => readFileSync(join(root, 'web', 'src', path), 'utf8');
const element = readFileSync(join(committed, 'plateau', 'element.md'), 'utf8');

test('every error has its sentence in the reference', () => {
  const union = /export type ErrorCode =(.*?);\n\n/s.exec(source('client/plateau-error.ts'))?.[1] ?? '';
  const codes = [...union.matchAll(/\/\*\* ([^*]*) \*\/\s*\| '([a-z-]+)'/g)];
  assert.equal(codes.length, [...union.matchAll(/\| '/g)].length, 'an error without a sentence');
  assert.ok(codes.length > 12);
  const core = readFileSync(join(committed, 'plateau.md'), 'utf8');
  for (const [, sentence, code] of codes) assert.ok(core.includes(`- \`"${code}"\`: ${sentence}\n`), code);
  assert.match(element, /\(\.\.\/plateau\.md#errorcode\)/);
});

test('every property has a sentence', () => {
  for (const page of ['plateau.md', 'plateau/element.md']) {
    const rows = readFileSync(join(committed, page), 'utf8').match(/^\| <a id="property-.*$/gm);
    assert.ok(rows.length > 10);
    for (const row of rows) assert.doesNotMatch(row.replaceAll('\\|', ''), /^(\|[^|]*){3}\| - \|/, page);
  }
});

test('every event that an element sends is in the reference and in the guide', () => {
  const files = ['embed/plateau-view-element.ts', 'embed/telling-element.ts'];
  const sent = [
    ...files
      .map(source)
      .join('')
      .matchAll(/this\.emit\('(\w+)'/g),
  ].map(([, name]) => name);
  assert.deepEqual([...new Set(sent)].sort(), ['error', 'plateau', 'ready', 'step']);
  const guide = readFileSync(join(root, 'docs', 'embed.md'), 'utf8');
  for (const name of sent) {
    assert.match(element, new RegExp(`<a id="[^"]*"></a> \`${name}\`|\\| \`${name}\` \\|`), name);
    assert.ok(guide.includes(`| \`${name}\``), name);
  }
});

test('every attribute is in the guide', () => {
  const list = /export const ATTRIBUTES = \[([^\]]*)\]/.exec(source('embed/settings.ts'))?.[1] ?? '';
  const guide = readFileSync(join(root, 'docs', 'embed.md'), 'utf8');
  const told = [...guide.matchAll(/^\| (`[^|]*)\|/gm)].flatMap(([, cell]) => cell.match(/\w+/g));
  const names = [...list.matchAll(/'(\w+)'/g)].map(([, name]) => name);
  assert.ok(names.length > 10);
  for (const name of names) assert.ok(told.includes(name), name);
});
