import { describe, expect, test, vi } from 'vitest';
import { formatPoints, onBoard, parsePoints } from '../../../web/src/sketch/points.ts';
import { Computation, questionOf, type Computed } from '../../../web/src/sketch/computation.ts';
import type { PlaneCore, PlanePicture, PlaneQuestion } from '../../../web/src/sketch/plane.ts';
import { answerOf } from '../../../web/src/sketch/answer.ts';
import { circumcircle } from '../../../web/src/sketch/circumcircle.ts';
import type { Layer } from '../../../web/src/sketch/layers.ts';
import { askedNames, landmarksNamed, namesOf, parseAsked } from '../../../web/src/sketch/names.ts';
import { SketchEditor } from '../../../web/src/sketch/sketch-editor.ts';
import { changeInWords, reasonInWords, summary } from '../../../web/src/sketch/sketch-words.ts';
import * as states from '../../../web/src/sketch/sketch-state.ts';
import type { SketchState } from '../../../web/src/sketch/sketch-state.ts';
import { numberIn, numbersIn, same } from '../../../web/src/course/marking.ts';

function stateOf(attributes: Readonly<Record<string, string>>): SketchState {
  return states.stateFrom((name) => attributes[name] ?? null);
}

function pictureOf(question: PlaneQuestion): PlanePicture {
  const nothing = { delaunayEdges: [], delaunayTriangles: [], lists: [], vertices: [], edges: [] };
  return { question, ...nothing, triangles: [], cells: [], pairCells: [], betti: [1, 0] };
}

/** Answers when the test lets it. */
class SlowCore implements PlaneCore {
  readonly asked: PlaneQuestion[] = [];
  readonly waiting: (() => void)[] = [];
  scales = 0;

  async picture(question: PlaneQuestion): Promise<PlanePicture> {
    this.asked.push(question);
    await new Promise<void>((resolve) => this.waiting.push(resolve));
    return pictureOf(question);
  }
  why(): Promise<never> {
    return Promise.reject(new Error('not asked here'));
  }
  farthest(): ReturnType<PlaneCore['farthest']> {
    this.scales += 1;
    return Promise.resolve({ order: [2, 0, 1], epsilon: [5, 3, 0] });
  }
}

const unexpected = (error: unknown): never => {
  throw error;
};
const moment = (): Promise<void> => new Promise((resolve) => setTimeout(resolve, 0));

describe('points of a board', () => {
  test('are read as they are written, with any separator that an address allows', () => {
    const text = '20,30 45,12 0,80';
    expect(formatPoints(parsePoints(text))).toBe(text);
    expect(parsePoints('20,30_45,12;0,80')).toEqual(parsePoints(text));
    expect(parsePoints('  ')).toEqual([]);
  });

  test('stay on the board', () => {
    expect(onBoard(-3, 81)).toEqual({ x: 0, y: 80 });
    expect(onBoard(120.6, 12.4)).toEqual({ x: 120, y: 12 });
    expect(parsePoints('500,7.6')).toEqual([{ x: 120, y: 8 }]);
  });

  test.each(['20', '20,', '20,30,40', 'a,b', '20,-3'])('%s is no point, with a sentence', (text) => {
    expect(() => parsePoints(text)).toThrow(/is no point/);
  });
});

