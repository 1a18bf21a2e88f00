// What the course says in numbers is computed here, from the figures as the pages have them.
import { readFileSync, readdirSync } from 'node:fs';
import { beforeAll, describe, expect, test } from 'vitest';
import { COURSE_FILES, COURSE_PAGES, coursePage, FORMULAS } from '../../web/course/pages.ts';
import { PlateauClient, type RemoteRun } from '../../web/src/client/plateau-client.ts';
import { shownFamilyName } from '../../web/src/model/record.ts';
import { InProcessWorker } from '../../web/src/package/in-process.ts';
import { SETTABLE } from '../../web/src/course/links.ts';
import { ClientPlaneCore } from '../../web/src/sketch/client-plane-core.ts';
import { questionOf } from '../../web/src/sketch/computation.ts';
import type { FarthestOrder, PlanePicture } from '../../web/src/sketch/plane.ts';
import { drawn, parsePoints, type Point } from '../../web/src/sketch/points.ts';
import { stateFrom } from '../../web/src/sketch/sketch-state.ts';
import type { Delta, Family, RunOptions } from '../../web/src/worker/protocol.ts';

const folder = new URL('../../web/course/', import.meta.url);
const files = readdirSync(folder).filter((name) => name.endsWith('.html'));
const pages = new Map(files.map((name) => [name, readFileSync(new URL(name, folder), 'utf8')]));
const everything = [...pages.values()].join('\n');

interface Claim {
  readonly about: string;
  readonly value: string;
  readonly text: string;
}

const claims: Claim[] = [
  ...everything.matchAll(/<data\s+value="([^"]*)"\s+data-claim="([^"]*)"\s*>([^<]*)<\/data\s*>/g),
].map(([, value = '', about = '', text = '']) => ({ about, value, text: text.trim() }));

const WORDS = [
  'no',
  'one',
  'two',
  'three',
  'four',
  'five',
  'six',
  'seven',
  'eight',
  'nine',
  'ten',
  'eleven',
  'twelve',
];

/** The attributes of a figure as the page has them. */
function attributesOf(id: string): (name: string) => string | null {
  const tag = [...everything.matchAll(/<(?:plane-sketch|plateau-view)\s[^>]*>/g)]
    .map(([text]) => text)
    .find((text) => text.includes(`id="${id}"`));
  if (tag === undefined) throw new Error(`There is no figure ${id}.`);
  return (name) => new RegExp(`\\s${name}="([^"]*)"`).exec(tag)?.[1] ?? null;
}

class Calculator extends ClientPlaneCore {
  private readonly pictures = new Map<string, Promise<{ picture: PlanePicture; scale?: FarthestOrder }>>();

  sketch(id: string): Promise<{ picture: PlanePicture; scale?: FarthestOrder }> {
    let known = this.pictures.get(id);
    if (!known) this.pictures.set(id, (known = this.draw(id)));
    return known;
  }

  /** With the landmark a put in, too. */
  async bothWays(id: string): Promise<[PlanePicture, PlanePicture]> {
    const { picture } = await this.sketch(id);
    const extra = parsePoints(attributesOf(id)('extra') ?? '');
    const { landmarks } = picture.question;
    return [picture, await this.picture({ ...picture.question, landmarks: [...landmarks, ...extra] })];
  }

  private async draw(id: string): Promise<{ picture: PlanePicture; scale?: FarthestOrder }> {
    const read = attributesOf(id);
    const state = stateFrom(read);
    const scale = state.step > 0 ? await this.farthest(state.witnesses) : undefined;
    const extra = parsePoints(read('extra') ?? '')[0];
    const question = questionOf(state, { extra, delaunay: read('complex') !== 'whole' }, scale);
    return { picture: await this.picture(question), ...(scale ? { scale } : {}) };
  }

