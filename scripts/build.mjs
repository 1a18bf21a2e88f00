// Builds the command, the module and the page: node scripts/build.mjs [native] [wasm] [web]
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync, readdirSync, statSync, writeFileSync } from 'node:fs';
import { availableParallelism, totalmem } from 'node:os';
import { dirname, join } from 'node:path';
import { Failure, isScript, main, root, run } from './lib/run.mjs';
import { writeLicencesAndSource } from './lib/licences.mjs';
import { writeServiceWorker } from './lib/offline.mjs';
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

export async function buildWeb() {
  await run('vite', ['build', 'web']);
  await writeLicencesAndSource(join(root, 'web', 'dist'));
  writeServiceWorker(join(root, 'web', 'dist'));
  writeStamp('web');
}

/** What each artifact is made of; a change to any of it makes the artifact old. */
const ingredients = {
  wasm: { inputs: ['CMakeLists.txt', 'core', 'wasm'], output: 'build/wasm/bin' },
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
  const builders = { native: buildNative, wasm: buildWasm, web: buildWeb };
  await main(async () => {
    const kinds = process.argv.slice(2);
    const unknown = kinds.filter((kind) => !(kind in builders));
    if (unknown.length > 0)
      throw new Failure(`Unknown: ${unknown.join(', ')}. Known: ${Object.keys(builders).join(', ')}.`);
    await setup(kinds.includes('web') ? [...new Set([...kinds, 'wasm'])] : kinds);
    // The page contains the module.
    if (kinds.includes('web') && !kinds.includes('wasm') && !isCurrent('wasm')) kinds.unshift('wasm');
    for (const kind of kinds) await builders[kind]();
  });
}