describe('the state of a sketch', () => {
  const state = stateOf({ landmarks: '1,1 9,1', witnesses: '5,5', nu: '1,3,3' });

  test('is read from attributes and written to them', () => {
    expect(state).toMatchObject({ nu: [1, 3, 3], step: 0, withExtra: false });
    expect(states.attributesOf(state)).toEqual({
      landmarks: '1,1 9,1',
      witnesses: '5,5',
      nu: '1,3,3',
      step: null,
      inserted: null,
      ask: null,
    });
    expect(states.attributesOf(stateOf({ ask: 'p2 1 a' }))).toMatchObject({ landmarks: null, ask: '1 2 a' });
    expect(states.attributesOf({ ...state, step: 4, withExtra: true })).toMatchObject({
      landmarks: null,
      step: '4',
      inserted: '',
    });
  });

  test.each([
    [{ nu: '1,x' }, /nu="1,x"/],
    [{ nu: '1,99' }, /nu="1,99"/],
    [{ step: '0' }, /step="0"/],
    [{ landmarks: 'here' }, /"here" is no point/],
    [{ ask: '1 b' }, /"b" is no landmark/],
  ])('%o is a sentence', (attributes, sentence) => {
    expect(() => stateOf(attributes as never)).toThrow(sentence);
  });

  test('two points of a kind are never in one place', () => {
    expect(states.added(state, 'landmark', { x: 9, y: 1 })).toBeUndefined();
    expect(states.added(state, 'witness', { x: 9, y: 1 })?.witnesses).toHaveLength(2);
    expect(states.moved(state, { kind: 'landmark', index: 0 }, { x: 9, y: 1 }, undefined)).toBeUndefined();
    expect(
      states.moved(state, { kind: 'landmark', index: 1 }, { x: 9, y: 1 }, undefined)?.landmarks[1],
    ).toEqual({ x: 9, y: 1 });
    expect(states.removed(state, { kind: 'landmark', index: 0 }).landmarks).toEqual([{ x: 9, y: 1 }]);
  });

  test('a landmark that is a witness takes it along, unless another one is there', () => {
    const own = stateOf({ landmarks: '1,1 9,1', witnesses: '5,5 1,1 7,7' });
    const name = { kind: 'landmark', index: 0 } as const;
    expect(states.ownWitness(own, name)).toBe(1);
    expect(states.ownWitness(own, { kind: 'landmark', index: 1 })).toBeUndefined();
    expect(states.moved(own, name, { x: 2, y: 2 }, 1)?.witnesses[1]).toEqual({ x: 2, y: 2 });
    expect(states.moved(own, name, { x: 7, y: 7 }, 1)?.witnesses).toEqual(own.witnesses);
    expect(states.moved(own, { kind: 'witness', index: 1 }, { x: 2, y: 2 }, undefined)?.landmarks).toEqual(
      own.landmarks,
    );
  });

  test('a question keeps its landmarks when another one is removed', () => {
    const asking = stateOf({ landmarks: '1,1 2,2 3,3 4,4', ask: '1 3 a' });
    const without = (index: number): readonly string[] =>
      states.removed(asking, { kind: 'landmark', index }).asked;
    expect(without(0)).toEqual(['2', 'a']);
    expect(without(1)).toEqual(['1', '2', 'a']);
    expect(without(3)).toEqual(['1', '3', 'a']);
    expect(states.removed(asking, { kind: 'witness', index: 0 }).asked).toEqual(['1', '3', 'a']);
  });

  test('keys walk around: landmarks, then witnesses; farthest first witnesses alone', () => {
    const next = (from?: states.PointName, forward = true, step = 0): states.PointName | undefined =>
      states.nextPoint({ ...state, step }, from, forward);
    expect(next()).toEqual({ kind: 'landmark', index: 0 });
    expect(next({ kind: 'landmark', index: 1 })).toEqual({ kind: 'witness', index: 0 });
    expect(next({ kind: 'witness', index: 0 })).toEqual({ kind: 'landmark', index: 0 });
    expect(next(undefined, false)).toEqual({ kind: 'witness', index: 0 });
    expect(next({ kind: 'landmark', index: 0 }, false)).toEqual({ kind: 'witness', index: 0 });
    expect(next(undefined, true, 1)).toEqual({ kind: 'witness', index: 0 });
    expect(states.nextPoint(stateOf({}), undefined, true)).toBeUndefined();
  });

  test('farthest first, the landmarks are the first witnesses of the order; a comes last', () => {
    const film = stateOf({ witnesses: '0,0 5,0 9,0', step: '2' });
    const scale = { order: [2, 0, 1], epsilon: [9, 5, 0] };
    const setting = { extra: { x: 3, y: 3 }, delaunay: true };
    expect(questionOf(film, setting, scale).landmarks).toEqual([
      { x: 9, y: 0 },
      { x: 0, y: 0 },
    ]);
    expect(questionOf({ ...film, withExtra: true }, setting, scale).landmarks.at(-1)).toEqual({ x: 3, y: 3 });
  });
});

