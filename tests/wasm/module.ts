import { readFileSync } from 'node:fs';
import createModule, { type Failed, type ModuleRun, type PlateauModule } from 'plateau-module';
import type { CloudSource, Delta, OpenedRun, RunOptions } from '../../web/src/worker/protocol.ts';

const wasmFile = new URL('../../build/wasm/bin/plateau.wasm', import.meta.url);

/** A fresh module under Node; it needs the bytes, since it finds no files here. */
export function loadModule(): Promise<PlateauModule> {
  return createModule({ wasmBinary: readFileSync(wasmFile) });
}

/** The value, or a thrown failure: for tests in which none is expected. */
export function expected<T extends object>(value: T | Failed): T {
  if ('failure' in value) throw new Error(`${value.failure.code}: ${value.failure.message}`);
  return value;
}

export function opened(run: ModuleRun): OpenedRun {
  for (;;) {
    const answer = expected(run.open(5));
    if (answer.kind === 'opened') return answer.opened;
  }
}

export function sample(shape: string, size: number): CloudSource {
  return { kind: 'sample', shape, size };
}

export function file(name: string, text: string | Uint8Array): CloudSource {
  const bytes = typeof text === 'string' ? new TextEncoder().encode(text) : text;
  return { kind: 'file', name, bytes: new Uint8Array(bytes).buffer };
}

/** Runs to the end in calls of the given budget. */
export function runThrough(run: ModuleRun, budgetMs: number): void {
  for (;;) {
    const { state } = expected(run.run(budgetMs, 0xffffffff));
    if (state === 'finished' || state === 'stopped') return;
  }
}

/** A run from its source to its end. */
export function finishedRun(module: PlateauModule, source: CloudSource, options: RunOptions = {}): ModuleRun {
  const run = new module.Run(source, options);
  opened(run);
  runThrough(run, Infinity);
  return run;
}

/** All deltas of a finished run, in pieces of about `maxSimplices`. */
export function allDeltas(run: ModuleRun, maxSimplices: number): Delta[] {
  const deltas: Delta[] = [];
  for (;;) {
    const delta = expected(run.delta(maxSimplices));
    deltas.push(delta);
    if (delta.state === 'finished') return deltas;
  }
}
