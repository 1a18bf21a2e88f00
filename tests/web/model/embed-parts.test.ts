import { readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { SAMPLES } from '../../../web/src/app/samples.ts';
import { nameOf, optionsFor } from '../../../web/src/embed/element-cloud.ts';
import { plateauDetail } from '../../../web/src/embed/events.ts';
import { hostTheme } from '../../../web/src/embed/host-theme.ts';
import { settingsOf, type Settings } from '../../../web/src/embed/settings.ts';
import type { PlateauCard } from '../../../web/src/model/plateau-cards.ts';
import { npyOf, sourceOf } from '../../../web/src/package/cloud.ts';

/** What the attributes ask for. */
function settings(attributes: Readonly<Record<string, string>>): Settings {
  const element = {
    getAttribute: (name: string) => attributes[name] ?? null,
    hasAttribute: (name: string) => name in attributes,
  };
  return settingsOf(element as Element);
}

describe('attributes', () => {
  test('nothing asks for nothing', () => {
    expect(settings({})).toEqual({
      source: undefined,
      options: {},
      step: undefined,
      plateau: undefined,
      autoplay: false,
      panels: 'both',
      complaints: [],
    });
  });

  test('steps are how many landmarks at most', () => {
    expect(settings({ shape: 'torus', steps: '40' }).options).toEqual({ maxSteps: 40 });
    expect(settings({ shape: 'torus', steps: '0' })).toMatchObject({
      options: {},
      complaints: ['steps="0" was not understood; it takes a whole number from 1 on.'],
    });
  });

  test('a shape has its usual size, an unknown one a common one; the core says whether there is one', () => {
    expect(settings({ shape: 'sphere' }).source).toEqual({ kind: 'shape', shape: 'sphere', size: 3000 });
    expect(settings({ shape: 'double-torus' }).source).toMatchObject({ size: 15000 });
    expect(settings({ shape: 'teapot' }).source).toMatchObject({ shape: 'teapot', size: 3000 });
    expect(settings({ shape: 'torus', size: '40', noise: '0.1', seed: '0' }).source).toEqual({
      kind: 'shape',
      shape: 'torus',
      size: 40,
      noise: 0.1,
      seed: 0,
    });
  });

  test('an address goes before a shape', () => {
    const { source, options } = settings({
      src: 'a/b.csv?x=1',
      shape: 'torus',
      columns: '2, 3;4',
      nu: '1 4',
    });
    expect(source).toEqual({ kind: 'address', address: 'a/b.csv?x=1', columns: [2, 3, 4] });
    expect(options).toEqual({ nu: [1, 4] });
  });

  test.each([
    ['size', '0', /size="0" was not understood; it takes a whole number from 1 on/],
    ['size', '2.5', /whole number/],
    ['size', '1e999', /whole number/],
    ['noise', '-1', /noise="-1" .* takes a number from 0 on/],
    ['seed', 'x', /seed="x"/],
    ['nu', '1,,2,', /nu="1,,2,"/],
    ['columns', '0', /columns="0" .* whole numbers from 1 on, separated by commas/],
    ['step', '-3', /step="-3"/],
    ['plateau', '0', /plateau="0"/],
    ['panels', 'all', /panels="all" .* takes shape, diagram, both, full/],
    ['theme', 'blue', /theme="blue" .* takes auto, light, dark/],
  ])('%s="%s" is named and leaves the default', (name, value, sentence) => {
    const { complaints, ...asked } = settings({ shape: 'torus', [name]: value });
    expect(complaints).toHaveLength(1);
    expect(complaints[0]).toMatch(sentence);
    const { complaints: none, ...plain } = settings({ shape: 'torus' });
    expect(none).toEqual([]);
    expect(asked).toEqual(plain);
  });
});

test('the palette of the page becomes that of an element, in both of its themes', () => {
  const palette = readFileSync(new URL('../../../web/src/app/theme.css', import.meta.url), 'utf8');
  const css = hostTheme(palette);
  expect(css).not.toContain(':root');
  const blocks = [...css.matchAll(/([^{}]+)\{([^{}]*)\}/g)].map(([, selector = '', body = '']) => ({
    selector: selector.trim(),
    stage: /--stage: (#\w+)/.exec(body)?.[1],
    names: [...body.matchAll(/(--[\w-]+):/g)].map(([, name]) => name),
  }));
  const of = (selector: string) => blocks.find((block) => block.selector === selector);
  const [light, dark] = [of(':host'), of(":host([theme='dark'])")];
  expect(light?.stage).toBe('#f9fafb');
  expect(dark?.stage).toBe('#10161d');
  expect(of(":host(:not([theme='light']))")?.stage).toBe(dark?.stage);
  expect(light?.names).toEqual(expect.arrayContaining(dark?.names ?? []));
  expect(() => hostTheme('body { color: red }')).toThrow(/no light colors/);
});

test('points become an array of NumPy, bit by bit', () => {
  const points = [0.1, -0, 1e-300, Math.PI, 2, 3];
  const bytes = npyOf({ points: Float64Array.from(points), dimension: 2 });
  const view = new DataView(bytes);
  const headLength = view.getUint16(8, true);
  const head = new TextDecoder().decode(new Uint8Array(bytes, 10, headLength));
  expect(new Uint8Array(bytes, 0, 8)).toEqual(Uint8Array.of(0x93, 0x4e, 0x55, 0x4d, 0x50, 0x59, 1, 0));
  expect((10 + headLength) % 64).toBe(0);
  expect(head).toMatch(/^\{'descr': '<f8', 'fortran_order': False, 'shape': \(3, 2\), \} *\n$/);
  expect([...new Float64Array(bytes.slice(10 + headLength))]).toEqual(points);
});

test('bytes are copied, and so are those of a part of a buffer', () => {
  const whole = Uint8Array.of(9, 49, 32, 50, 9);
  const source = sourceOf({ name: 'a.xyz', bytes: whole.subarray(1, 4) });
  if (source.kind !== 'file') throw new Error('no file');
  expect([...new Uint8Array(source.bytes)]).toEqual([49, 32, 50]);
  expect(source.bytes).not.toBe(whole.buffer);
});

test('names of what is opened; a scan ends at its noise, a shape does not', () => {
  expect(nameOf({ kind: 'address', address: 'https://a.org/b/c.ply?x#y' })).toBe('c.ply');
  expect(nameOf({ kind: 'address', address: 'cloud.xyz' })).toBe('cloud.xyz');
  expect(nameOf({ kind: 'points', points: new Float64Array(0), dimension: 3 })).toBe('points');
  expect(optionsFor({ kind: 'address', address: 'a.ply' }, {})).toEqual({ noiseStopFrom: 20_000 });
  expect(optionsFor({ kind: 'shape', shape: 'torus', size: 9 }, { nu: [1] })).toEqual({ nu: [1] });
});

describe('the guide', () => {
  const words: Readonly<Record<string, (value: unknown) => string>> = {
    family: (value) => `family \`${String(value)}\``,
    maxSteps: (value) => `${String(value)} steps`,
    metric: () => 'distances instead of coordinates',
    nu: (value) => `ν ${(value as readonly number[]).join(', ')}`,
    untilEpsilon: (value) => `until ε ${String(value)}`,
  };
  const guide = readFileSync('docs/embed.md', 'utf8');

  test('lists every shape of the gallery with its size and settings', () => {
    const rows = SAMPLES.map(({ shape, size, options = {} }) => {
      const settings = Object.entries(options).map(([name, value]) => words[name]?.(value) ?? name);
      return `| \`${shape}\` | ${size.toLocaleString('en')} | ${settings.join(', ')} |`;
    });
    const table = /\| `shape` \| Points \| Settings \|\n\|[-|]+\|\n((?:\|.*\n)+)/.exec(guide)?.[1] ?? '';
    expect(table.trim().split('\n')).toEqual(rows);
  });

  test('names the other shapes of the core', () => {
    const core = readFileSync('core/cloud/samples.cpp', 'utf8');
    const known = [...core.matchAll(/^ {4}\{\{"([a-z0-9-]+)", \d/gm)].map(([, name = '']) => name);
    expect(known.length).toBeGreaterThan(20);
    const [, others = ''] = /Other names that the core knows, such as (.*?), have/s.exec(guide) ?? [];
    const named = [...others.matchAll(/`([^`]+)`/g)].map(([, name]) => name);
    const listed = SAMPLES.map(({ shape }) => shape);
    expect(named).toEqual(known.filter((name) => !listed.includes(name)));
  });
});

test('a shape has the settings of the gallery unless others are asked for', () => {
  const shape = (name: string) => ({ kind: 'shape', shape: name, size: 100 }) as const;
  expect(optionsFor(shape('mobius'), {})).toEqual({ family: 'dilated', maxSteps: 400 });
  expect(optionsFor(shape('mobius'), { family: 'auto' })).toEqual({ family: 'auto', maxSteps: 400 });
  expect(optionsFor(shape('colors'), {})).toMatchObject({ metric: 'matrix', untilEpsilon: 1 });
  expect(optionsFor(shape('torus'), { nu: [1, 4, 5, 5] })).toEqual({ nu: [1, 4, 5, 5] });
});

test('a plateau with torsion says so', () => {
  const card: PlateauCard = {
    ...{ firstStep: 5, lastStep: 20, middleStep: 10, epsilonFirst: 0.5, length: 2, runs: 1 },
    ...{ family: 'dilated', betti: [1, 2, 1, 0] },
  };
  expect(plateauDetail(card, 1)).toMatchObject({ rank: 1, shape: 'torus-like hollow shape' });
  expect(plateauDetail(card, 1)).not.toHaveProperty('torsion');
  expect(plateauDetail(card, 1)).not.toHaveProperty('runs');
  const torsion = { field: 3, betti: [1, 1, 0, 0] };
  expect(plateauDetail({ ...card, torsion }, 2)).toMatchObject({ torsion, shape: 'Klein-bottle-like shape' });
});