describe('editing', () => {
  function editorOf(attributes: Readonly<Record<string, string>>): { editor: SketchEditor; said: string[] } {
    const said: string[] = [];
    const editor = new SketchEditor({
      changed: () => undefined,
      redraw: () => undefined,
      say: (sentence) => said.push(sentence),
      order: () => undefined,
      list: () => undefined,
      landmarkName: namesOf({}),
    });
    editor.open(stateOf(attributes));
    return { editor, said };
  }
  const times = (count: number, act: () => void): void => Array.from({ length: count }).forEach(act);

  test('a landmark passes over a witness and leaves it there', () => {
    const { editor } = editorOf({ landmarks: '26,20', witnesses: '26,16' });
    editor.step(true);
    times(6, () => editor.nudge(0, -1));
    expect(editor.state).toMatchObject({ landmarks: [{ x: 26, y: 14 }], witnesses: [{ x: 26, y: 16 }] });
  });

  test('its own witness passes over another one with it', () => {
    const { editor } = editorOf({ landmarks: '26,20', witnesses: '26,18 26,20' });
    editor.select({ kind: 'landmark', index: 0 });
    for (const y of [19, 18, 17, 15]) editor.drag({ x: 26, y });
    editor.drop();
    expect(formatPoints(editor.state.witnesses)).toBe('26,18 26,15');
    editor.undo();
    expect(formatPoints(editor.state.witnesses)).toBe('26,18 26,20');
  });

  test('where nothing may be edited a point can be selected, and nothing else', () => {
    const { editor, said } = editorOf({ landmarks: '1,1 9,1', witnesses: '5,5' });
    editor.editable = false;
    editor.step(true);
    const before = editor.state;
    editor.nudge(1, 0);
    editor.drag({ x: 3, y: 3 });
    editor.drop();
    editor.add('witness', { x: 40, y: 40 });
    editor.add('landmark', { x: 40, y: 40 });
    editor.remove();
    editor.undo();
    expect(editor.state).toBe(before);
    expect(editor.canUndo).toBe(false);
    expect(said).toEqual(['Landmark p1 at 1, 1']);
  });

  test('undo brings back the points and keeps the question, unless its landmarks had other names', () => {
    const { editor } = editorOf({ landmarks: '1,1 9,1 5,9', ask: '1 2' });
    editor.select({ kind: 'landmark', index: 0 });
    editor.nudge(1, 0);
    editor.ask(['2', '3']);
    editor.undo();
    expect(editor.state).toMatchObject({ asked: ['2', '3'], landmarks: [{ x: 1 }, { x: 9 }, { x: 5 }] });
    editor.select({ kind: 'landmark', index: 0 });
    editor.remove();
    expect(editor.state.asked).toEqual(['1', '2']);
    editor.undo();
    expect(editor.state.asked).toEqual(['2', '3']);
  });
});

describe('names', () => {
  const question = {
    landmarks: [1, 2, 3].map((x) => ({ x, y: 0 })),
    witnesses: [],
    nu: [1, 2, 3],
    delaunay: true,
  };

  test('the landmark that a button puts in is a, wherever it is named', () => {
    const withExtra = { ...question, extra: 2 };
    expect([0, 1, 2].map(namesOf(withExtra))).toEqual(['p1', 'p2', 'a']);
    expect([0, 1, 2].map(namesOf({ ...question, extra: undefined }))).toEqual(['p1', 'p2', 'p3']);
    expect(askedNames([2, 0], withExtra)).toEqual(['1', 'a']);
    expect(landmarksNamed(parseAsked('A, p1'), withExtra)).toEqual([0, 2]);
    // It has no number, and nobody else has its name.
    expect(landmarksNamed(parseAsked('1 3'), withExtra)).toEqual([0]);
    expect(landmarksNamed(parseAsked('1 a'), question)).toEqual([0]);
    expect(landmarksNamed(parseAsked('3 4'), question)).toEqual([2]);
  });

  test.each(['b', '1 w2', '-1', '0', '1.5'])('"%s" names no landmark, with a sentence', (text) => {
    expect(() => parseAsked(text)).toThrow(/is no landmark/);
  });
});

