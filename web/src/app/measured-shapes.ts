import { PlateauError } from '../client/plateau-error.ts';
import type { CloudSource } from '../worker/protocol.ts';
import { BUNNY, COLORS } from './samples.ts';

interface Asked {
  readonly shape: string;
  readonly size: number;
  readonly noise?: number;
}

/** A shape that is not computed but measured: what it is made of is loaded when it is first asked for. */
export function measuredShape({ shape, size, noise = 0 }: Asked): Promise<CloudSource> | undefined {
  if (shape === BUNNY) return bunny(size, noise);
  return shape === COLORS ? colors(size) : undefined;
}

/** What a shape is made of, as a program that lies beside this one. */
async function loaded<T>(shape: string, program: Promise<T>): Promise<T> {
  try {
    return await program;
  } catch (cause) {
    throw new PlateauError(
      'cannot-read',
      `What the shape "${shape}" is made of cannot be read: it is gone from its server, or there is no answer.`,
      { cause },
    );
  }
}

function asFile(name: string, text: string): CloudSource {
  return { kind: 'file', name, bytes: new TextEncoder().encode(text).buffer };
}

async function bunny(size: number, noise: number): Promise<CloudSource> {
  const { bunnyText } = await loaded(BUNNY, import('../model/bunny-points.ts'));
  return asFile('bunny.xyz', bunnyText(size, noise));
}

/** Distances. */
async function colors(size: number): Promise<CloudSource> {
  const { colorDistances } = await loaded(COLORS, import('../model/color-distances.ts'));
  return asFile('colors.csv', await colorDistances(size));
}
