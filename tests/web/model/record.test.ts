import { describe, expect, test } from 'vitest';
import { CHUNK_SIZE, ChunkedColumn, LifespanStore } from '../../../web/src/model/chunks.ts';
import { RunRecord } from '../../../web/src/model/record.ts';
import { NEVER, deltaOf, openedWith } from './fixtures.ts';

describe('a chunked column', () => {
  test('grows over the ends of chunks', () => {
    const column = new ChunkedColumn<Uint32Array>((length) => new Uint32Array(length));
    const parts = [5, CHUNK_SIZE - 5, 1, 2 * CHUNK_SIZE + 3];
    let next = 0;
    for (const count of parts) column.append(Uint32Array.from({ length: count }, () => next++));
    expect(column.length).toBe(next);
    for (const index of [0, 4, 5, CHUNK_SIZE - 1, CHUNK_SIZE, CHUNK_SIZE + 1, next - 1]) {
      expect(column.at(index)).toBe(index);
    }
    expect(() => column.at(next + CHUNK_SIZE)).toThrow(RangeError);
  });
});

describe('a store of lifespans', () => {
  test('says what may be drawn at a step', () => {
    const store = new LifespanStore(2, 2);
    const births = [2, 2, 3, 5, 5, 9];
    for (const birth of births) {
      store.append(Uint32Array.of(0, 1), Uint32Array.of(birth), [
        Uint32Array.of(NEVER),
        Uint32Array.of(birth),
      ]);
    }
    const [chunk] = store.chunks;
    expect([1, 2, 4, 5, 9, 99].map((step) => chunk?.bornBy(step))).toEqual([0, 2, 3, 5, 6, 6]);
    expect(chunk?.outlives(0, 100)).toBe(true);
    expect(chunk?.outlives(1, 9)).toBe(false);
    births.forEach((_, index) => store.setDeath(index, 0, 12));
    expect(chunk?.outlives(0, 11)).toBe(true);
    expect(chunk?.outlives(0, 12)).toBe(false);
  });

  test('keeps earlier chunks as they are and reports what changed', () => {
    const store = new LifespanStore(1, 1);
    const add = () => store.append(Uint32Array.of(7), Uint32Array.of(1), [Uint32Array.of(NEVER)]);
    for (let i = 0; i < CHUNK_SIZE; ++i) add();
    const [first] = store.chunks;
    const words = first?.words;
    expect(first?.takeDirty()).toEqual([{ from: 0, to: CHUNK_SIZE }]);
    add();
    expect(store.chunks).toHaveLength(2);
    expect(store.chunks[0]?.words).toBe(words);
    expect(first?.takeDirty()).toEqual([]);
    store.setDeath(10, 0, 4);
    store.setDeath(20, 0, 5);
    expect(first?.takeDirty()).toEqual([{ from: 10, to: 21 }]);
    // Far apart: what lies between them is not told.
    store.setDeath(30, 0, 6);
    store.setDeath(9000, 0, 6);
    expect(first?.takeDirty()).toEqual([
      { from: 30, to: 31 },
      { from: 9000, to: 9001 },
    ]);
    expect(words?.[10 * 3 + 2]).toBe(4);
  });
});

describe('the record', () => {
  test('puts landmarks, simplices, rows and late deaths where they belong', () => {
    const record = new RunRecord(openedWith());
    record.append(
      deltaOf(1, [2, 1, 1], {
        landmark: Uint32Array.of(4, 9, 6),
        shownFamily: Uint8Array.of(1, 1, 2),
        betti: Uint32Array.of(1, 0, 0, 2, 0, 0, 1, 2, 1),
        edges: Uint32Array.of(1, 2, 2, 3),
        edgeDeath: [Uint32Array.of(NEVER, NEVER), Uint32Array.of(3, NEVER)],
        triangles: Uint32Array.of(1, 2, 3),
        triangleDeath: [Uint32Array.of(NEVER), Uint32Array.of(3)],
        rowVertices: Uint32Array.of(1, 3, 2),
        rowFrom: Uint32Array.of(3),
        rowTo: Uint32Array.of(NEVER),
      }),
    );
    record.append(
      deltaOf(4, [0.5], { deaths: Uint32Array.of(1, 1, 1, 4, 2, 0, 0, 4), endedRows: Uint32Array.of(0, 4) }),
    );
    const words = (store: LifespanStore, index: number) => [
      ...(store.chunks[0]?.words.subarray(index * store.stride, (index + 1) * store.stride) ?? []),
    ];
    expect(words(record.points, 2)).toEqual([6, 3]);
    expect(words(record.edges, 0)).toEqual([4, 9, 2, NEVER, 3]);
    expect(words(record.edges, 1)).toEqual([9, 6, 3, NEVER, 4]);
    expect(words(record.triangles, 0)).toEqual([4, 9, 6, 3, 4, 3]);
    expect(words(record.rows, 0)).toEqual([4, 6, 9, 3, 4]);
    expect(record.summary(2)).toEqual({
      step: 2,
      epsilon: 1,
      family: 'delaunay',
      betti: [2, 0, 0],
      track: 1,
    });
    expect(record.summary(3)).toMatchObject({ family: 'surface', betti: [1, 2, 1], track: 0 });
    expect(record.stepCount).toBe(4);
  });

  test('knows the extremes of any range of steps', () => {
    const record = new RunRecord(openedWith());
    const values: number[] = [];
    let seed = 7;
    for (const count of [100, 500, 3, 700]) {
      const betti = Uint32Array.from(
        { length: 3 * count },
        () => (seed = (seed * 16807) % 2147483647) % 1000,
      );
      record.append(deltaOf(values.length / 3 + 1, new Array<number>(count).fill(1), { betti }));
      values.push(...betti);
    }
    for (const [first, last] of [
      [1, 1303],
      [1, 256],
      [2, 257],
      [257, 512],
      [200, 900],
      [1300, 1303],
      [5, 5],
    ] as const) {
      for (const k of [0, 1, 2]) {
        const range = Array.from(
          { length: last - first + 1 },
          (_, i) => values[3 * (first - 1 + i) + k] ?? 0,
        );
        expect(record.bettiExtremes(first, last, k)).toEqual([Math.min(...range), Math.max(...range)]);
      }
    }
  });

  test('refuses a gap', () => {
    const record = new RunRecord(openedWith());
    record.append(deltaOf(1, [3, 2]));
    expect(() => record.append(deltaOf(4, [1]))).toThrow(/do not follow/);
  });
});
