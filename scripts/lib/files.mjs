// Which files the checks look at: those in version control and those that are new but not ignored.
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { capture, root } from './run.mjs';

/** Paths relative to the root, sorted, that match the pattern. */
export function projectFiles(pattern) {
  const { out } = capture('git', ['ls-files', '--cached', '--others', '--exclude-standard', '-z']);
  return [...new Set(out.split('\0'))]
    .filter((path) => pattern.test(path) && existsSync(join(root, path)))
    .sort();
}

export const cppFiles = () => projectFiles(/^(core|wasm|tests)\/.*\.(h|cpp)$/);
export const cppSources = () => projectFiles(/^core\/.*\.cpp$/);
export const scriptFiles = () =>
  projectFiles(/^((web|scripts|tests)\/.*\.(ts|mjs|css|html)|[^/]+\.(ts|mjs))$/);
export const tsconfigs = () => projectFiles(/^((web|tests)\/(.*\/)?)?tsconfig[^/]*\.json$/);
