// Installs what a command needs: system packages by apt, npm packages by the lock file.
// node scripts/setup.mjs [native] [wasm] [web] [style] [browser] [--dry-run] [--yes]
// Uses nothing but Node.js itself: it runs before anything is installed.
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { createInterface } from 'node:readline/promises';
import { companions, conflictsWithNode, downloadSize, installPrivately } from './lib/emscripten.mjs';
import { needs, packagesFor } from './lib/packages.mjs';
import { Failure, capture, isScript, main, onPath, root, run } from './lib/run.mjs';

const oldestNode = [20, 19];

const atLeast = (version) => {
  const [major, minor] = version.split('.').map(Number);
  return major > oldestNode[0] || (major === oldestNode[0] && minor >= oldestNode[1]);
};

function checkNode() {
  if (!atLeast(process.versions.node)) {
    throw new Failure(
      `This is Node.js ${process.versions.node}; Plateau needs ${oldestNode.join('.')} or newer, with npm. ` +
        "Debian 12's own package is older: take one from nodejs.org or from the NodeSource packages.",
    );
  }
}

const hasApt = () => onPath('apt-get') && onPath('dpkg-query');

/** Which of the packages are not there yet. */
function missingPackages(wanted) {
  if (!hasApt()) {
    return [...wanted]
      .filter(([, sign]) => sign && !(sign.file ? existsSync(sign.file) : onPath(sign.program)))
      .map(([pkg]) => pkg);
  }
  const query = capture('dpkg-query', ['-W', '-f=${Package} ${db:Status-Abbrev}\n', ...wanted.keys()]);
  const installed = new Set(
    query.out
      .split('\n')
      .filter((line) => / ii\s*$/.test(line))
      .map((line) => line.split(' ')[0]),
  );
  // A tool that was put there by other means (another g++, say) is as good as the package.
  return [...wanted]
    .filter(([pkg, sign]) => !installed.has(pkg) && !(sign?.program && onPath(sign.program)))
    .map(([pkg]) => pkg);
}

/** True when node_modules holds exactly the versions of the lock file (optional packages of other systems aside). */
export function modulesAreCurrent() {
  const wanted = join(root, 'package-lock.json');
  const present = join(root, 'node_modules', '.package-lock.json');
  if (!existsSync(present)) return false;
  const lock = JSON.parse(readFileSync(wanted, 'utf8')).packages;
  const have = JSON.parse(readFileSync(present, 'utf8')).packages;
  return Object.entries(lock).every(([path, entry]) => {
    if (path === '') return true;
    return have[path] ? have[path].version === entry.version : entry.optional === true || entry.peer === true;
  });
}

/** root, sudo, or no way at all. */
function privilege() {
  if (process.getuid?.() === 0) return [];
  return onPath('sudo') ? ['sudo'] : null;
}

const aptInstall = (packages) => ['apt-get', 'install', '-y', '--no-install-recommends', ...packages];
const listsAreAbsent = () => {
  const folder = '/var/lib/apt/lists';
  return (
    !existsSync(folder) ||
    !readdirSync(folder).some((name) => name.endsWith('_Packages') || name.includes('_Packages.'))
  );
};

function apt(words) {
  const rights = privilege();
  const [program, ...args] = [...rights, 'env', 'DEBIAN_FRONTEND=noninteractive', ...words];
  return run(program, args);
}

/** What apt says that an installation takes; it only plans and needs no rights. */
function plan(packages) {
  const words = ['install', '--print-uris', '--no-install-recommends', ...packages];
  const { ok, out, err } = capture('apt-get', words);
  const line = (pattern) => out.split('\n').find((text) => pattern.test(text));
  return {
    ok,
    says: out + err,
    newNode: /^'[^']*' nodejs_/m.test(out),
    size: [line(/^Need to get /), line(/additional disk space/)].filter(Boolean).join(' '),
  };
}

/** The plan for the packages; where Emscripten cannot stand beside this Node.js, one with a private copy of it. */
function planAround(packages) {
  const first = { packages, copy: false, ...plan(packages) };
  if (first.ok || !packages.includes('emscripten') || !conflictsWithNode(first.says)) return first;
  const others = [...new Set([...packages.filter((pkg) => pkg !== 'emscripten'), ...companions])];
  return { packages: others, copy: true, ...plan(others) };
}

async function agreed(yes) {
  if (yes || process.env.CI || !process.stdin.isTTY || !process.stdout.isTTY) return true;
  const terminal = createInterface({ input: process.stdin, output: process.stdout });
  const answer = await terminal.question('Go on? [Y/n] ');
  terminal.close();
  return !/^n/i.test(answer.trim());
}

