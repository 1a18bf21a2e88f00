import type { CloudSource, Family, RunOptions } from '../worker/protocol.ts';
import { SCAN_POINTS } from '../model/forecast.ts';
import { measuredShape } from './measured-shapes.ts';
import { SAMPLES } from './samples.ts';

/** What the visitor chose to look at. A file is kept, not its bytes: it is read anew for other settings. */
export type SourceChoice =
  | { readonly kind: 'sample'; readonly shape: string; readonly size: number; readonly noise?: number }
  | {
      readonly kind: 'file';
      readonly file: File;
      readonly columns?: readonly number[];
      /** A session is run with the settings of the page. */
      readonly newOptions?: boolean;
      /** False: it was made here, of a link or of text, and no command finds it. */
      readonly onDisk?: boolean;
    };

/** What the page begins with. */
export interface Start {
  /** Undefined: an empty page. */
  readonly choice: SourceChoice | undefined;
  readonly options: RunOptions;
  /** Bytes; undefined: what the module allows. */
  readonly memoryLimit: number | undefined;
}

/** A scan ends at its noise, unless its end was asked for. */
export function withDefaults(
  choice: SourceChoice,
  options: RunOptions,
  memoryLimit: number | undefined,
): RunOptions {
  const endAsked = options.maxSteps !== undefined || options.untilEpsilon !== undefined;
  return {
    ...options,
    ...(choice.kind === 'file' && !endAsked ? { noiseStopFrom: SCAN_POINTS } : {}),
    ...(memoryLimit === undefined ? {} : { memoryLimit }),
  };
}

export function sourceName(choice: SourceChoice): string {
  if (choice.kind === 'file') return choice.file.name;
  return SAMPLES.find(({ shape }) => shape === choice.shape)?.label ?? choice.shape;
}

/** A name for saved files: that of the shape, or of the file without its ending. */
export function fileStem(choice: SourceChoice): string {
  if (choice.kind === 'sample') return choice.shape;
  return choice.file.name.replace(/\.[^.]*$/, '') || 'points';
}

export async function cloudSource(choice: SourceChoice): Promise<CloudSource> {
  if (choice.kind === 'sample') return measuredShape(choice) ?? choice;
  const { file, columns, newOptions } = choice;
  let bytes: ArrayBuffer;
  try {
    bytes = await file.arrayBuffer();
  } catch {
    throw new Error(
      `${file.name} could not be read. It may have been moved, or it is too large for this browser.`,
    );
  }
  return {
    kind: 'file',
    name: file.name,
    bytes,
    ...(columns && columns.length > 0 ? { columns, anyDimension: true } : {}),
    ...(newOptions ? { newOptions } : {}),
  };
}

const FAMILIES: readonly string[] = [
  'witness',
  'delaunay',
  'surface',
  'auto',
  'dilated',
] satisfies readonly Family[];

export function isFamily(text: string): text is Family {
  return FAMILIES.includes(text);
}

/** The helix, or what the address asks for: ?sample=torus&n=800&family=surface, ?sample=none for nothing; &memory=512: MB that a run may take. */
export function startFrom(query: string): Start {
  const asked = new URLSearchParams(query);
  const sample = SAMPLES.find(({ shape }) => shape === asked.get('sample'));
  const size = Number(asked.get('n'));
  const family = asked.get('family') ?? '';
  const options = isFamily(family) ? { family } : (sample?.options ?? {});
  const megabytes = Number(asked.get('memory'));
  const memoryLimit = megabytes > 0 ? megabytes * 2 ** 20 : undefined;
  if (asked.get('sample') === 'none') return { choice: undefined, options, memoryLimit };
  const { shape, size: usual } = sample ?? { shape: 'helix', size: 3000 };
  return {
    choice: { kind: 'sample', shape, size: Number.isInteger(size) && size > 0 ? size : usual },
    options,
    memoryLimit,
  };
}
