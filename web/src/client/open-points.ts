import type { CloudSource, RunOptions } from '../worker/protocol.ts';
import type { PlateauClient, RemoteRun } from './plateau-client.ts';

/** A run, and with which options it was opened in the end. */
interface OpenedPoints {
  readonly run: RemoteRun;
  readonly options: RunOptions;
}

/** These say only where a run may end by itself. */
const LIMITS: readonly string[] = ['noiseStopFrom', 'memoryLimit'] satisfies readonly (keyof RunOptions)[];

/** What is asked of the run. */
function askedOf(options: RunOptions): RunOptions {
  const asked = Object.entries(options).filter(
    ([name, value]) => value !== undefined && !LIMITS.includes(name),
  );
  return Object.fromEntries(asked);
}

/**
 * Opens points. A session runs with its own options except those that are given, as with the command; since it says its
 * own when it is read, it is read twice then: `read` hands its bytes out anew each time.
 */
export async function openPoints(
  client: PlateauClient,
  read: () => CloudSource | Promise<CloudSource>,
  options: RunOptions,
  signal?: AbortSignal,
): Promise<OpenedPoints> {
  const run = await client.open(await read(), options, signal);
  const { session } = run.opened;
  if (!session) return { run, options };
  const asked = askedOf(options);
  if (Object.keys(asked).length === 0) return { run, options: session.options };
  run.close().catch(() => undefined);
  const { memoryLimit } = options;
  const merged = { ...session.options, ...asked, ...(memoryLimit === undefined ? {} : { memoryLimit }) };
  const source = await read();
  const amended = source.kind === 'file' ? { ...source, newOptions: true } : source;
  return { run: await client.open(amended, merged, signal), options: merged };
}
