// The packed package in an empty folder: the ten lines, the types, the interface. Run by node --test, after its build.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { root } from '../../scripts/lib/run.mjs';
import { Installed } from './tarball.mjs';

let installed;
let plateau;

before(async () => {
  installed = new Installed();
  plateau = await import(pathToFileURL(join(installed.folder, 'node_modules/plateau/node.js')).href);
});
after(() => installed.dispose());

const read = (path) => readFileSync(join(root, path), 'utf8');
/** The blocks between fences of a kind. */
const blocks = (text, kind) =>
  [...text.matchAll(/^```(\w*)\n([^]*?)^```$/gm)].filter(([, of]) => of === kind).map(([, , block]) => block);

test('the ten lines of the README print plateaus, and are those of the package', () => {
  const guide = read('docs/package.md');
  const [lines] = blocks(guide, 'js');
  assert.ok(lines.trim().split('\n').length <= 11, 'ten lines and a blank one');
  const printed = installed.run(lines);
  assert.ok(blocks(guide, '').includes(printed), `the guide does not say that this is printed:\n${printed}`);
  assert.match(printed, /torus-like closed surface/);
  assert.ok(blocks(read('README.md'), 'js').includes(lines), 'the README has other lines');
});

test('the tarball holds the core, the element, types, licences and source, and nothing else', () => {
  const loose = installed.files.filter((path) => !path.startsWith('types/'));
  assert.deepEqual(loose, [
    'LICENSE',
    'README.md',
    'browser.js',
    'bunny-points.js',
    'color-distances.js',
    'licences.txt',
    'node.js',
    'package.json',
    'plateau-view.js',
    'plateau.wasm',
    'source.tar.gz',
  ]);
  assert.ok(installed.files.includes('types/embed/plateau-view.d.ts'));
  assert.deepEqual(
    readdirSync(join(installed.folder, 'node_modules')).filter((name) => !name.startsWith('.')),
    ['plateau'],
  );
});

const consumer = `
import { openCloud, PlateauError, type ErrorCode, type Plateau, type Step } from 'plateau';
import 'plateau/element';
export async function use(): Promise<readonly Plateau[]> {
  const run = await openCloud({ points: [[0, 0], [1, 0]] }, { family: 'delaunay' });
  for await (const step of run) { const known: Step = step; void known.epsilon; }
  const element = document.createElement('plateau-view');
  element.panels = 'full';
  element.addEventListener('plateau', ({ detail }) => { const rank: number = detail.rank; void rank; });
  element.addEventListener('error', ({ detail }) => { const code: ErrorCode = detail.code; void code; });
  element.addEventListener('click', (event) => event.preventDefault());
  await element.load(new Float64Array(3), { dimension: 3 });
  // @ts-expect-error there is no such panel
  element.panels = 'sideways';
  // @ts-expect-error there is no such code
  const wrong: ErrorCode = 'no such code';
  void (new Error() instanceof PlateauError) , void wrong;
  return run.plateaus();
}
`;

for (const [module, moduleResolution] of [
  ['nodenext', 'nodenext'],
  ['esnext', 'bundler'],
]) {
  test(`the types serve a strict program: ${moduleResolution}`, () => {
    installed.write('consumer.ts', consumer);
    const options = {
      module,
      moduleResolution,
      target: 'es2022',
      lib: ['es2022', 'dom', 'dom.iterable'],
      strict: true,
    };
    const more = { noEmit: true, types: [], exactOptionalPropertyTypes: true, skipLibCheck: false };
    installed.write(
      'tsconfig.json',
      JSON.stringify({ compilerOptions: { ...options, ...more }, files: ['consumer.ts'] }),
    );
    const tsc = join(root, 'node_modules/typescript/bin/tsc');
    assert.equal(execFileSync(process.execPath, [tsc, '-p', installed.folder], { encoding: 'utf8' }), '');
  });
}

