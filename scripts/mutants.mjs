// Puts one-line faults into a copy of the core, one at a time, and demands that the named test notices each.
// node scripts/mutants.mjs [--only=text in file or reason]
import { cpSync, existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { setImmediate } from 'node:timers/promises';
import { jobs } from './build.mjs';
import { Failure, capture, isScript, main, root } from './lib/run.mjs';
import { setup } from './setup.mjs';

const copied = ['CMakeLists.txt', 'core', 'wasm', 'tests'];

/** Entries {file, find, replace, test, why}: `find` is exact, on one line, and occurs once in its file. */
export function readMutants(only) {
  const all = JSON.parse(readFileSync(join(root, 'tests', 'mutants', 'mutants.json'), 'utf8'));
  return all.filter(({ file, why }) => !only || file.includes(only) || why.includes(only));
}

/** Why the entry cannot be applied, or undefined. */
export function defect({ file, find, replace, test, why }) {
  if (![file, find, replace, test, why].every((text) => typeof text === 'string'))
    return 'needs file, find, replace, test, why';
  if (find.includes('\n') || find === '' || find === replace)
    return '`find` is one line and differs from `replace`';
  if (!existsSync(join(root, file))) return 'no such file';
  const times = readFileSync(join(root, file), 'utf8').split(find).length - 1;
  return times === 1 ? undefined : `\`find\` occurs ${times} times, not once`;
}

class Workshop {
  constructor() {
    this.folder = mkdtempSync(join(tmpdir(), 'plateau-mutants-'));
    this.build = join(this.folder, 'build');
    this.clean = join(this.folder, 'clean');
    for (const path of copied) {
      if (existsSync(join(root, path)))
        cpSync(join(root, path), join(this.folder, path), { recursive: true });
    }
    // Optimization is not what is tested here, and -O1 compiles faster. A build type has flags of its own; None has none.
    const flags = ['-DCMAKE_BUILD_TYPE=None', '-DCMAKE_CXX_FLAGS=-O1', '-DPLATEAU_TEST_TIMEOUT=100'];
    const configured = capture('cmake', ['-S', this.folder, '-B', this.build, '-G', 'Ninja', ...flags]);
    if (!configured.ok)
      throw new Failure(`The copy could not be configured:\n${configured.out}${configured.err}`);
  }

  /** Builds the targets; returns what the compiler said when that fails. */
  make(targets) {
    const built = capture('cmake', ['--build', this.build, '-j', String(jobs), '--target', ...targets]);
    return built.ok ? undefined : built.out + built.err;
  }

  /** Runs the tests whose name matches: how many ran, and whether all passed. */
  test(pattern) {
    const report = join(this.folder, 'report.xml');
    rmSync(report, { force: true });
    const args = ['--test-dir', this.build, '-R', pattern, '--stop-on-failure', '--output-junit', report];
    // A fault may ask for memory without end; the limit (in kilobytes) keeps the machine usable.
    const { ok, out } = capture('sh', ['-c', 'ulimit -v 6000000; exec ctest "$@"', 'ctest', ...args]);
    const text = existsSync(report) ? readFileSync(report, 'utf8') : '';
    return { ran: [...text.matchAll(/<testcase/g)].length, passed: ok, out };
  }

  /** Keeps what the unchanged tree was built into, with its times to the nanosecond. */
  remember() {
    this.copy(this.build, this.clean);
  }

  copy(from, to) {
    rmSync(to, { recursive: true, force: true });
    const copied = capture('cp', ['-a', from, to]);
    if (!copied.ok) throw new Failure(`The build could not be copied:\n${copied.err}`);
  }

  /**
   * Writes the fault into the source. The function that it returns puts source and build back as they were, times
   * included, so that nothing is compiled only to undo a fault.
   */
  apply({ file, find, replace }) {
    const path = join(this.folder, file);
    const kept = join(this.folder, 'original');
    const exactly = (from, to) => capture('cp', ['-a', from, to]);
    exactly(path, kept);
    // A function as replacement: `$` in the text means itself.
    const faulty = readFileSync(path, 'utf8').replace(find, () => replace);
    writeFileSync(path, faulty);
    return () => {
      exactly(kept, path);
      this.copy(this.clean, this.build);
    };
  }

  dispose() {
    rmSync(this.folder, { recursive: true, force: true });
  }
}

/** The executables that hold the tests of a pattern, asked of ctest once everything is built. */
function targetsOf(workshop, pattern) {
  const listed = capture('ctest', ['--test-dir', workshop.build, '-R', pattern, '--show-only=json-v1']);
  if (!listed.ok) return [];
  const tests = JSON.parse(listed.out).tests;
  return [...new Set(tests.map(({ command }) => command?.[0]?.split('/').pop()).filter(Boolean))];
}

function judge(workshop, mutant) {
  const targets = targetsOf(workshop, mutant.test);
  if (targets.length === 0) return { verdict: 'NO TEST', note: `no test matches ${mutant.test}` };
  const restore = workshop.apply(mutant);
  try {
    const said = workshop.make(targets);
    if (said)
      return {
        verdict: 'NO BUILD',
        note: said.split('\n').find((line) => /error/.test(line)) ?? 'see the compiler',
      };
    const { ran, passed } = workshop.test(mutant.test);
    if (ran === 0) return { verdict: 'NO TEST', note: `nothing ran for ${mutant.test}` };
    return passed
      ? { verdict: 'SURVIVED', note: `${ran} tests of ${mutant.test} still pass` }
      : { verdict: 'caught', note: mutant.test };
  } finally {
    restore();
  }
}

/** Runs all mutants; fails when one survives, does not build, or names a line or a test that is not there. */
export async function runMutants({ only } = {}) {
  const mutants = readMutants(only);
  if (mutants.length === 0) throw new Failure('there is no mutant to run');
  const defects = mutants.flatMap((mutant) => {
    const reason = defect(mutant);
    return reason ? [`${mutant.file} (${mutant.why}): ${reason}`] : [];
  });
  if (defects.length > 0)
    throw new Failure(`mutants.json does not fit the sources:\n  ${defects.join('\n  ')}`);

  const workshop = new Workshop();
  const interrupted = () => {
    workshop.dispose();
    process.exit(130);
  };
  process.once('SIGINT', interrupted);
  process.once('SIGTERM', interrupted);
  let bad = 0;
  try {
    console.log('Building the unchanged tree.');
    const said = workshop.make(['plateau_tests']);
    if (said) throw new Failure(`The unchanged tree does not build:\n${said}`);
    const pattern = [...new Set(mutants.map(({ test }) => `(${test})`))].join('|');
    const before = workshop.test(pattern);
    if (!before.passed) throw new Failure(`The tests fail without any mutant:\n${before.out}`);
    workshop.remember();
    for (const mutant of mutants) {
      // A turn of the event loop, in which an interruption is heard.
      await setImmediate();
      const from = performance.now();
      const { verdict, note } = judge(workshop, mutant);
      if (verdict !== 'caught') bad += 1;
      const time = `${((performance.now() - from) / 1000).toFixed(1)} s`;
      console.log(
        `${verdict.padEnd(9)} ${time.padStart(8)}  ${mutant.file}: ${mutant.why}\n${' '.repeat(20)}${note}`,
      );
    }
  } finally {
    process.off('SIGINT', interrupted);
    process.off('SIGTERM', interrupted);
    workshop.dispose();
  }
  if (bad > 0) throw new Failure(`${bad} of ${mutants.length} mutants were not caught`);
  return `${mutants.length} mutants caught`;
}

if (isScript(import.meta.url)) {
  await main(async () => {
    await setup(['native']);
    const only = process.argv.find((word) => word.startsWith('--only='))?.slice('--only='.length);
    console.log(await runMutants({ only }));
  });
}