  /** The run of a view, with other options if there are any. */
  async run(id: string, other: RunOptions = {}): Promise<{ run: RemoteRun; deltas: Delta[] }> {
    const read = attributesOf(id);
    const nu = read('nu')?.split(',').map(Number);
    const steps = read('steps');
    const options: RunOptions = {
      ...(read('family') === null ? {} : { family: read('family') as Family }),
      ...(nu ? { nu } : {}),
      ...(steps === null ? {} : { maxSteps: Number(steps) }),
      ...other,
    };
    const source = { kind: 'sample', shape: read('shape') ?? '', size: Number(read('size')) } as const;
    const run = await this.client.open(source, options);
    const deltas: Delta[] = [];
    do {
      deltas.push(await run.fetchDelta());
      await new Promise((resolve) => setTimeout(resolve, 1));
    } while (deltas.at(-1)?.state !== 'finished');
    return { run, deltas };
  }

  /** Betti numbers of a view at the step that it shows. */
  async bettiAtStep(id: string, other: RunOptions): Promise<number[]> {
    const step = Number(attributesOf(id)('step'));
    const { run, deltas } = await this.run(id, { ...other, maxSteps: step });
    const { bettiCount } = run.opened;
    await run.close();
    return deltas.flatMap(({ betti }) => [...betti]).slice((step - 1) * bettiCount, step * bettiCount);
  }

  /** Betti numbers of the longest plateau of a kind. */
  async longest(id: string, family: string): Promise<string> {
    const { run } = await this.run(id);
    const plateaus = await run.fetchPlateaus();
    const { bettiCount } = run.opened;
    await run.close();
    const best = [...plateaus.ranked].find((i) => shownFamilyName(plateaus.family[i] ?? 0) === family);
    if (best === undefined) return 'none';
    return [...plateaus.betti.subarray(best * bettiCount, (best + 1) * bettiCount)].join();
  }
}

type Compute = (core: Calculator, id: string, rest: readonly string[]) => Promise<number | string>;
const ofPicture =
  (read: (picture: PlanePicture) => number | undefined): Compute =>
  async (core, id) =>
    read((await core.sketch(id)).picture) ?? NaN;

const names = ({ edges }: PlanePicture): string[] => edges.map(({ vertices }) => vertices.join());

/** Loops of a complex without triangles that an edge of the other one closes, or without which it is open. */
function loopsOnlyIn(one: PlanePicture, other: PlanePicture): number {
  if (one.triangles.length > 0) return NaN;
  const shared = one.edges.filter(({ vertices }) => names(other).includes(vertices.join()));
  const group = new Map<number, number>();
  const root = (vertex: number): number => {
    const next = group.get(vertex);
    return next === undefined ? vertex : root(next);
  };
  let loops = 0;
  for (const { vertices } of shared) {
    const [a = 0, b = 0] = vertices.map(root);
    if (a === b) loops += 1;
    else group.set(a, b);
  }
  return (one.betti[1] ?? NaN) - loops;
}

const walk = (places: readonly Point[]): number =>
  places
    .slice(1)
    .reduce((sum, { x, y }, i) => sum + Math.hypot(x - (places[i]?.x ?? x), y - (places[i]?.y ?? y)), 0);
/** "About" is to the nearest five. */
const about = (value: number): number => 5 * Math.round(value / 5);

