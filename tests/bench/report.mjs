// The tables of docs/speed.md from the results: what was measured, what it should reach, what misses it and why.
import { BASE, families, growthReach, memoryReach, moduleReach, rebuildReach, targets } from './plan.mjs';
import { rowOf } from './results.mjs';

const three = (value) =>
  value >= 100 ? Math.round(value).toLocaleString('en') : String(Number(value.toPrecision(3)));
const time = (seconds) => (seconds < 1 ? `${three(seconds * 1000)} ms` : `${three(seconds)} s`);
const size = (megabytes) => (megabytes < 1000 ? `${three(megabytes)} MB` : `${three(megabytes / 1000)} GB`);
const count = (points) => points.toLocaleString('en');
const isNumber = (value) => Number.isFinite(value);

/** A table in Markdown, empty without rows, with its columns under each other, which a terminal shows as well. */
function table(head, rows) {
  if (rows.length === 0) return '';
  const widths = head.map((cell, i) => Math.max(cell.length, 3, ...rows.map((row) => row[i].length)));
  const line = (cells) => `| ${cells.map((cell, i) => cell.padEnd(widths[i])).join(' | ')} |`;
  return [line(head), line(widths.map((width) => '-'.repeat(width))), ...rows.map(line)].join('\n');
}

/** Judges measured values against what they should reach, and collects what misses by its reason. */
class Verdicts {
  misses = new Map();

  /** What is asked and whether it is reached. `most`: small is good; `remark`: why there is no value. */
  of(name, value, { reach, then, why }, { most = true, show = three, remark = '' } = {}) {
    const limit = `${most ? '≤' : '≥'} ${show(reach)}`;
    const asked = then === undefined ? limit : `${limit}, then ${show(then)}`;
    if (!isNumber(value)) {
      this.miss('Not measured:', `${name}, ${limit}${remark && ` (${remark})`}`);
      return [asked, 'not measured'];
    }
    const good = (bound) => bound !== undefined && (most ? value <= bound : value >= bound);
    if (good(then)) return [asked, 'yes, both'];
    if (good(reach)) return [asked, 'yes'];
    this.miss(why, `${name}: ${show(value)} instead of ${limit}`);
    return [asked, '**no**'];
  }

  miss(why, line) {
    this.misses.set(why, [...(this.misses.get(why) ?? []), line]);
  }

  text() {
    if (this.misses.size === 0) return 'Nothing of what was measured.';
    return [...this.misses]
      .map(([why, lines]) => [why, '', ...lines.map((line) => `- ${line}`)].join('\n'))
      .join('\n\n');
  }
}

function targetCells(verdicts, row, overBase) {
  const own = targets.filter(
    (each) => each.cloud === row.cloud && each.what === row.what && each.points === row.points,
  );
  const cells = own.map((target) => {
    const name = `${row.cloud} ${row.what}, ${count(row.points)} points`;
    const [value, show] = {
      T_D: [overBase, (number) => `${three(number)} T_D`],
      s: [row.seconds, time],
      MB: [row.megabytes, size],
    }[target.unit];
    return verdicts.of(name, value, target, { show, remark: row.remark });
  });
  return [cells.map(([asked]) => asked).join('; '), cells.map(([, met]) => met).join('; ')];
}

const overBaseOf = (rows, row) => {
  const base = rowOf(rows, 'native', row.cloud, row.points, BASE);
  return base && row.seconds / base.seconds;
};

function runsTable(rows, verdicts) {
  const body = rows
    .filter(({ runner }) => runner === 'native')
    .map((row) => {
      const over = overBaseOf(rows, row);
      return [
        row.cloud,
        count(row.points),
        families.includes(row.what) ? `whole run, ${row.what}` : row.what,
        isNumber(row.seconds) ? time(row.seconds) : row.remark,
        isNumber(over) ? three(over) : '',
        isNumber(row.megabytes) ? size(row.megabytes) : '',
        ...targetCells(verdicts, row, over),
      ];
    });
  return table(['cloud', 'points', 'what', 'time', 'over T_D', 'peak memory', 'reach', 'reached'], body);
}

function growthTable(rows, verdicts) {
  const body = [];
  for (const cloud of ['torus', 'cube']) {
    for (const what of families) {
      const [few, many] = [10_000, 100_000].map((points) => rowOf(rows, 'native', cloud, points, what));
      if (!few || !many) continue;
      const [before, after] = [overBaseOf(rows, few), overBaseOf(rows, many)];
      const name = `${cloud} ${what}, growth of (whole run)/T_D`;
      const [asked, met] = verdicts.of(name, after / before, growthReach(what), {
        remark: few.remark || many.remark,
      });
      const cell = (value) => (isNumber(value) ? three(value) : '');
      body.push([`${cloud} ${what}`, cell(before), cell(after), cell(after / before), asked, met]);
    }
  }
  return table(['run', 'over T_D at 10,000', 'at 100,000', 'growth', 'reach', 'reached'], body);
}