describe('asking the core', () => {
  const setting = { extra: undefined, delaunay: true };

  test('leaves out what a drag passes through, and shows the last state', async () => {
    const core = new SlowCore();
    const shown: Computed[] = [];
    const computation = new Computation(core, (computed) => shown.push(computed), unexpected);
    const at = (x: number): SketchState => stateOf({ landmarks: `${x},0` });
    computation.want(at(1), setting);
    await moment();
    computation.want(at(2), setting);
    computation.want(at(3), setting);
    const settled = computation.settled();
    while (core.waiting.length > 0) {
      core.waiting.shift()?.();
      await moment();
    }
    await settled;
    expect(core.asked.map(({ landmarks }) => landmarks[0]?.x)).toEqual([1, 3]);
    expect(shown.map(({ state }) => state.landmarks[0]?.x)).toEqual([3]);
  });

  test('asks for the order of the same witnesses once', async () => {
    const core = new SlowCore();
    const computation = new Computation(core, () => undefined, unexpected);
    for (const step of ['1', '2', '3']) {
      computation.want(stateOf({ witnesses: '0,0 5,0 9,0', step }), setting);
      await moment();
      core.waiting.shift()?.();
      await computation.settled();
    }
    expect(core.scales).toBe(1);
    expect(core.asked.map(({ landmarks }) => landmarks.length)).toEqual([1, 2, 3]);
  });

  test('a refusal is told, and the next question is answered', async () => {
    const core = new SlowCore();
    const failures: unknown[] = [];
    const shown: Computed[] = [];
    const computation = new Computation(
      core,
      (computed) => shown.push(computed),
      (error) => failures.push(error),
    );
    const refusing = vi.spyOn(core, 'picture').mockRejectedValueOnce(new Error('too many'));
    computation.want(stateOf({}), setting);
    await computation.settled();
    expect(failures).toHaveLength(1);
    refusing.mockRestore();
    computation.want(stateOf({}), setting);
    await moment();
    core.waiting.shift()?.();
    await computation.settled();
    expect(shown).toHaveLength(1);
  });
});

