// The package as somebody gets it: packed, and installed without a network in an empty folder.
import { execFileSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { packageFolder } from '../../scripts/lib/package.mjs';

/** No cache, no settings, no network: what is needed is in the tarball. */
function npm(words, cwd) {
  const options = ['--offline', '--no-audit', '--no-fund', `--cache=${join(cwd, '.cache')}`];
  return execFileSync('npm', [...words, ...options], {
    cwd,
    encoding: 'utf8',
    stdio: ['ignore', 'pipe', 'pipe'],
  });
}

export class Installed {
  constructor() {
    this.folder = mkdtempSync(join(tmpdir(), 'plateau-package-'));
    const [{ filename, files }] = JSON.parse(npm(['pack', '--json', packageFolder], this.folder));
    this.files = files.map(({ path }) => path).sort();
    writeFileSync(join(this.folder, 'package.json'), '{ "private": true, "type": "module" }\n');
    npm(['install', `./${filename}`], this.folder);
  }

  write(name, text) {
    mkdirSync(join(this.folder, name, '..'), { recursive: true });
    writeFileSync(join(this.folder, name), text);
    return join(this.folder, name);
  }

  /** What the program prints; a process that does not end by itself within half a minute fails. */
  run(text) {
    const file = this.write('program.mjs', text);
    return execFileSync(process.execPath, [file], { cwd: this.folder, encoding: 'utf8', timeout: 30_000 });
  }

  dispose() {
    rmSync(this.folder, { recursive: true, force: true });
  }
}
