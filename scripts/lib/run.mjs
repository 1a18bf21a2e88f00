// Running other programs: one environment, one way to fail.
import { spawn, spawnSync } from 'node:child_process';
import { accessSync, constants, existsSync, realpathSync } from 'node:fs';
import { delimiter, dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

export const root = fileURLToPath(new URL('../..', import.meta.url)).replace(/\/$/, '');

/** A failure that a sentence explains; printed without a stack. */
export class Failure extends Error {}

/** Where a private copy of Emscripten lies when the system's package could not be installed. */
export const privateEmscripten = join(root, 'build', 'emscripten');

/**
 * The environment of every child. The Node.js that runs this script comes first on the path, also where a package
 * brought an older one; Debian's linker for Emscripten finds its JavaScript packages only by NODE_PATH.
 */
export function environment(extra = {}) {
  const debianModules = '/usr/share/nodejs';
  const modules = (process.env.NODE_PATH ?? '').split(delimiter).filter(Boolean);
  return {
    ...process.env,
    PATH: programFolders().join(delimiter),
    NODE_PATH: [...new Set([...modules, debianModules, join(root, 'node_modules')])].join(delimiter),
    ...extra,
  };
}

function programFolders() {
  const ours = [
    dirname(process.execPath),
    join(root, 'node_modules', '.bin'),
    join(privateEmscripten, 'bin'),
  ];
  return [...ours.filter((folder) => existsSync(folder)), ...(process.env.PATH ?? '').split(delimiter)];
}

/** Is there a program of this name on the path? */
export function onPath(program) {
  return programFolders().some((folder) => {
    try {
      accessSync(join(folder, program), constants.X_OK);
      return true;
    } catch {
      return false;
    }
  });
}

/** Runs a program with its output shown; rejects with a Failure when it does not end with 0. */
export function run(program, args, { env = {}, cwd = root, echo = true } = {}) {
  if (echo) console.log(`$ ${[program, ...args].join(' ')}`);
  return new Promise((resolve, reject) => {
    const child = spawn(program, args, { cwd, env: environment(env), stdio: 'inherit' });
    child.on('error', (error) =>
      reject(
        new Failure(
          error.code === 'ENOENT' ? `${program} is not installed; try npm run setup` : error.message,
        ),
      ),
    );
    child.on('exit', (code, signal) => {
      if (code === 0) resolve();
      else reject(new Failure(`${program} ended with ${signal ?? `exit code ${code}`}`));
    });
  });
}

/** Runs a program and returns what it printed, whether it succeeded or not. */
export function capture(program, args, { env = {}, cwd = root, input } = {}) {
  const result = spawnSync(program, args, {
    cwd,
    env: environment({ LC_ALL: 'C', ...env }),
    encoding: 'utf8',
    input,
    maxBuffer: 1 << 28,
  });
  return { ok: result.status === 0, out: result.stdout ?? '', err: result.stderr ?? '' };
}

/** Was this module started as the script, not imported? */
export function isScript(url) {
  return process.argv[1] !== undefined && realpathSync(process.argv[1]) === fileURLToPath(url);
}

/** Runs the body of a script: a Failure becomes one line, anything else keeps its stack. */
export async function main(body) {
  try {
    await body();
  } catch (error) {
    console.error(error instanceof Failure ? `\n${error.message}` : error);
    process.exitCode = 1;
  }
}
