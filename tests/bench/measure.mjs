// Runs the rows of the plan, each in a process of its own, and takes medians.
import { execFile } from 'node:child_process';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import { Failure } from '../../scripts/lib/run.mjs';
import { ENOUGH_SECONDS, groupsOf, mostRounds, rebuildsOf } from './plan.mjs';

const median = (values) => [...values].sort((a, b) => a - b)[values.length >> 1];
const sum = (values) => values.reduce((total, value) => total + value, 0);
const moduleScript = fileURLToPath(new URL('module.mjs', import.meta.url));

const notMeasured = (row, remark) => ({
  ...row,
  seconds: undefined,
  megabytes: undefined,
  rounds: 0,
  share: undefined,
  remark,
});

/** `programs`: the folder of the native benchmarks; a row that takes longer than `patience` seconds is given up. */
export class Measurer {
  constructor(programs, patience, say) {
    this.programs = programs;
    this.patience = patience;
    this.say = say;
    /** By row without its size: the most points that were measured, and their seconds; Infinity where it failed. */
    this.last = new Map();
  }

  async all(sizes) {
    const results = [];
    for (const group of groupsOf(sizes)) results.push(...(await this.inTurn(group)));
    for (const row of rebuildsOf(sizes))
      results.push(...(await this.rebuild(row, sizes.length > 2 ? 16 : 8)));
    return results;
  }

  /** The rows one after the other, several times. */
  async inTurn(group) {
    const [{ cloud, points }] = group;
    this.say(`${cloud}, ${points} points`);
    const found = group.map((row) => ({ row, times: [], peaks: [], shares: [], remark: '' }));
    for (let round = 0; round < mostRounds(points); ++round) {
      for (const entry of found) {
        if (entry.remark !== '' || sum(entry.times) > ENOUGH_SECONDS) continue;
        const answer = await this.once(entry.row);
        if (typeof answer === 'string') entry.remark = answer;
        else {
          entry.times.push(answer.seconds);
          entry.peaks.push(answer.megabytes);
          entry.shares.push(answer.share);
        }
      }
    }
    return found.map(({ row, times, peaks, shares, remark }) =>
      remark === ''
        ? {
            ...row,
            seconds: median(times),
            megabytes: Math.max(...peaks),
            rounds: times.length,
            share: Math.min(...shares),
            remark,
          }
        : notMeasured(row, remark),
    );
  }

  async rebuild(row, intervals) {
    this.say(`rebuild with GUDHI at sampled steps: ${row.what}`);
    const answer = await this.once(row, [String(intervals)]);
    if (typeof answer === 'string') return [notMeasured(row, answer)];
    this.say(`  Betti numbers equal at steps ${answer.equalBettiAt.join(', ')}`);
    const common = { ...row, megabytes: undefined, rounds: 1, share: undefined };
    return [
      { ...common, seconds: answer.rebuildSeconds, remark: `equal at ${answer.equalBettiAt.length} steps` },
      { ...common, runner: 'beside rebuild', seconds: answer.seconds, remark: '' },
    ];
  }

  /** What the process printed, or why it printed nothing. */
  async once(row, more = []) {
    const key = `${row.runner} ${row.cloud} ${row.what}`;
    const last = this.last.get(key) ?? { points: row.points, seconds: 0 };
    // Nothing here takes less than linear time.
    if ((last.seconds * row.points) / last.points > this.patience)
      return `not tried: would take over ${this.patience} s`;
    const native = `${this.programs}/run_bench`;
    const words = [row.cloud, String(row.points), row.what, ...more];
    const [program, args] = {
      native: [native, words],
      rebuild: [`${this.programs}/rebuild_bench`, words],
      module: [process.execPath, [moduleScript, ...words]],
    }[row.runner];
    const options = {
      timeout: this.patience * 1000,
      killSignal: 'SIGKILL',
      env: { ...process.env, PLATEAU_BENCH: native },
    };
    try {
      const { stdout } = await promisify(execFile)(program, args, options);
      const answer = JSON.parse(stdout);
      this.last.set(key, { points: row.points, seconds: answer.seconds });
      return answer;
    } catch (error) {
      this.last.set(key, { points: row.points, seconds: Infinity });
      // A wrong number is no matter of speed.
      if (row.runner === 'rebuild' && error.code === 1) throw new Failure(error.stderr.trim());
      if (error.killed) return `over ${this.patience} s`;
      return `failed: ${(error.stderr ?? error.message).trim().split('\n').at(-1) || error.signal}`;
    }
  }
}
