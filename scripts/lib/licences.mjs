// What the GPL and the packages ask of whoever serves the page: their licences and the source, beside it.
import { existsSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { projectFiles } from './files.mjs';
import { Failure, privateEmscripten, root, run } from './run.mjs';

const emscripten = existsSync(privateEmscripten)
  ? join(privateEmscripten, 'usr/share/doc/emscripten')
  : '/usr/share/doc/emscripten';

/** What the built page contains, and where each says under which licence. */
const bundled = [
  { name: 'three.js', folder: join(root, 'node_modules', 'three') },
  { name: 'culori', folder: join(root, 'node_modules', 'culori') },
  { name: 'CGAL', folder: '/usr/share/doc/libcgal-dev' },
  { name: 'Boost', folder: /^libboost\d[\d.]*-dev$/ },
  { name: 'fast_float', folder: '/usr/share/doc/libfast-float-dev' },
  { name: 'Eigen', folder: '/usr/share/doc/libeigen3-dev' },
  { name: 'Emscripten runtime and C++ library', folder: emscripten },
];

function licenceText({ name, folder }) {
  const place =
    typeof folder === 'string'
      ? folder
      : join('/usr/share/doc', readdirSync('/usr/share/doc').find((entry) => folder.test(entry)) ?? '');
  const file = ['LICENSE', 'copyright'].map((entry) => join(place, entry)).find((path) => existsSync(path));
  if (!file) throw new Failure(`The licence of ${name} is not where its package puts it (${place}).`);
  return `${'='.repeat(100)}\n${name}\n${'='.repeat(100)}\n\n${readFileSync(file, 'utf8').trim()}\n`;
}

/** Writes licences.txt and source.tar.gz into the folder that is served. */
export async function writeLicencesAndSource(folder) {
  const own = readFileSync(join(root, 'LICENSE'), 'utf8').trim();
  const head = `Plateau is free software under the GNU General Public License, version 3 or later (the text follows).
The source that this page was built from is in source.tar.gz beside this file. It contains the packages below.
The bunny of the gallery is the Stanford Bunny of the Stanford 3D Scanning Repository (Stanford Computer Graphics
Laboratory), by way of the npm package \`bunny\`, which its author put into the public domain. Its colors are
those of the xkcd color survey (Randall Munroe, public domain), by way of the npm package \`xkcd-colors\` (Jonathan
D. B. Van Schenck, MIT).\n`;
  const texts = [`${head}\n${own}\n`, ...bundled.map(licenceText)];
  writeFileSync(join(folder, 'licences.txt'), texts.join('\n'));
  const sources = projectFiles(/./);
  if (sources.length === 0) throw new Failure('The source can be packed from a git checkout only.');
  await run('tar', ['czf', join(folder, 'source.tar.gz'), ...sources], { echo: false });
}
