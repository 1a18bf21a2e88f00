// The service worker of a built page: which files it keeps, and a version that any change to them changes.
import { createHash } from 'node:crypto';
import { readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { join, relative, sep } from 'node:path';
import { root } from './run.mjs';

const workerName = 'service-worker.js';
/** Beside the page, for whoever asks for them; the page runs without. */
const apart = [workerName, 'licences.txt', 'source.tar.gz'];
/** The element, for other pages. */
const apartFolder = 'embed/';

/** Paths of the files that the page is made of, relative to its folder, sorted. */
export function pageFiles(folder) {
  return readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => relative(folder, join(entry.parentPath, entry.name)).split(sep).join('/'))
    .filter((path) => !apart.includes(path) && !path.startsWith(apartFolder))
    .sort();
}

/** Writes service-worker.js into the folder of a built page. */
export function writeServiceWorker(folder) {
  const files = pageFiles(folder);
  const template = readFileSync(join(root, 'web', 'service-worker.mjs'), 'utf8');
  const hash = createHash('sha256').update(template);
  for (const file of files) hash.update(`\0${file}\0`).update(readFileSync(join(folder, file)));
  const build = { version: hash.digest('hex').slice(0, 16), files: files.map((file) => `./${file}`) };
  writeFileSync(join(folder, workerName), `const build = ${JSON.stringify(build)};\n${template}`);
}
