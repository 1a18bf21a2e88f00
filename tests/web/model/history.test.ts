import { expect, test } from 'vitest';
import { History } from '../../../web/src/model/history.ts';

test('goes back and forth, and forgets what was undone when something new is added', () => {
  const history = new History<string>();
  expect(history.peek(-1)).toBeUndefined();
  for (const entry of ['a', 'b', 'c']) history.add(entry);
  expect(history.peek(1)).toBeUndefined();
  history.go(-1);
  history.go(-1);
  history.go(-1);
  expect([history.peek(-1), history.peek(1)]).toEqual([undefined, 'b']);
  history.go(1);
  history.add('d');
  expect([history.peek(-1), history.peek(1)]).toEqual(['b', undefined]);
});

test('keeps the last fifty', () => {
  const history = new History<number>();
  for (let i = 1; i <= 60; ++i) history.add(i);
  for (let i = 0; i < 60; ++i) history.go(-1);
  expect([history.peek(-1), history.peek(1)]).toEqual([undefined, 12]);
});
