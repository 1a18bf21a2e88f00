import { RunRecord } from '../../../web/src/model/record.ts';
import type { Delta, Opened, Plateaus } from '../../../web/src/worker/protocol.ts';

export const NEVER = 0xffffffff;

export function openedWith(parts: Partial<Opened> = {}): Opened {
  return {
    points: 10,
    dimension: 3,
    bettiCount: 3,
    field: 2,
    otherField: 0,
    metric: 'euclidean',
    coordinates: new Float64Array(30),
    family: 'auto',
    nu: [1, 6, 6, 4],
    stepsPlanned: 10,
    minLength: 0,
    estimatedBytes: 1,
    memoryLimitBytes: 2,
    stepsAffordable: 10,
    frame: {
      scale: 1,
      count: 10,
      axes: 3,
      shares: [],
      positions: new Float32Array(),
      beyond: new Float32Array(),
      outline: new Float32Array(),
    },
    warnings: [],
    ...parts,
  };
}

/** A delta of steps with the given ε and nothing else but one landmark each. */
export function deltaOf(firstStep: number, epsilon: readonly number[], parts: Partial<Delta> = {}): Delta {
  const none = new Uint32Array();
  const count = epsilon.length;
  return {
    state: 'running',
    firstStep,
    stepCount: firstStep + count - 1,
    hash: '0123456789abcdef',
    memoryBytes: 0,
    noise: 0,
    endedAtNoise: false,
    endedAtPlateau: false,
    pumps: new Float64Array(),
    landmark: Uint32Array.from({ length: count }, (_, i) => firstStep + i - 1),
    epsilon: Float64Array.from(epsilon),
    shownFamily: new Uint8Array(count).fill(1),
    betti: Uint32Array.from({ length: 3 * count }, (_, i) => (i % 3 === 0 ? 1 : 0)),
    otherBetti: none,
    edges: none,
    edgeDeath: [none, none],
    triangles: none,
    triangleDeath: [none, none],
    deaths: none,
    rowVertices: none,
    rowFrom: none,
    rowTo: none,
    endedRows: none,
    ...parts,
  };
}

/** A record of steps with the given ε. */
export function recordOf(
  epsilon: readonly number[],
  state: 'running' | 'finished' = 'finished',
  planned = 10,
  minLength = 0,
): RunRecord {
  const record = new RunRecord(openedWith({ stepsPlanned: planned, minLength }));
  record.append(deltaOf(1, epsilon, { state }));
  return record;
}

export interface PlainPlateau {
  readonly steps: readonly [number, number];
  readonly epsilon: readonly [number, number];
  readonly ratio: number;
  readonly family: number;
  readonly betti: readonly number[];
  readonly torsion?: readonly number[];
}

export function plateausOf(list: readonly PlainPlateau[]): Plateaus {
  return {
    firstStep: Uint32Array.from(list, ({ steps }) => steps[0]),
    lastStep: Uint32Array.from(list, ({ steps }) => steps[1]),
    middleStep: Uint32Array.from(list, ({ steps }) => Math.floor((steps[0] + steps[1]) / 2)),
    epsilonFirst: Float64Array.from(list, ({ epsilon }) => epsilon[0]),
    epsilonLast: Float64Array.from(list, ({ epsilon }) => epsilon[1]),
    ratio: Float64Array.from(list, ({ ratio }) => ratio),
    family: Uint8Array.from(list, ({ family }) => family),
    betti: Uint32Array.from(list.flatMap(({ betti }) => betti)),
    torsion: Uint32Array.from(list.flatMap(({ betti, torsion }) => torsion ?? betti.map(() => 0))),
    ranked: Uint32Array.from(list.map((_, i) => i)),
  };
}