function memoryTable(rows, verdicts) {
  const body = [];
  for (const row of rows.filter((each) => each.runner === 'native' && families.includes(each.what))) {
    if (row.points !== 1_000_000) continue;
    const fewer = rowOf(rows, 'native', row.cloud, 100_000, row.what);
    if (!fewer) continue;
    const factor = row.megabytes / fewer.megabytes;
    const name = `${row.cloud} ${row.what}, memory for ten times the points`;
    const [asked, met] = verdicts.of(name, factor, memoryReach, { remark: row.remark || fewer.remark });
    const cell = (value, show) => (isNumber(value) ? show(value) : '');
    const [before, after] = [fewer.megabytes, row.megabytes].map((each) => cell(each, size));
    body.push([`${row.cloud} ${row.what}`, before, after, cell(factor, three), asked, met]);
  }
  return table(['run', 'peak at 100,000', 'at 1,000,000', 'factor', 'reach', 'reached'], body);
}

function moduleTable(rows, verdicts) {
  const body = rows
    .filter(({ runner }) => runner === 'module')
    .map((row) => {
      const native = rowOf(rows, 'native', row.cloud, row.points, row.what);
      const ratio = row.seconds / native.seconds;
      const name = `module, ${row.cloud} ${row.what}, ${count(row.points)} points`;
      return [
        `${row.cloud} ${row.what}`,
        count(row.points),
        isNumber(native.seconds) ? time(native.seconds) : native.remark,
        isNumber(row.seconds) ? time(row.seconds) : row.remark,
        isNumber(ratio) ? three(ratio) : '',
        isNumber(row.megabytes) ? size(row.megabytes) : '',
        ...verdicts.of(name, ratio, moduleReach, { remark: row.remark || native.remark }),
      ];
    });
  return table(
    ['run', 'points', 'native', 'module', 'module / native', 'its memory', 'reach', 'reached'],
    body,
  );
}

function rebuildTable(rows, verdicts) {
  const body = rows
    .filter(({ runner }) => runner === 'rebuild')
    .map((row) => {
      const ours = rowOf(rows, 'beside rebuild', row.cloud, row.points, row.what);
      const times = row.seconds / ours?.seconds;
      const name = `rebuild, ${row.cloud} ${row.what}`;
      const show = (value) => `${three(value)} ×`;
      // The target is one for 10,000 points; with fewer there is less to win.
      const judged =
        row.points === 10_000
          ? verdicts.of(name, times, rebuildReach, { most: false, show, remark: row.remark })
          : ['', ''];
      return [
        `${row.cloud} ${row.what}`,
        count(row.points),
        isNumber(row.seconds) ? time(row.seconds) : row.remark,
        ours ? time(ours.seconds) : '',
        isNumber(times) ? show(times) : '',
        ours ? row.remark : '',
        ...judged,
      ];
    });
  return table(
    ['run', 'points', 'rebuilt at every step', 'whole run', 'faster', 'Betti numbers', 'reach', 'reached'],
    body,
  );
}

/** Says of a busy machine that it was one. */
function quietness(rows) {
  const shares = rows.map(({ share }) => share).filter(isNumber);
  if (shares.length === 0) return 'How much of a processor the rows had was not counted.';
  const least = Math.round(100 * Math.min(1, ...shares));
  return least >= 95
    ? `Each row had a processor for itself, at least ${least} % of the time.`
    : `**The machine was busy:** a row had a processor only ${least} % of its time, so times and ratios are rough.`;
}

/** Everything between the markers of docs/speed.md; the same text is printed. */
export function report({ machine, rows }) {
  const verdicts = new Verdicts();
  const sections = [
    ['Whole runs and their parts', runsTable(rows, verdicts)],
    ['Growth of (whole run)/T_D', growthTable(rows, verdicts)],
    ['Memory for ten times the points', memoryTable(rows, verdicts)],
    ['The module under Node.js against native', moduleTable(rows, verdicts)],
    ['Against a rebuild with GUDHI at every step', rebuildTable(rows, verdicts)],
  ].filter(([, text]) => text !== '');
  return [
    `Machine: ${machine}. ${quietness(rows)}`,
    ...sections.map(([title, text]) => `### ${title}\n\n${text}`),
    `### What misses its reach, and why\n\n${verdicts.text()}`,
  ].join('\n\n');
}

const [begin, end] = ['<!-- written by npm run bench: begin -->', '<!-- written by npm run bench: end -->'];

/** The page with the report between its markers. */
export function withReport(page, text) {
  const [from, to] = [page.indexOf(begin), page.indexOf(end)];
  if (from < 0 || to < from)
    throw new Error('docs/speed.md has lost the markers that the tables go between.');
  return `${page.slice(0, from)}${begin}\n\n${text}\n\n${page.slice(to)}`;
}
