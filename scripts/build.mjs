// Builds the command, the module, the package and the page: node scripts/build.mjs [native] [wasm] [package] [web]
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync, readdirSync, statSync, writeFileSync } from 'node:fs';
import { availableParallelism, totalmem } from 'node:os';
import { dirname, join } from 'node:path';
import { Failure, isScript, main, root, run } from './lib/run.mjs';
import { writeLicencesAndSource } from './lib/licences.mjs';
import { writeServiceWorker } from './lib/offline.mjs';
import { addElement, makePackage } from './lib/package.mjs';
import { setup } from './setup.mjs';

/** Compile jobs: one translation unit with CGAL takes well over a gigabyte. */
export const jobs = Math.max(1, Math.min(availableParallelism(), Math.floor(totalmem() / 1.5e9)));

async function cmake(folder, settings, { configure = ['cmake'], targets = [] } = {}) {
  const [program, ...words] = configure;
  const args = [
    '-S',
    root,
    '-B',
    folder,
    '-G',
    'Ninja',
    '-DCMAKE_BUILD_TYPE=Release',
    '-DPLATEAU_WERROR=ON',
    ...settings,
  ];
  await run(program, [...words, ...args]);
  await run('cmake', [
    '--build',
    folder,
    '-j',
    String(jobs),
    ...targets.flatMap((target) => ['--target', target]),
  ]);
}

export const nativeFolder = join(root, 'build', 'native');
export const wasmFolder = join(root, 'build', 'wasm');

/** `targets`: not all, but these. */
export async function buildNative({ targets = [] } = {}) {
  await cmake(nativeFolder, [], { targets });
}

export const sanitizedFolder = join(root, 'build', 'sanitized');

/** The native build once more, with the address and undefined-behavior sanitizers. */
export async function buildSanitized() {
  // Sanitized code makes GCC see uninitialized values in headers that are not ours; the plain build judges warnings.
  await cmake(sanitizedFolder, ['-DPLATEAU_SANITIZE=ON', '-DPLATEAU_WERROR=OFF']);
}

/** `checks`: also the modules that only tests load. */
export async function buildWasm({ checks = false } = {}) {
  const targets = checks ? ['all', 'predicate_sweep'] : [];
  await cmake(wasmFolder, [], { configure: ['emcmake', 'cmake'], targets });
  writeStamp('wasm');
}

/** The core for Node.js and browsers and the element, ready for npm pack. */
export async function buildPackage() {
  await makePackage();
  writeStamp('package');
}

export async function buildWeb() {
  // The page brings the element along, for other pages.
  if (!isCurrent('package')) await buildPackage();
  await run('vite', ['build', 'web']);
  addElement(join(root, 'web', 'dist', 'embed'));
  await writeLicencesAndSource(join(root, 'web', 'dist'));
  writeServiceWorker(join(root, 'web', 'dist'));
  writeStamp('web');
}

/** What each artifact is made of; a change to any of it makes the artifact old. */
const ingredients = {
  wasm: { inputs: ['CMakeLists.txt', 'core', 'wasm'], output: 'build/wasm/bin' },
  package: {
    inputs: ['web', 'build/wasm/bin', 'package.json', 'package-lock.json', 'docs/package.md', 'LICENSE'],
    output: 'build/package/package.json',
  },
  web: { inputs: ['web', 'build/wasm/bin', 'package-lock.json'], output: 'web/dist/index.html' },
};
const stampFile = (kind) => join(root, 'build', `${kind}.stamp`);

function* filesBelow(path) {
  if (!existsSync(path)) return;
  if (statSync(path).isFile()) {
    yield path;
    return;
  }
  for (const entry of readdirSync(path, { withFileTypes: true })) {
    if (entry.name === 'dist' || entry.name === 'node_modules') continue;
    const inner = join(path, entry.name);
    if (entry.isDirectory()) yield* filesBelow(inner);
    else if (entry.isFile()) yield inner;
  }
}

function fingerprint(kind) {
  const hash = createHash('sha256');
  for (const input of ingredients[kind].inputs) {
    for (const file of [...filesBelow(join(root, input))].sort()) {
      const { size, mtimeMs } = statSync(file);
      hash.update(`${file}\0${size}\0${mtimeMs}\n`);
    }
  }
  return hash.digest('hex');
}

function writeStamp(kind) {
  mkdirSync(dirname(stampFile(kind)), { recursive: true });
  writeFileSync(stampFile(kind), fingerprint(kind));
}

/** True when nothing that the artifact is made of has changed since it was built. */
export function isCurrent(kind) {
  if (!existsSync(join(root, ingredients[kind].output)) || !existsSync(stampFile(kind))) return false;
  return readFileSync(stampFile(kind), 'utf8') === fingerprint(kind);
}

if (isScript(import.meta.url)) {
  const builders = { native: buildNative, wasm: buildWasm, package: buildPackage, web: buildWeb };
  await main(async () => {
    const kinds = process.argv.slice(2);
    const unknown = kinds.filter((kind) => !(kind in builders));
    if (unknown.length > 0)
      throw new Failure(`Unknown: ${unknown.join(', ')}. Known: ${Object.keys(builders).join(', ')}.`);
    const holdsModule = kinds.includes('web') || kinds.includes('package');
    const needed = kinds.map((kind) => (kind === 'package' ? 'web' : kind));
    await setup([...new Set(holdsModule ? [...needed, 'wasm'] : needed)]);
    // The page and the package contain the module.
    if (holdsModule && !kinds.includes('wasm') && !isCurrent('wasm')) kinds.unshift('wasm');
    for (const kind of kinds) await builders[kind]();
  });
}
