// Reads which file includes which and holds it against layers.json. Returns sentences, one a violation.
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { dirname, join, relative, resolve } from 'node:path';

export const layers = JSON.parse(readFileSync(new URL('layers.json', import.meta.url), 'utf8'));

function filesBelow(folder, pattern) {
  if (!existsSync(folder)) return [];
  return readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile() && pattern.test(entry.name))
    .map((entry) => join(entry.parentPath, entry.name))
    .sort();
}

/** Comments and nothing else removed, so that an include in a comment does not count. */
const withoutComments = (text) => text.replace(/\/\*[\s\S]*?\*\//g, '').replace(/^\s*\/\/.*$/gm, '');

const externalMatches = (name, key) => name === key || name.startsWith(key.endsWith('/') ? key : `${key}/`);

function checkCpp(root, violations, edges) {
  const files = ['core', 'wasm'].flatMap((folder) => filesBelow(join(root, folder), /\.(h|cpp)$/));
  for (const file of files) {
    const path = relative(root, file);
    const room = path.startsWith('core/') ? path.split('/').slice(0, 2).join('/') : 'wasm';
    // A file may have an entry of its own, narrower or wider than its room's.
    const allowed = layers.cpp[path.replace(/\.(h|cpp)$/, '')] ?? layers.cpp[room];
    if (!allowed) {
      violations.push(`${path}: ${room} is not a room of the table`);
      continue;
    }
    const text = withoutComments(readFileSync(file, 'utf8'));
    for (const [, open, name] of text.matchAll(/^\s*#\s*include\s*(["<])([^">]+)[">]/gm)) {
      if (open === '<') {
        for (const [key, rooms] of Object.entries(layers.external)) {
          if (externalMatches(name, key) && !rooms.includes(room) && !rooms.includes(path))
            violations.push(`${path}: <${name}> is not for ${room}`);
        }
        continue;
      }
      const target = [join(root, 'core', name), join(root, name), join(dirname(file), name)].find(existsSync);
      if (!target) {
        violations.push(
          `${path}: "${name}" is no file of the project (outside headers go in angle brackets)`,
        );
        continue;
      }
      const targetPath = relative(root, target);
      const targetRoom = targetPath.startsWith('core/') ? targetPath.split('/')[1] : 'wasm';
      const own = room === 'wasm' ? 'wasm' : room.slice('core/'.length);
      if (targetRoom !== own && !allowed.includes(targetRoom))
        violations.push(`${path}: ${room} may not include ${name}`);
      edges.push([path, targetPath]);
    }
  }
  return files;
}

function checkWeb(root, violations, edges) {
  const base = join(root, 'web', 'src');
  const files = filesBelow(base, /\.(ts|mts|css|html)$/);
  const order = (file) => layers.web.indexOf(relative(base, file).split('/')[0]);
  for (const file of files.filter((name) => /\.m?ts$/.test(name))) {
    const path = relative(root, file);
    const room = relative(base, file).split('/')[0];
    // A file directly in src starts the page and may name every room.
    const inRoom = relative(base, file).includes('/');
    if (inRoom && order(file) < 0) {
      violations.push(`${path}: ${room} is not a room of the table`);
      continue;
    }
    const text = withoutComments(readFileSync(file, 'utf8'));
    const imports =
      /(?:^|\n)\s*(?:import|export)\s[^;]*?from\s*'([^']+)'|import\s*'([^']+)'|import\(\s*'([^']+)'|new URL\(\s*'([^']+)'/g;
    for (const match of text.matchAll(imports)) {
      const name = match.slice(1).find(Boolean);
      if (!name.startsWith('.')) {
        for (const [key, rooms] of Object.entries(layers.webExternal)) {
          if (externalMatches(name, key) && !rooms.includes(room))
            violations.push(`${path}: ${name} is only for ${rooms.join(', ')}`);
        }
        continue;
      }
      const bare = resolve(dirname(file), name.replace(/\?.*$/, ''));
      const target = [bare, `${bare}.ts`, bare.replace(/\.js$/, '.ts'), join(bare, 'index.ts')].find(
        (candidate) => files.includes(candidate),
      );
      // Outside web/src lies only what a build made (the module) and its hand-written types.
      if (!target) continue;
      if (inRoom && order(target) > order(file)) violations.push(`${path}: ${room} may not import ${name}`);
      edges.push([path, relative(root, target)]);
    }
  }
  return files;
}

/** Cycles among files, each told once as a path. */
function cycles(edges) {
  const next = new Map();
  for (const [from, to] of edges) next.set(from, [...(next.get(from) ?? []), to]);
  const found = [];
  const state = new Map();
  const visit = (file, trail) => {
    if (state.get(file) === 'done') return;
    if (state.get(file) === 'open') {
      found.push([...trail.slice(trail.indexOf(file)), file].join(' -> '));
      return;
    }
    state.set(file, 'open');
    for (const other of next.get(file) ?? []) visit(other, [...trail, file]);
    state.set(file, 'done');
  };
  for (const file of next.keys()) visit(file, []);
  return found;
}

/** Every violation below the root; an empty list means that the layers hold. */
export function violationsIn(root) {
  const violations = [];
  const edges = [];
  const files = [...checkCpp(root, violations, edges), ...checkWeb(root, violations, edges)];
  for (const cycle of cycles(edges)) violations.push(`cycle: ${cycle}`);
  for (const file of files) {
    const lines = readFileSync(file, 'utf8').split('\n').length - 1;
    if (lines > layers.maxLines)
      violations.push(`${relative(root, file)}: ${lines} lines, at most ${layers.maxLines}`);
  }
  return { violations, files: files.length };
}
