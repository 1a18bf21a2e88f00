// A small static server for the built page: node scripts/serve.mjs [folder] [--port N]
// With --port it takes exactly that port; without, 4173 or the next free one. Local only, read only.
import { createReadStream } from 'node:fs';
import { readFile, realpath, stat } from 'node:fs/promises';
import { createServer } from 'node:http';
import { extname, join, relative, resolve, sep } from 'node:path';
import { pipeline } from 'node:stream/promises';
import { promisify } from 'node:util';
import { gzip } from 'node:zlib';
import { Failure, isScript, main, root } from './lib/run.mjs';

export const defaultPort = 4173;

const types = {
  '.css': 'text/css; charset=utf-8',
  '.csv': 'text/csv; charset=utf-8',
  '.gz': 'application/gzip',
  '.html': 'text/html; charset=utf-8',
  '.ico': 'image/x-icon',
  '.jpg': 'image/jpeg',
  '.js': 'text/javascript; charset=utf-8',
  '.json': 'application/json',
  '.map': 'application/json',
  '.md': 'text/markdown; charset=utf-8',
  '.mjs': 'text/javascript; charset=utf-8',
  '.png': 'image/png',
  '.svg': 'image/svg+xml',
  '.ico': 'image/x-icon',
  '.txt': 'text/plain; charset=utf-8',
  '.wasm': 'application/wasm',
  '.webmanifest': 'application/manifest+json',
  '.woff2': 'font/woff2',
};

/** What the page may do: run its own code and its own module, nothing else. */
export const contentSecurityPolicy = [
  "default-src 'self'",
  "script-src 'self' 'wasm-unsafe-eval'",
  "worker-src 'self'",
  "style-src 'self'",
  "img-src 'self' data: blob:",
  "connect-src 'self'",
  "object-src 'none'",
  "base-uri 'none'",
  "form-action 'none'",
  "frame-ancestors 'self'",
].join('; ');

/** What the page for iframes may do: its worker starts from a blob, and every page may show it. */
const framePolicy = contentSecurityPolicy
  .replace("worker-src 'self'", 'worker-src blob:')
  .replace("frame-ancestors 'self'", 'frame-ancestors *');

const headers = {
  'Content-Security-Policy': contentSecurityPolicy,
  'X-Content-Type-Options': 'nosniff',
  'Referrer-Policy': 'no-referrer',
};

/** Where the element lies that pages of other origins take. */
const shared = {
  ...headers,
  'Content-Security-Policy': framePolicy,
  'Access-Control-Allow-Origin': '*',
  'Cross-Origin-Resource-Policy': 'cross-origin',
};

/** The course: its worker is of the page's own origin, and every page may show it in a frame. */
const framed = {
  ...headers,
  'Content-Security-Policy': contentSecurityPolicy.replace("frame-ancestors 'self'", 'frame-ancestors *'),
};

function headersFor(folder, file) {
  const path = relative(folder, file);
  if (path.startsWith(`embed${sep}`)) return shared;
  return path.startsWith(`course${sep}`) ? framed : headers;
}