function checkNodeAfterwards(before) {
  const { out } = capture('/bin/sh', ['-c', 'command -v node && node --version'], { env: { PATH: before } });
  const [path, version] = out.trim().split('\n');
  if (version && !atLeast(version.slice(1))) {
    console.log(
      `Note: ${path} is now Node.js ${version.slice(1)}, which came with the packages. Plateau goes on with ${process.execPath}; ` +
        'put its folder first on your PATH.',
    );
  }
}

async function installPackages(packages, { dryRun }) {
  const rights = privilege();
  const byHand = `apt-get update && ${aptInstall(packages).join(' ')}`;
  if (dryRun) {
    if (listsAreAbsent()) console.log('would run: apt-get update');
    console.log(`would run: ${[...(rights ?? []), ...aptInstall(packages)].join(' ')}`);
    return;
  }
  if (rights === null) throw new Failure(`There is no sudo here. As root, run:\n  ${byHand}`);
  const path = process.env.PATH;
  try {
    await apt(aptInstall(packages));
  } catch {
    // Old package lists name files that the archive no longer has; new lists mend that.
    console.log('The installation failed; once more with fresh package lists.');
    await apt(['apt-get', 'update']);
    await apt(aptInstall(packages));
  }
  checkNodeAfterwards(path);
}

async function refreshLists(dryRun) {
  if (dryRun || !listsAreAbsent() || privilege() === null) return;
  console.log('apt has no package lists yet; fetching them.');
  await apt(['apt-get', 'update']);
}

/** Plans the installation of what is missing and says what it takes. */
async function announced(missing, dryRun) {
  await refreshLists(dryRun);
  const work = planAround(missing);
  if (!work.ok) {
    throw new Failure(
      `apt cannot install what is missing:\n  ${missing.join(' ')}\nIt says:\n${work.says.trim()}\n` +
        'Plateau is built on Debian 12 (bookworm) or a system with the same packages; is apt-get update needed?',
    );
  }
  console.log(`System packages to install:\n  ${work.packages.join(' ')}\n  ${work.size}`);
  if (work.newNode) {
    console.log(`  They bring Debian's own, older Node.js along; ${process.execPath} stays as it is.`);
  }
  if (work.copy) {
    const megabytes = Math.round((downloadSize() ?? 0) / 1e6);
    console.log(
      `Emscripten to unpack into build/emscripten (${megabytes} MB to download, about 800 MB on disk): ` +
        "Debian's package cannot be installed beside the Node.js of this machine.",
    );
  }
  return work;
}

/** Says what is missing for the needs, asks once, installs it. Returns at once when nothing is missing. */
export async function setup(names, { dryRun = false, yes = false } = {}) {
  checkNode();
  const wanted = packagesFor(names);
  const missing = missingPackages(wanted);
  const modules = !modulesAreCurrent();
  if (missing.length === 0 && !modules) return;

  if (missing.length > 0 && !hasApt()) {
    throw new Failure(
      `This is not a Debian-like system, so nothing is installed by itself. Not found:\n  ${missing.join(' ')}\n` +
        'These are the names of Debian 12 packages; install what your system calls them (headers under /usr/include) and start again.',
    );
  }
  const work = missing.length > 0 ? await announced(missing, dryRun) : { packages: [], copy: false };
  if (modules)
    console.log('npm packages to install: those of package-lock.json, into node_modules (about 160 MB).');
  if (!dryRun && !(await agreed(yes))) throw new Failure('Nothing was installed.');

  if (work.packages.length > 0) await installPackages(work.packages, { dryRun });
  if (work.copy) {
    if (dryRun) console.log('would run: apt-get download emscripten, and unpack it into build/emscripten');
    else await installPrivately();
  }
  if (modules) {
    if (dryRun) console.log('would run: npm ci');
    else await run('npm', ['ci', '--no-audit', '--no-fund']);
  }
}

if (isScript(import.meta.url)) {
  const words = process.argv.slice(2);
  const names = words.filter((word) => !word.startsWith('--'));
  const dryRun = words.includes('--dry-run');
  await main(async () => {
    const unknown = names.filter((name) => !(name in needs));
    if (unknown.length > 0)
      throw new Failure(`Unknown: ${unknown.join(', ')}. Known: ${Object.keys(needs).join(', ')}.`);
    const all = names.length > 0 ? names : Object.keys(needs);
    await setup(all, { dryRun, yes: words.includes('--yes') });
    if (!dryRun) console.log(`Ready for: ${all.join(', ')}.`);
  });
}