describe('in words', () => {
  test('a figure is told by its counts', () => {
    const question = {
      landmarks: [{ x: 1, y: 1 }],
      witnesses: [{ x: 1, y: 2 }],
      nu: [1, 2, 3],
      delaunay: true,
    };
    const complex = new Set<Layer>(['complex', 'names']);
    expect(summary(pictureOf(question), complex)).toBe(
      '1 landmark, 1 witness. The complex has 0 edges and 0 triangles: 1 component.',
    );
    expect(summary(pictureOf({ ...question, witnesses: [] }), complex)).toBe(
      '1 landmark, 0 witnesses: no complex without witnesses.',
    );
    expect(summary(pictureOf({ ...question, landmarks: [], witnesses: [] }), complex)).toMatch(
      /^The board is empty/,
    );
  });

  test('a figure is told by the layers that are on: no word of witnesses before there are any', () => {
    const question = {
      landmarks: [0, 1, 2].map((x) => ({ x, y: x * x })),
      witnesses: [],
      nu: [1, 2, 3],
      delaunay: true,
    };
    const corners = [0, 1, 2].map((x) => ({ x, y: x * x }));
    const picture: PlanePicture = {
      ...pictureOf(question),
      delaunayEdges: [
        [0, 1],
        [0, 2],
        [1, 2],
      ],
      delaunayTriangles: [[0, 1, 2]],
      pairCells: [
        { of: [0, 1], corners },
        { of: [1, 2], corners: [] },
      ],
    };
    const told = (...layers: Layer[]): string => summary(picture, new Set(layers));
    expect(told('cells', 'names')).toBe('3 landmarks.');
    expect(told('cells', 'delaunay')).toBe('3 landmarks: 3 Delaunay edges, 1 triangle.');
    expect(told('pairs')).toBe('3 landmarks: 1 cell of order two.');
  });

  test('edges that come and go are named, of the layer that is on', () => {
    const question = {
      landmarks: [0, 1, 2, 3].map((x) => ({ x, y: 0 })),
      witnesses: [],
      nu: [1, 2, 3],
      delaunay: true,
    };
    const withEdges = (...delaunayEdges: number[][]): PlanePicture => ({
      ...pictureOf(question),
      delaunayEdges,
    });
    const [before, flipped] = [withEdges([0, 1], [1, 3]), withEdges([0, 1], [0, 2])];
    const delaunay = new Set<Layer>(['delaunay']);
    expect(changeInWords(before, flipped, delaunay)).toBe('Now p1 p3 instead of p2 p4.');
    expect(changeInWords(before, before, delaunay)).toBe('');
    expect(changeInWords(before, withEdges([0, 1]), delaunay)).toBe('Gone: p2 p4.');
    expect(changeInWords(withEdges(), before, delaunay)).toBe('New: p1 p2 and p2 p4.');
    expect(changeInWords(before, flipped, new Set<Layer>(['complex']))).toBe('');
    const fewer = { ...flipped, question: { ...question, landmarks: question.landmarks.slice(1) } };
    expect(changeInWords(before, fewer, delaunay)).toBe('');
  });

  test.each([
    [
      [0, 3],
      { kind: 'present', witnesses: [1, 4], count: 2 },
      'The edge p1 p4 is in the complex. It has 2 witnesses: w2 and w5.',
    ],
    [
      [0, 1],
      { kind: 'no-witness', closest: 6, rank: 3, needed: 2 },
      'The edge p1 p2 has no witness. The closest miss is w7: it has to go down to the 3rd landmark of its list to find all corners, and may go no further than the 2nd.',
    ],
    [
      [0, 1, 2],
      { kind: 'missing-face', face: [0, 2], because: { kind: 'not-delaunay', inside: [3, 5] } },
      'The triangle p1 p2 p3 is not in the complex, because one of its faces is not: edge p1 p3. The edge p1 p3 is not in the Delaunay triangulation: every disc through its ends holds p4 or p6.',
    ],
    [
      [0, 1, 2],
      { kind: 'not-delaunay', inside: [3] },
      'The triangle p1 p2 p3 is not in the Delaunay triangulation: the disc through its corners holds p4.',
    ],
    [[0], { kind: 'untold', sentence: 'So it is.' }, 'So it is.'],
  ] as const)('%o: %o', (vertices, reason, sentence) => {
    expect(reasonInWords(vertices, reason, namesOf({}))).toBe(sentence);
  });

  test('an answer points at what it names: witnesses, the missing face, who is in the disc', () => {
    const nothing = { lit: [], face: [], blockers: [], disc: [] };
    expect(answerOf([0, 1], { kind: 'present', witnesses: [4, 5], count: 2 })).toEqual({
      ...nothing,
      lit: [4, 5],
    });
    const miss = { kind: 'no-witness', closest: 6, rank: 3, needed: 2 } as const;
    expect(answerOf([0, 1], miss)).toEqual({ ...nothing, lit: [6] });
    expect(answerOf([0, 1, 2], { kind: 'missing-face', face: [0, 2], because: miss })).toEqual({
      ...nothing,
      lit: [6],
      face: [0, 2],
    });
    const blocked = { kind: 'not-delaunay', inside: [3] } as const;
    expect(answerOf([0, 1, 2], blocked)).toEqual({ ...nothing, blockers: [3], disc: [0, 1, 2] });
    // Of an edge there are many discs.
    expect(answerOf([0, 1, 2], { kind: 'missing-face', face: [0, 2], because: blocked })).toEqual({
      ...nothing,
      face: [0, 2],
      blockers: [3],
    });
  });

  test('the circle of three points goes through them', () => {
    expect(
      circumcircle([
        { x: 0, y: 0 },
        { x: 8, y: 0 },
        { x: 0, y: 6 },
      ]),
    ).toEqual({ x: 4, y: 3, radius: 5 });
    expect(
      circumcircle([
        { x: 0, y: 0 },
        { x: 1, y: 1 },
        { x: 2, y: 2 },
      ]),
    ).toBeUndefined();
    expect(
      circumcircle([
        { x: 0, y: 0 },
        { x: 1, y: 1 },
      ]),
    ).toBeUndefined();
  });

  test('answers are read by their numbers, with their signs', () => {
    expect(numbersIn('p1, p3')).toEqual([1, 3]);
    expect(numbersIn('1-3, w2–4')).toEqual([1, 3, 2, 4]);
    expect(numberIn('-5')).toBe(-5);
    expect(numbersIn('1, −2.5')).toEqual([1, -2.5]);
    expect(numberIn('about 12')).toBe(12);
    expect(numberIn('1 or 2')).toBeUndefined();
    expect(numberIn('none')).toBeUndefined();
    expect(same([1, 2], [1, 2])).toBe(true);
    expect(same([1, 2], [1, 2, 3])).toBe(false);
  });
});
