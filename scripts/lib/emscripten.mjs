// A private copy of Debian's Emscripten, for machines where apt cannot install the package itself: it asks for
// Debian's own Node.js under a name ("nodejs:any") that the packages of NodeSource do not provide.
import {
  chmodSync,
  mkdirSync,
  mkdtempSync,
  readFileSync,
  readdirSync,
  renameSync,
  rmSync,
  writeFileSync,
} from 'node:fs';
import { join } from 'node:path';
import { capture, privateEmscripten, root, run } from './run.mjs';

/** What the copy needs from the system: the package's own dependencies without Node.js. */
export const companions = ['binaryen', 'clang-14', 'lld-14', 'llvm-14', 'python3'];

/** True when apt's answer shows that very conflict. */
export const conflictsWithNode = (aptSays) =>
  /Depends: nodejs(:any)?\b/.test(aptSays) && /unmet dependencies/.test(aptSays);

/** Bytes that the copy downloads, as apt says; undefined when it does not know the package. */
export function downloadSize() {
  const { out } = capture('apt-get', ['download', '--print-uris', 'emscripten']);
  const size = /_all\.deb (\d+)|_\w+\.deb (\d+)/.exec(out);
  return size ? Number(size[1] ?? size[2]) : undefined;
}

const tools = ['emcc', 'em++', 'emar', 'emranlib', 'emcmake'];

/** Downloads the package with apt, unpacks it below build/ and points its configuration to this Node.js. */
export async function installPrivately() {
  mkdirSync(join(root, 'build'), { recursive: true });
  const work = mkdtempSync(join(root, 'build', 'emscripten-'));
  try {
    await run('apt-get', ['download', 'emscripten'], { cwd: work });
    const archive = readdirSync(work).find((name) => name.endsWith('.deb'));
    const unpacked = join(work, 'unpacked');
    await run('dpkg-deb', ['-x', join(work, archive), unpacked]);
    const home = join(unpacked, 'usr', 'share', 'emscripten');
    for (const unused of ['tests', 'docs', 'media'])
      rmSync(join(home, unused), { recursive: true, force: true });
    const settings = join(home, '.emscripten');
    const text = readFileSync(settings, 'utf8')
      .replace(
        /^EMSCRIPTEN_ROOT = .*$/m,
        `EMSCRIPTEN_ROOT = ${JSON.stringify(join(privateEmscripten, 'usr/share/emscripten'))}`,
      )
      .replace(/^NODE_JS = .*$/m, `NODE_JS = ${JSON.stringify(process.execPath)}`);
    writeFileSync(settings, text);
    // Its scripts are CommonJS; without this the project's package.json would make them modules.
    writeFileSync(join(unpacked, 'package.json'), '{ "type": "commonjs" }\n');
    mkdirSync(join(unpacked, 'bin'));
    for (const tool of tools) {
      const script = join(unpacked, 'bin', tool);
      writeFileSync(
        script,
        `#!/bin/sh\nexec python3 "$(dirname "$0")/../usr/share/emscripten/${tool}.py" "$@"\n`,
      );
      chmodSync(script, 0o755);
    }
    rmSync(privateEmscripten, { recursive: true, force: true });
    renameSync(unpacked, privateEmscripten);
  } finally {
    rmSync(work, { recursive: true, force: true });
  }
}
