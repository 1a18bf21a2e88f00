import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { drop, expect, openPaused, shown, state, test, torusText } from './page.ts';

const command = fileURLToPath(new URL('../../build/native/bin/plateau', import.meta.url));

test('a session that the command saved is dropped and runs with its own options', async ({ page }) => {
  const folder = mkdtempSync(join(tmpdir(), 'plateau-'));
  const [points, session] = [join(folder, 'points.xyz'), join(folder, 'torus.plateau')];
  writeFileSync(points, torusText(200));
  execFileSync(command, ['run', points, '--family', 'delaunay', '--steps', '70', '--session', session]);
  await openPaused(page, 'torus', 120);
  await drop(page, 'torus.plateau', readFileSync(session));
  await shown(page, 'torus.plateau');
  expect(await state(page, 'steps')).toBe('70');
});
