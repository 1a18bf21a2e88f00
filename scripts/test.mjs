// npm test: every check in order, from the cheapest; the first that fails ends it.
// node scripts/test.mjs [--full] [--only=stage,stage]
// --full adds acceptance-size runs, the sanitizers, clang-tidy and the mutants.
import { mkdirSync, readFileSync, rmSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { join } from 'node:path';
import {
  buildNative,
  buildPackage,
  buildSanitized,
  buildWasm,
  buildWeb,
  nativeFolder,
  sanitizedFolder,
} from './build.mjs';
import { projectFiles } from './lib/files.mjs';
import { format } from './format.mjs';
import { Failure, main, root, run } from './lib/run.mjs';
import { lint, lintCpp } from './lint.mjs';
import { runMutants } from './mutants.mjs';
import { setup } from './setup.mjs';

const words = process.argv.slice(2);
const full = words.includes('--full');
const only = words
  .find((word) => word.startsWith('--only='))
  ?.slice('--only='.length)
  .split(',');
const results = join(root, 'build', 'test-results');
// Tests that know a larger size take it from here.
const env = full ? { PLATEAU_FULL: '1' } : {};

/** Counts that every runner reports in its own way; a stage that ran nothing, or left something out, has failed. */
function demand(counts) {
  const { ran, skipped } = counts;
  if (!(ran > 0)) throw new Failure('ran no test at all');
  if (skipped > 0) throw new Failure(`skipped ${skipped} tests; a test that cannot run is a test that fails`);
  return `${ran} tests`;
}

const resultFile = (name) => {
  const file = join(results, name);
  rmSync(file, { force: true });
  return file;
};
const json = (file) => JSON.parse(readFileSync(file, 'utf8'));
const occurrences = (text, pattern) => [...text.matchAll(pattern)].length;

async function nodeTests(pattern, name) {
  const file = resultFile(name);
  const reporters = ['spec', 'stdout', 'junit', file];
  const args = reporters.map(
    (value, i) => (i % 2 === 0 ? '--test-reporter=' : '--test-reporter-destination=') + value,
  );
  await run(process.execPath, ['--test', ...args, ...projectFiles(pattern)], { env });
  const text = readFileSync(file, 'utf8');
  const skipped = occurrences(text, /<skipped/g);
  return demand({ ran: occurrences(text, /<testcase/g) - skipped, skipped });
}

async function ctest(folder, filter, name, sizes = env) {
  const file = resultFile(name);
  const args = [
    '--test-dir',
    folder,
    '--no-tests=error',
    '--output-on-failure',
    '-j',
    String(availableParallelism()),
  ];
  await run('ctest', [...args, '--output-junit', file, ...filter], { env: sizes });
  const suite = /<testsuite[^>]*>/.exec(readFileSync(file, 'utf8'))?.[0] ?? '';
  const attribute = (key) => Number(new RegExp(`\\b${key}="(\\d+)"`).exec(suite)?.[1] ?? 0);
  const skipped = attribute('skipped') + attribute('disabled');
  return demand({ ran: attribute('tests') - skipped, skipped });
}

async function vitest() {
  const file = resultFile('vitest.json');
  await run('vitest', ['run', '--reporter=default', '--reporter=json', `--outputFile.json=${file}`], { env });
  const report = json(file);
  return demand({ ran: report.numPassedTests, skipped: report.numPendingTests + report.numTodoTests });
}

async function playwright() {
  const file = resultFile('playwright.json');
  await run('playwright', ['test', '--reporter=list,json'], {
    env: { ...env, PLAYWRIGHT_JSON_OUTPUT_FILE: file },
  });
  const { stats } = json(file);
  if (stats.flaky > 0) throw new Failure(`${stats.flaky} tests passed only when repeated`);
  return demand({ ran: stats.expected, skipped: stats.skipped });
}

const stages = [
  ['format', () => format({ check: true })],
  ['lint', lint],
  ['layering', () => nodeTests(/^tests\/(layering|scripts)\/.*\.test\.mjs$/, 'layering.xml')],
  ['build native', buildNative],
  ['ctest', () => ctest(nativeFolder, full ? [] : ['-LE', 'full'], 'ctest.xml')],
  ['build wasm', () => buildWasm({ checks: true })],
  ['module', vitest],
  ['build package', buildPackage],
  ['package', () => nodeTests(/^tests\/package\/.*\.test\.mjs$/, 'package.xml')],
  ['build web', buildWeb],
  ['page', playwright],
];
if (full) {
  stages.push(
    ['acceptance', () => nodeTests(/^tests\/acceptance\/.*\.test\.mjs$/, 'acceptance.xml')],
    ['build sanitized', buildSanitized],
    // Ten times slower, they look at the sizes of npm test.
    ['ctest sanitized', () => ctest(sanitizedFolder, ['-LE', 'full'], 'ctest-sanitized.xml', {})],
    ['clang-tidy', lintCpp],
    ['mutants', () => runMutants()],
  );
}

const seconds = (from) => `${((performance.now() - from) / 1000).toFixed(1)} s`;

await main(async () => {
  const names = stages.map(([name]) => name);
  const unknown = (only ?? []).filter((name) => !names.includes(name));
  if (unknown.length > 0) throw new Failure(`No stage ${unknown.join(', ')}. Stages: ${names.join(', ')}.`);
  const begin = performance.now();
  const done = [];
  const summary = () => console.log(`\n${done.map((line) => line.join('  ')).join('\n')}`);
  await setup(['native', 'wasm', 'web', 'style', 'browser']);
  done.push(['setup'.padEnd(16), seconds(begin).padStart(9)]);
  mkdirSync(results, { recursive: true });
  for (const [name, stage] of stages.filter(([each]) => !only || only.includes(each))) {
    console.log(`\n== ${name}`);
    const from = performance.now();
    try {
      const note = await stage();
      done.push([name.padEnd(16), seconds(from).padStart(9), note ?? '']);
    } catch (error) {
      if (!(error instanceof Failure)) throw error;
      summary();
      throw new Failure(`FAILED at stage "${name}" after ${seconds(from)}: ${error.message}`);
    }
  }
  summary();
  console.log(`\nAll ${done.length - 1} stages passed in ${seconds(begin)}.`);
});