const RELAXED: RunOptions = { family: 'delaunay', nu: [1, 6, 6, 4] };
/** By the second word of a claim; the first names the figure. */
const COMPUTED: Readonly<Record<string, Compute>> = {
  landmarks: ofPicture(({ question }) => question.landmarks.length),
  witnesses: ofPicture(({ question }) => question.witnesses.length),
  edges: ofPicture(({ edges }) => edges.length),
  triangles: ofPicture(({ triangles }) => triangles.length),
  components: ofPicture(({ betti }) => betti[0]),
  loops: ofPicture(({ betti }) => betti[1]),
  'delaunay-edges': ofPicture(({ delaunayEdges }) => delaunayEdges.length),
  'delaunay-triangles': ofPicture(({ delaunayTriangles }) => delaunayTriangles.length),
  step: (_, id) => Promise.resolve(Number(attributesOf(id)('step'))),
  epsilon: async (core, id, [step = '1']) =>
    Number(((await core.sketch(id)).scale?.epsilon[Number(step) - 1] ?? NaN).toPrecision(3)),
  'inner-landmarks': ofPicture(({ question: { landmarks }, delaunayTriangles }) => {
    const n = landmarks.length;
    return n - (2 * n - 2 - delaunayTriangles.length);
  }),
  length: ofPicture(({ question }) => about(walk(question.witnesses))),
  'loops-lost': async (core, id) => {
    const [before, after] = await core.bothWays(id);
    return loopsOnlyIn(before, after);
  },
  'loops-born': async (core, id) => {
    const [before, after] = await core.bothWays(id);
    return loopsOnlyIn(after, before);
  },
  points: (_, id) => Promise.resolve(Number(attributesOf(id)('size'))),
  factor: (_, __, [length = '0']) => Promise.resolve(Number(Math.exp(Number(length)).toPrecision(3))),
  'relaxed-loops': async (core, id) => (await core.bettiAtStep(id, RELAXED))[1] ?? NaN,
  'relaxed-voids': async (core, id) => (await core.bettiAtStep(id, RELAXED))[2] ?? NaN,
  'longest-surface': (core, id) => core.longest(id, 'surface'),
  'longest-complex': (core, id) => core.longest(id, 'delaunay'),
};

let core: Calculator;
beforeAll(() => {
  const wasm = readFileSync(new URL('../../build/wasm/bin/plateau.wasm', import.meta.url));
  core = new Calculator(new PlateauClient({ spawn: () => new InProcessWorker(wasm, setImmediate) }));
});

