import { readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { codeOf, PlateauError } from '../../web/src/client/plateau-error.ts';

const header = readFileSync(new URL('../../core/base/result.h', import.meta.url), 'utf8');

test('every failure of the core has a name of its own', () => {
  const body = /enum class ErrorCode[^{]*\{([^}]*)\}/.exec(header)?.[1] ?? '';
  const codes = [...body.matchAll(/^\s*(\w+) = (\d+),/gm)].map(([, name = '', code]) => ({
    name: name.replace(/(?!^)([A-Z])/g, '-$1').toLowerCase(),
    code: Number(code),
  }));
  expect(codes.length).toBeGreaterThan(10);
  for (const { name, code } of codes) {
    // Whoever reads the name does not care whether a file was meant.
    expect(codeOf({ code, message: '' })).toBe(name.replace(/-file$/, ''));
  }
});

test('a number that is not known is a fault of the program', () => {
  expect(codeOf({ code: 0, message: '' })).toBe('internal');
  expect(codeOf({ code: 999, message: '' })).toBe('internal');
  const error = PlateauError.of({ code: 3, message: 'Line 2 …' });
  expect(error).toMatchObject({ name: 'PlateauError', code: 'not-a-number', message: 'Line 2 …' });
});
