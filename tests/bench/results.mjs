// The results as a file: a line about the machine, then one row a measurement.
import { cpus, totalmem } from 'node:os';

const columns = ['runner', 'cloud', 'points', 'what', 'seconds', 'megabytes', 'rounds', 'share', 'remark'];
const numeric = new Set(['points', 'seconds', 'megabytes', 'rounds', 'share']);

export function machineLine(compiler) {
  const [{ model }] = cpus();
  const memory = Math.round(totalmem() / 2 ** 30);
  const day = new Date().toISOString().slice(0, 10);
  return `${model.replace(/\s+/g, ' ')}, one thread of ${cpus().length}, ${memory} GB; ${compiler}, Node.js ${process.versions.node}; ${day}`;
}

const shown = (value) => {
  if (value === undefined) return '';
  if (typeof value === 'number') return String(Number(value.toPrecision(6)));
  return value.replaceAll(/[",\n]/g, ';');
};

export function toCsv({ machine, rows }) {
  const lines = rows.map((row) => columns.map((column) => shown(row[column])).join(','));
  return [`# ${machine}`, columns.join(','), ...lines, ''].join('\n');
}

export function fromCsv(text) {
  const [first, head, ...lines] = text.trim().split('\n');
  if (!first.startsWith('# ') || head !== columns.join(',')) throw new Error('This is no file of results.');
  const value = (column, word) => {
    if (!numeric.has(column)) return word;
    return word === '' ? undefined : Number(word);
  };
  const rows = lines.map((line) =>
    Object.fromEntries(line.split(',').map((word, i) => [columns[i], value(columns[i], word)])),
  );
  return { machine: first.slice(2), rows };
}

/** The row, measured or given up; undefined when it was not in the plan. */
export function rowOf(rows, runner, cloud, points, what) {
  return rows.find(
    (row) => row.runner === runner && row.cloud === cloud && row.points === points && row.what === what,
  );
}