describe('what the course says', () => {
  test('is found: all that is marked is read', () => {
    expect(claims.length).toBe(everything.split('data-claim').length - 1);
    expect(claims.length).toBeGreaterThan(15);
  });

  test.each(claims)('$about: $value', async ({ about, value, text }) => {
    const [id = '', what = '', ...rest] = about.split(' ');
    const compute = COMPUTED[what];
    if (!compute) throw new Error(`Nothing computes "${what}".`);
    expect(String(await compute(core, id, rest))).toBe(value);
    const number = Number(value);
    const spoken = Number.isInteger(number) ? (WORDS[number] ?? value) : value;
    const grouped = Number.isNaN(number) ? value.replaceAll(',', ', ') : number.toLocaleString('en');
    expect([value, spoken, grouped]).toContain(text);
  });

  test('more generous witnesses let both diagonals in, which the triangulation does not', async () => {
    const { picture } = await core.sketch('circle');
    const across = async (delaunay: boolean): Promise<string[]> => {
      const { edges } = await core.picture({ ...picture.question, nu: [1, 3, 3], delaunay });
      return edges.map(({ vertices }) => vertices.join()).filter((name) => name === '0,2' || name === '1,3');
    };
    expect(await across(true)).toEqual(['0,2']);
    expect(await across(false)).toEqual(['0,2', '1,3']);
  });

  test('of two diagonals almost on a circle one has a cell of order two', async () => {
    const { picture } = await core.sketch('circle');
    const pairs = picture.pairCells.filter(drawn).map(({ of }) => of.join());
    expect(pairs.filter((pair) => pair === '0,2' || pair === '1,3')).toEqual(['0,2']);
  });

  test('p3 towards the middle opens that cell, p3 away from it closes it for the other diagonal', async () => {
    const { picture } = await core.sketch('circle');
    const { landmarks, witnesses } = picture.question;
    const third = landmarks[2];
    const withThird = async (place: Point): Promise<PlanePicture> => {
      // It is a witness as well, which goes with it.
      const moved = (points: readonly Point[]): Point[] =>
        points.map((point) => (point.x === third?.x && point.y === third.y ? place : point));
      return core.picture({ ...picture.question, landmarks: moved(landmarks), witnesses: moved(witnesses) });
    };
    const inwards = await withThird({ x: 76, y: 58 });
    expect([inwards.edges.length, inwards.triangles.length]).toEqual([5, 2]);
    for (const outwards of [await withThird({ x: 86, y: 68 }), await withThird({ x: 92, y: 74 })]) {
      expect([outwards.edges.length, outwards.triangles.length]).toEqual([4, 0]);
      expect(outwards.delaunayEdges.map((edge) => edge.join())).toContain('1,3');
    }
  });

  test('the fake plateau is none: equal numbers, another complex', async () => {
    const [before, after] = await core.bothWays('fake');
    expect(after.betti).toEqual(before.betti);
    expect(names(before).filter((name) => !names(after).includes(name))).toHaveLength(1);
  });

  test('the links in the teachers’ document set what there is', () => {
    const text = readFileSync(new URL('../../docs/course.md', import.meta.url), 'utf8');
    const links = [...text.matchAll(/\/course\/([\w-]+\.html)#([^\s"]+)/g)];
    expect(links.length).toBeGreaterThanOrEqual(5);
    for (const [, file = '', fragment = ''] of links) {
      for (const part of fragment.split('&')) {
        const [, id = '', name = ''] = /^([\w-]+)\.([\w-]+)=/.exec(part) ?? [];
        const tag = new RegExp(`<(plane-sketch|plateau-view)[^>]*\\sid="${id}"`).exec(
          pages.get(file) ?? '',
        )?.[1];
        expect(SETTABLE[tag ?? ''], part).toContain(name);
      }
    }
  });

  test('every task names a figure of its page', () => {
    for (const [name, html] of pages) {
      for (const [, figure = ''] of html.matchAll(/data-figure="([^"]*)"/g))
        expect(html, `${name}: ${figure}`).toMatch(
          new RegExp(`<(plane-sketch|plateau-view)[^>]*\\sid="${figure}"`),
        );
    }
  });
});

describe('the pages', () => {
  const built = new Map(
    COURSE_FILES.map((file) => [file, coursePage(pages.get(`${file}.html`) ?? '', file)]),
  );

  test('are whole: each of the list has its file, two tasks, a figure, and its place in the list', () => {
    for (const { file, title } of COURSE_PAGES) {
      const html = built.get(file) ?? '';
      expect(html).toContain(`${title}</h1>`);
      expect(html.match(/class="task"/g)?.length ?? 0, file).toBeGreaterThanOrEqual(2);
      expect(html).toMatch(/<plane-sketch|<plateau-view/);
      expect(html).toMatch(/aria-current="page"/);
    }
  });

  test('have a name and a text, and no comment is left', () => {
    expect([...built.keys()].sort()).toEqual(files.map((name) => name.replace('.html', '')).sort());
    for (const [file, html] of built) {
      expect(html, file).toMatch(/<h1>[^<]+<\/h1><(p|ol)/);
      expect(html, file).not.toContain('<!--');
    }
  });

  test('leave a frame where they lead out of the course, and stay in it elsewhere', () => {
    const anchors = [...built.values()].flatMap((html) => html.match(/<a\s[^>]*>/g) ?? []);
    expect(anchors.length).toBeGreaterThan(80);
    for (const anchor of anchors)
      expect(anchor.includes('target="_top"'), anchor).toBe(/\shref="(\.\.|https:)/.test(anchor));
  });

  test('an unknown formula, or an unknown page, is a fault of the build', () => {
    expect(() => coursePage('<title>x</title><!-- math: nothing -->', 'x')).toThrow(/no formula "nothing"/);
    expect(() => coursePage('<p>x</p>', 'x')).toThrow(/no page "x"/);
  });

  test('use every formula that there is', () => {
    for (const name of Object.keys(FORMULAS)) expect(everything).toContain(`<!-- math: ${name} -->`);
  });
});
