// The static server: right types, a strict policy, nothing outside its folder. Run by node --test.
import assert from 'node:assert/strict';
import { mkdirSync, mkdtempSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { request } from 'node:http';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { portFrom, serve } from '../../scripts/serve.mjs';

let base;
let folder;
let running;

before(async () => {
  base = mkdtempSync(join(tmpdir(), 'plateau-serve-'));
  folder = join(base, 'page');
  mkdirSync(join(folder, 'assets'), { recursive: true });
  writeFileSync(join(base, 'secret.txt'), 'secret');
  // A neighbor whose name begins like the folder's.
  mkdirSync(join(base, 'page-two'));
  writeFileSync(join(base, 'page-two', 'secret.txt'), 'secret');
  writeFileSync(join(folder, 'index.html'), '<!doctype html><title>Plateau</title>');
  mkdirSync(join(folder, 'course'));
  writeFileSync(join(folder, 'course', 'index.html'), '<!doctype html><title>Course</title>');
  writeFileSync(join(folder, 'assets', 'core.wasm'), 'asm');
  writeFileSync(join(folder, 'assets', 'app.js'), 'export {};');
  symlinkSync(join(base, 'secret.txt'), join(folder, 'link.txt'));
  running = await serve(folder, { port: 0 });
});
after(() => {
  running.server.closeAllConnections();
  running.server.close();
  rmSync(base, { recursive: true, force: true });
});

/** One request with the path exactly as written; fetch would tidy it up first. */
function ask(path, { method = 'GET', headers = {} } = {}) {
  return new Promise((done, fail) => {
    const port = running.server.address().port;
    const sent = request({ host: '127.0.0.1', port, path, method, headers }, (response) => {
      let body = '';
      response.on('data', (part) => (body += part));
      response.on('end', () => done({ status: response.statusCode, headers: response.headers, body }));
    });
    sent.on('error', fail);
    sent.end();
  });
}

test('the page comes with a strict policy', async () => {
  const { status, headers, body } = await ask('/');
  assert.equal(status, 200);
  assert.match(headers['content-type'], /^text\/html/);
  assert.match(body, /Plateau/);
  const policy = headers['content-security-policy'];
  assert.match(policy, /default-src 'self'/);
  assert.match(policy, /script-src 'self' 'wasm-unsafe-eval'(;|$)/);
  assert.doesNotMatch(policy, /unsafe-inline|'unsafe-eval'|\*/);
});

test('every site may show the course in a frame; all else of its policy is as strict', async () => {
  const of = async (path) => (await ask(path)).headers['content-security-policy'];
  assert.match(await of('/course/'), /frame-ancestors \*$/);
  assert.match(await of('/'), /frame-ancestors 'self'$/);
  assert.equal((await of('/course/')).replace('frame-ancestors *', "frame-ancestors 'self'"), await of('/'));
});

test('module and scripts have the types that browsers ask for', async () => {
  assert.equal((await ask('/assets/core.wasm?v=1')).headers['content-type'], 'application/wasm');
  assert.match((await ask('/assets/app.js')).headers['content-type'], /^text\/javascript/);
});

test('nothing outside the folder is served', async () => {
  const paths = [
    '/../secret.txt',
    '/%2e%2e/secret.txt',
    '/assets/..%2f..%2fsecret.txt',
    '/../page-two/secret.txt',
    '/link.txt',
    '/%00',
    '/%zz',
    '/..',
    'http://elsewhere/',
  ];
  for (const path of paths) {
    const { status, body } = await ask(path);
    assert.equal(status, 404, path);
    assert.doesNotMatch(body, /secret/, path);
  }
});

test('HEAD has no body, other methods are refused, a known file is not sent twice', async () => {
  const head = await ask('/index.html', { method: 'HEAD' });
  assert.equal(head.status, 200);
  assert.equal(head.body, '');
  assert.equal((await ask('/', { method: 'POST' })).status, 405);
  const again = await ask('/index.html', { headers: { 'If-None-Match': head.headers.etag } });
  assert.equal(again.status, 304);
});

test('what compresses is sent compressed to who takes it', async () => {
  const text = '<!doctype html>' + 'plateau '.repeat(1000);
  writeFileSync(join(folder, 'long.html'), text);
  writeFileSync(join(folder, 'long.gz'), text);
  const port = running.server.address().port;
  const fetched = (path, accepted) =>
    fetch(`http://127.0.0.1:${port}/${path}`, { headers: { 'Accept-Encoding': accepted } });
  const zipped = await fetched('long.html', 'gzip, deflate');
  assert.equal(zipped.headers.get('content-encoding'), 'gzip');
  assert.equal(zipped.headers.get('vary'), 'Accept-Encoding');
  assert.ok(Number(zipped.headers.get('content-length')) < 200);
  assert.equal(await zipped.text(), text);
  for (const accepted of ['identity', 'br', 'gzip;q=0', 'xgzip']) {
    const plain = await fetched('long.html', accepted);
    assert.equal(plain.headers.get('content-encoding'), null, accepted);
    assert.notEqual(plain.headers.get('etag'), zipped.headers.get('etag'));
    assert.equal(await plain.text(), text);
  }
  assert.equal((await fetched('long.gz', 'gzip')).headers.get('content-encoding'), null);
  writeFileSync(join(folder, 'long.html'), text + 'new');
  assert.equal(await (await fetched('long.html', 'gzip')).text(), text + 'new');
});

test('a port that is named and taken is refused with a sentence', async () => {
  const { port } = running.server.address();
  await assert.rejects(serve(folder, { port }), /is taken/);
  assert.equal(portFrom(['--port', '4200']), 4200);
  assert.equal(portFrom(['--port=4200']), 4200);
  assert.equal(portFrom([]), undefined);
  assert.throws(() => portFrom(['--port']), /takes a number/);
  assert.throws(() => portFrom(['--port', '70000']), /takes a number/);
});
