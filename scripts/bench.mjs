// Builds and runs the benchmarks of tests/bench and prints their tables. Nothing here asserts a time.
// node scripts/bench.mjs [--full] [--sizes 1000,10000] [--patience SECONDS] [--write] [--draw]
//   --full      100,000 and 1,000,000 points as well
//   --patience  a row that takes longer is given up, and said so (default 20, with --full 900)
//   --write     put the results into docs: growth.csv, growth.svg, the tables of speed.md
//   --draw      measure nothing, draw and write the docs from docs/growth.csv again
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { growthChart } from '../tests/bench/chart.mjs';
import { Measurer } from '../tests/bench/measure.mjs';
import { fullSizes, smallSizes } from '../tests/bench/plan.mjs';
import { report, withReport } from '../tests/bench/report.mjs';
import { fromCsv, machineLine, toCsv } from '../tests/bench/results.mjs';
import { buildNative, buildWasm, isCurrent, nativeFolder } from './build.mjs';
import { Failure, capture, main, root } from './lib/run.mjs';
import { setup } from './setup.mjs';

const docs = (name) => join(root, 'docs', name);

function wholeNumber(word, name) {
  if (!/^[1-9]\d*$/.test(word)) throw new Failure(`${name} takes whole numbers, not "${word}".`);
  return Number(word);
}

function wordsOf(args) {
  try {
    return parseArgs({
      args,
      options: {
        full: { type: 'boolean', default: false },
        sizes: { type: 'string' },
        patience: { type: 'string' },
        write: { type: 'boolean', default: false },
        draw: { type: 'boolean', default: false },
      },
    }).values;
  } catch (error) {
    throw new Failure(error.message);
  }
}

async function measured({ full, sizes, patience }) {
  await setup(['native', 'wasm', 'web']);
  await buildNative({ targets: ['run_bench', 'rebuild_bench'] });
  if (!isCurrent('wasm')) await buildWasm();
  const all =
    sizes?.split(',').map((word) => wholeNumber(word, '--sizes')) ?? (full ? fullSizes : smallSizes);
  const limit = patience === undefined ? (full ? 900 : 20) : wholeNumber(patience, '--patience');
  const measurer = new Measurer(join(nativeFolder, 'bin'), limit, (line) => console.log(line));
  const machine = machineLine(`g++ ${capture('g++', ['-dumpfullversion']).out.trim()}`);
  return { machine, rows: await measurer.all(all) };
}

await main(async () => {
  const words = wordsOf(process.argv.slice(2));
  const csv = words.draw ? readFileSync(docs('growth.csv'), 'utf8') : toCsv(await measured(words));
  // As the file has them, rounded: drawn again, they give the same picture and tables.
  const results = fromCsv(csv);
  const text = report(results);
  console.log(`\n${text}`);
  if (!words.draw) {
    mkdirSync(join(root, 'build'), { recursive: true });
    writeFileSync(join(root, 'build', 'bench.csv'), csv);
  }
  if (words.write || words.draw) {
    writeFileSync(docs('growth.csv'), csv);
    writeFileSync(docs('growth.svg'), growthChart(results));
    writeFileSync(docs('speed.md'), withReport(readFileSync(docs('speed.md'), 'utf8'), text));
    console.log('\nWritten: docs/growth.csv, docs/growth.svg, docs/speed.md');
  }
});