test('a bundler takes the module along', () => {
  installed.write('index.html', '<!doctype html><script type="module" src="./main.js"></script>');
  installed.write(
    'main.js',
    "import 'plateau/element';\nimport { openCloud } from 'plateau';\nwindow.open = openCloud;\n",
  );
  const vite = join(root, 'node_modules/vite/bin/vite.js');
  execFileSync(process.execPath, [vite, 'build', '--logLevel', 'error'], { cwd: installed.folder });
  const built = readdirSync(join(installed.folder, 'dist/assets'));
  const modules = built.filter((name) => name.endsWith('.wasm'));
  assert.equal(modules.length, 1, built.join(' '));
  const programs = built
    .filter((name) => name.endsWith('.js'))
    .map((name) => readFileSync(join(installed.folder, 'dist/assets', name), 'utf8'));
  assert.ok(programs.some((text) => text.includes(modules[0])));
  // The measured shapes come along, in files of their own.
  const bunny = built.filter((name) => name.startsWith('bunny-points'));
  assert.equal(bunny.length, 1, built.join(' '));
  assert.ok(programs.some((text) => text.includes(bunny[0])));
});

/** Runs the module itself through a cloud: nothing of the package is in between. */
async function hashOfModule(source, options) {
  const { default: createModule } = await import(join(root, 'build/wasm/bin/plateau.mjs'));
  const module = await createModule({ wasmBinary: readFileSync(join(root, 'build/wasm/bin/plateau.wasm')) });
  const run = new module.Run(source, options);
  while (run.open(Infinity).kind === 'reading');
  run.run(Infinity, 0xffffffff);
  return run.hash();
}

const circle = Array.from({ length: 90 }, (_, i) => [Math.cos(i * i), Math.sin(i * i) / 3, (i % 7) / 10]);

test('torsion is told with the numbers over the other field, and named', async () => {
  const run = await plateau.openCloud({ shape: 'klein', size: 2500 }, { maxSteps: 150 });
  const bottle = (await run.plateaus()).find(({ shape }) => shape === 'Klein-bottle-like shape');
  assert.deepEqual(bottle?.betti, [1, 2, 1, 0]);
  assert.deepEqual(bottle?.torsion, { field: 3, betti: [1, 1, 0, 0] });
  for await (const { step, torsion } of run)
    if (step === bottle.middleStep) assert.deepEqual(torsion, bottle.torsion);
  await run.close();
});

test('steps, plateaus and files are those of the module', async () => {
  const options = { family: 'delaunay', nu: [1, 2, 3, 4] };
  const run = await plateau.openCloud({ points: circle }, options);
  assert.deepEqual([run.points, run.dimension, run.family], [90, 3, 'delaunay']);
  const steps = [];
  for await (const step of run) steps.push(step);
  assert.deepEqual(
    steps.map(({ step }) => step),
    circle.map((_, i) => i + 1),
  );
  assert.equal(new Set(steps.map(({ landmark }) => landmark)).size, 90);
  const text = circle.map((point) => point.join(' ')).join('\n');
  const bytes = new TextEncoder().encode(text);
  const { hash, steps: count, stopped } = await run.end();
  assert.equal(hash, await hashOfModule({ kind: 'file', name: 'points.xyz', bytes: bytes.buffer }, options));
  assert.deepEqual([count, stopped], [90, undefined]);

  const table = new TextDecoder()
    .decode(await run.exportFile('betti-csv'))
    .trim()
    .split('\n')
    .slice(1);
  const written = steps.map(({ step, landmark, epsilon, family, betti }) =>
    [step, landmark, epsilon, family, ...betti].map(String),
  );
  const printed = table.map((line) =>
    line.split(',').map((entry, i) => (i === 2 ? String(Number(entry)) : entry)),
  );
  assert.deepEqual(printed, written);

  const json = JSON.parse(new TextDecoder().decode(await run.exportFile('plateaus-json'))).plateaus;
  const plateaus = await run.plateaus();
  const inOrder = [...plateaus].sort((a, b) => a.firstStep - b.firstStep);
  assert.deepEqual(
    inOrder.map(({ firstStep, lastStep, epsilonFirst, epsilonLast, betti, family }) => [
      firstStep,
      lastStep,
      epsilonFirst,
      epsilonLast,
      betti,
      family,
    ]),
    json.map((each) => [
      each.first_step,
      each.last_step,
      each.epsilon_first,
      each.epsilon_last,
      each.betti,
      each.family,
    ]),
  );
  assert.deepEqual(
    plateaus.map(({ length }) => length),
    plateaus.map(({ length }) => length).sort((a, b) => b - a),
  );
  await run.close();

  const flat = Float64Array.from(circle.flat());
  for (const cloud of [
    { points: flat },
    { points: flat, dimension: 3 },
    { name: 'a.xyz', bytes },
    { name: 'a.xyz', bytes: bytes.buffer },
  ]) {
    const again = await plateau.openCloud(cloud, options);
    assert.equal((await again.end()).hash, hash);
    await again.close();
  }
  assert.equal(bytes.length, text.length, 'the bytes were taken instead of copied');
});