/** The file that the address names, or undefined: nothing outside the folder, also not through a link. */
async function fileFor(folder, url) {
  let path;
  try {
    path = decodeURIComponent(url.split(/[?#]/, 1)[0]);
  } catch {
    return undefined;
  }
  if (!path.startsWith('/') || path.includes('\0')) return undefined;
  try {
    const base = await realpath(folder);
    let file = await realpath(join(base, path));
    if (file !== base && !file.startsWith(base + sep)) return undefined;
    if ((await stat(file)).isDirectory()) file = await realpath(join(file, 'index.html'));
    const info = await stat(file);
    return info.isFile() && file.startsWith(base + sep) ? { base, file, info } : undefined;
  } catch {
    return undefined;
  }
}

const compressible = new Set(['.css', '.html', '.js', '.json', '.mjs', '.svg', '.txt', '.wasm']);

function takesGzip(request) {
  const accepted = String(request.headers['accept-encoding'] ?? '');
  return /(^|,)\s*gzip\s*(,|;\s*q=(?!0(\.0*)?\s*(,|$))|$)/.test(accepted);
}

const gzipped = promisify(gzip);
/** file -> the compressed body and the tag of the file that it was made of. */
const bodies = new Map();

/** The compressed file; made once for each of its states. */
async function zipped(file, etag) {
  const known = bodies.get(file);
  if (known?.etag === etag) return known.body;
  const body = await gzipped(await readFile(file), { level: 9 });
  bodies.set(file, { etag, body });
  return body;
}

async function answer(folder, request, response) {
  if (request.method !== 'GET' && request.method !== 'HEAD') {
    response.writeHead(405, { ...headers, Allow: 'GET, HEAD' }).end();
    return;
  }
  const found = await fileFor(folder, request.url ?? '');
  if (!found) {
    response.writeHead(404, { ...headers, 'Content-Type': 'text/plain; charset=utf-8' }).end('not found\n');
    return;
  }
  const { base, file, info } = found;
  const extension = extname(file).toLowerCase();
  const zip = compressible.has(extension) && takesGzip(request);
  const etag = `"${info.size.toString(16)}-${Math.round(info.mtimeMs).toString(16)}${zip ? '-gz' : ''}"`;
  const about = {
    ...headersFor(base, file),
    ETag: etag,
    'Cache-Control': 'no-cache',
    Vary: 'Accept-Encoding',
  };
  if (request.headers['if-none-match'] === etag) {
    response.writeHead(304, about).end();
    return;
  }
  const type = types[extension] ?? 'application/octet-stream';
  if (zip) {
    const body = await zipped(file, etag);
    const more = { 'Content-Type': type, 'Content-Encoding': 'gzip', 'Content-Length': body.length };
    response.writeHead(200, { ...about, ...more }).end(request.method === 'HEAD' ? undefined : body);
    return;
  }
  response.writeHead(200, { ...about, 'Content-Type': type, 'Content-Length': info.size });
  if (request.method === 'HEAD') response.end();
  else await pipeline(createReadStream(file), response);
}

function listen(server, port) {
  return new Promise((done, fail) => {
    server.once('error', fail);
    server.listen(port, '127.0.0.1', () => {
      server.off('error', fail);
      done(server.address().port);
    });
  });
}

/** Serves the folder on 127.0.0.1; `port` is taken as it is, without it 4173 or the next free one. */
export async function serve(folder, { port } = {}) {
  const server = createServer((request, response) => {
    // A visitor who leaves in the middle of a file is no error of ours.
    answer(folder, request, response).catch(() => response.destroy());
  });
  const candidates = port === undefined ? Array.from({ length: 100 }, (_, i) => defaultPort + i) : [port];
  for (const candidate of candidates) {
    try {
      const taken = await listen(server, candidate);
      return { server, address: `http://127.0.0.1:${taken}/` };
    } catch (error) {
      if (error.code !== 'EADDRINUSE' && error.code !== 'EACCES') throw error;
    }
  }
  throw new Failure(
    port === undefined
      ? 'No free port from 4173 to 4272.'
      : `Port ${port} is taken; choose another with --port.`,
  );
}

/** The number after --port, or undefined. */
export function portFrom(words) {
  const place = words.findIndex((word) => word === '--port' || word.startsWith('--port='));
  if (place < 0) return undefined;
  const text = words[place].includes('=') ? words[place].slice('--port='.length) : words[place + 1];
  const port = Number(text);
  if (!text || !Number.isInteger(port) || port < 0 || port > 65535)
    throw new Failure('--port takes a number from 0 to 65535.');
  return port;
}

if (isScript(import.meta.url)) {
  await main(async () => {
    const words = process.argv.slice(2);
    const port = portFrom(words);
    const folder =
      words.find((word, i) => !word.startsWith('--') && words[i - 1] !== '--port') ??
      join(root, 'web', 'dist');
    const { address } = await serve(resolve(folder), { port });
    console.log(`Serving ${folder} at ${address}`);
  });
}
