// The package: the core for Node.js and browsers and the element, in build/package, ready for npm pack.
import { copyFileSync, cpSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { writeLicencesAndSource } from './licences.mjs';
import { root, run } from './run.mjs';

export const packageFolder = join(root, 'build', 'package');

/** Programs of their own; `frame` is that of the page for iframes and not part of the package. */
const programs = ['node', 'browser', 'plateau-view', 'frame'];
/** What stands beside the element wherever it is served. */
const besideElement = [
  ...['plateau-view.js', 'plateau.wasm', 'licences.txt', 'source.tar.gz'],
  // Loaded when the shape is asked for.
  ...['bunny-points.js', 'color-distances.js'],
];

function manifest() {
  const { name, version, description, license } = JSON.parse(
    readFileSync(join(root, 'package.json'), 'utf8'),
  );
  return {
    name,
    version,
    description,
    license,
    type: 'module',
    engines: { node: '>=20' },
    exports: {
      '.': {
        node: { types: './types/package/node.d.ts', default: './node.js' },
        default: { types: './types/package/browser.d.ts', default: './browser.js' },
      },
      './element': { types: './types/embed/plateau-view.d.ts', default: './plateau-view.js' },
      './plateau.wasm': './plateau.wasm',
      './package.json': './package.json',
    },
    sideEffects: ['./plateau-view.js'],
    files: ['node.js', 'browser.js', ...besideElement, 'types'],
  };
}

/** Builds everything in build/package anew. The module must be there. */
export async function makePackage() {
  rmSync(packageFolder, { recursive: true, force: true });
  mkdirSync(packageFolder, { recursive: true });
  for (const program of programs) {
    const args = ['build', '--config', 'web/vite.package.config.ts', '--mode', program];
    await run('vite', [...args, '--logLevel', 'warn']);
  }
  await run('tsc', ['-p', 'web/tsconfig.types.json']);
  copyFileSync(join(root, 'build', 'wasm', 'bin', 'plateau.wasm'), join(packageFolder, 'plateau.wasm'));
  copyFileSync(join(root, 'docs', 'package.md'), join(packageFolder, 'README.md'));
  copyFileSync(join(root, 'LICENSE'), join(packageFolder, 'LICENSE'));
  await writeLicencesAndSource(packageFolder);
  writeFileSync(join(packageFolder, 'package.json'), JSON.stringify(manifest(), null, 2) + '\n');
}

/** Puts the element and the page for iframes into a folder of a page that is served. */
export function addElement(folder) {
  mkdirSync(folder, { recursive: true });
  for (const file of [...besideElement, 'frame.js'])
    copyFileSync(join(packageFolder, file), join(folder, file));
  cpSync(join(root, 'web', 'embed'), folder, { recursive: true });
}