test('two readers of one run see the same, while others are computed', async () => {
  const runs = await Promise.all([300, 200].map((size) => plateau.openCloud({ shape: 'torus', size })));
  const read = async (run) => {
    const epsilons = [];
    for await (const { epsilon } of run) epsilons.push(epsilon);
    return epsilons;
  };
  const [first, second, other] = await Promise.all([read(runs[0]), read(runs[0]), read(runs[1])]);
  assert.deepEqual(first, second);
  assert.deepEqual([first.length, other.length], [300, 200]);
  await Promise.all(runs.map((run) => run.close()));
});

test('a paused run stands still, a closed one ends for who waits', async () => {
  const run = await plateau.openCloud({ shape: 'torus', size: 20000 });
  await run.pause();
  const reading = (async () => {
    let seen = 0;
    for await (const { step } of run) seen = step;
    return seen;
  })();
  const waited = await Promise.race([
    reading.then(() => 'done'),
    new Promise((done) => setTimeout(() => done('waits'), 300)),
  ]);
  assert.equal(waited, 'waits');
  await run.resume();
  const [result] = await Promise.allSettled([
    reading,
    new Promise((done) => setTimeout(done, 200)).then(() => run.close()),
  ]);
  assert.equal(result.status, 'rejected');
  assert.equal(result.reason.code, 'closed');
  await run.close();
  await assert.rejects(run.exportFile('betti-csv'), { code: 'closed' });
});

test('a session runs with its own options except those that are given', async () => {
  const first = await plateau.openCloud({ points: circle }, { family: 'delaunay', maxSteps: 40 });
  await first.end();
  const bytes = await first.exportFile('session');
  await first.close();
  const cloud = { name: 'a.plateau', bytes };
  const endOf = async (options) => {
    const run = await plateau.openCloud(cloud, options);
    const { steps } = await run.end();
    await run.close();
    return [run.family, steps];
  };
  assert.deepEqual(await endOf({}), ['delaunay', 40]);
  assert.deepEqual(await endOf({ maxSteps: 50 }), ['delaunay', 50]);
  assert.deepEqual(await endOf({ family: 'witness' }), ['witness', 40]);
});

test('what goes wrong has a sentence and a code', async () => {
  const bytes = new TextEncoder().encode('1 2 3\n4 five 6\n');
  const cases = [
    [{ shape: 'teapot', size: 5 }, {}, 'invalid-option', /There is no shape "teapot"/],
    [{ name: 'a.xyz', bytes }, {}, 'malformed-input', /ine 2/],
    [{ name: 'a.xyz', bytes: new Uint8Array(0) }, {}, 'empty-input', /./],
    [{ points: [[1, 2], [3]] }, {}, 'ragged-rows', /Point 1 has 1 coordinates, not 2/],
    [{ points: new Float64Array(7) }, {}, 'ragged-rows', /7 numbers are no points of 3/],
    [{ points: [[0, NaN]] }, {}, 'not-a-number', /./],
    [{ shape: 'torus', size: 50 }, { family: 'bogus' }, 'invalid-option', /family "bogus"/],
  ];
  for (const [cloud, options, code, message] of cases) {
    await assert.rejects(plateau.openCloud(cloud, options), (error) => {
      assert.ok(error instanceof plateau.PlateauError && error instanceof Error);
      assert.equal(error.code, code);
      assert.match(error.message, message);
      return true;
    });
  }
  const signal = AbortSignal.abort();
  await assert.rejects(plateau.openCloud({ shape: 'torus', size: 50 }, { signal }), { name: 'AbortError' });
});

test('what has a wrong type is refused with a sentence, and takes no other run with it', async () => {
  const other = await plateau.openCloud({ shape: 'torus', size: 3000 });
  const shape = { shape: 'torus', size: 50 };
  const cases = [
    [undefined, {}, 'A cloud takes an object, not undefined.'],
    [{}, {}, 'A cloud has a shape, or points, or a name and bytes.'],
    [new Float64Array(9), {}, 'A cloud has a shape, or points, or a name and bytes.'],
    [{ shape: 5, size: 10 }, {}, 'shape takes text, not 5.'],
    [{ shape: 'torus' }, {}, 'size takes a number, not undefined.'],
    [{ name: 5, bytes: new Uint8Array(3) }, {}, 'name takes text, not 5.'],
    [{ name: 'a.xyz', bytes: '1 2 3' }, {}, 'bytes takes an ArrayBuffer or a Uint8Array, not "1 2 3".'],
    [{ name: 'a.csv', bytes: new Uint8Array(3), columns: 3 }, {}, 'columns takes a list of numbers, not 3.'],
    [{ points: 'abc' }, {}, 'points takes a Float64Array or a list of points, not "abc".'],
    [
      { points: new Float32Array(9) },
      {},
      'points takes a Float64Array or a list of points, not Float32Array.',
    ],
    [{ points: [1, 2, 3] }, {}, 'Point 0 takes a list of numbers, not 1.'],
    [shape, null, 'The second argument takes an object, not null.'],
    [shape, { family: 5 }, 'family takes text, not 5.'],
    [shape, { metric: 7 }, 'metric takes text, not 7.'],
    [shape, { sliver: 3 }, 'sliver takes text, not 3.'],
    [shape, { nu: 3 }, 'nu takes a list of numbers, not 3.'],
    [shape, { box: 3 }, 'box takes a list of numbers, not 3.'],
    [shape, { pump: 'yes' }, 'pump takes true or false, not "yes".'],
    [shape, { famly: 'auto' }, 'There is no option famly.'],
    [shape, { signal: 1 }, 'signal takes an AbortSignal, not 1.'],
  ];
  for (const [cloud, options, message] of cases) {
    await assert.rejects(plateau.openCloud(cloud, options), (error) => {
      assert.ok(error instanceof plateau.PlateauError);
      assert.deepEqual([error.code, error.message], ['invalid-option', message]);
      return true;
    });
  }
  await assert.rejects(other.inspect(3, 'abc'), { code: 'invalid-option' });
  await assert.rejects(other.exportFile(5), { code: 'invalid-option' });
  assert.equal((await other.end()).steps, 3000);
  await other.close();
});

test('a program ends when it has nothing more to do, closed or not', () => {
  const text = (end) => `
    import { openCloud } from 'plateau';
    const begin = performance.now();
    const run = await openCloud({ shape: 'torus', size: 100000 });
    for await (const { step } of run) if (step === 3) break;
    ${end}
    process.on('exit', () => console.log(performance.now() - begin));`;
  assert.ok(Number(installed.run(text('await run.close();'))) < 20_000);
  assert.ok(Number(installed.run(text('await run.pause();'))) < 20_000);
});
