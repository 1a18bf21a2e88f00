import { readFile } from 'node:fs/promises';
import type { Page } from '@playwright/test';
import { expect, openPaused, state, test } from './page.ts';

async function saved(page: Page, button: string): Promise<{ name: string; text: string }> {
  const download = page.waitForEvent('download');
  await page.getByRole('button', { name: button }).click();
  const file = await download;
  return { name: file.suggestedFilename(), text: await readFile(await file.path(), 'utf8') };
}

test.beforeEach(async ({ page }) => {
  await openPaused(page, 'torus', 200);
});

test('Betti numbers (CSV): a line a step, as the command writes it', async ({ page }) => {
  const { name, text } = await saved(page, 'Betti numbers (CSV)');
  expect(name).toBe('torus-betti.csv');
  const [head, ...lines] = text.trimEnd().split('\n');
  expect(head).toBe('step,landmark,epsilon,family,beta0,beta1,beta2');
  expect(lines).toHaveLength(200);
  await page.getByRole('slider', { name: 'Step' }).fill('60');
  const fields = (lines[59] ?? '').split(',');
  expect(fields[0]).toBe('60');
  expect(fields[3]).toBe(await state(page, 'family'));
  expect(fields.slice(4).join()).toBe(await state(page, 'betti'));
});

test('Mesh (PLY): the surface of the step that is shown, closed', async ({ page }) => {
  await page.locator('.cards button[data-betti="1,2,1"]').first().click();
  const { name, text } = await saved(page, 'Mesh (PLY)');
  expect(name).toBe(`torus-step-${await state(page, 'step')}.ply`);
  const [header = '', body = ''] = text.split('end_header\n');
  expect(header.startsWith('ply\nformat ascii 1.0\n')).toBe(true);
  const vertices = Number(/element vertex (\d+)/.exec(header)?.[1]);
  const faces = Number(/element face (\d+)/.exec(header)?.[1]);
  const rows = body.trimEnd().split('\n');
  expect(rows).toHaveLength(vertices + faces);
  const turns = new Map<string, number>();
  for (const row of rows.slice(vertices)) {
    const [size, a = 0, b = 0, c = 0] = row.split(' ').map(Number);
    expect(size).toBe(3);
    for (const edge of [`${a}-${b}`, `${b}-${c}`, `${c}-${a}`]) turns.set(edge, (turns.get(edge) ?? 0) + 1);
  }
  // Closed and oriented: each edge once in either direction.
  for (const [edge, count] of turns) {
    expect(count).toBe(1);
    expect(turns.has(edge.split('-').reverse().join('-'))).toBe(true);
  }
  expect(vertices - turns.size / 2 + faces).toBe(0);
});

test('Diagram (SVG): a well-formed picture of its own', async ({ page }) => {
  const { name, text } = await saved(page, 'Diagram (SVG)');
  expect(name).toBe('torus-diagram.svg');
  const read = await page.evaluate((svg) => {
    const document = new DOMParser().parseFromString(svg, 'image/svg+xml');
    return {
      fault: document.querySelector('parsererror')?.textContent ?? '',
      root: document.documentElement.namespaceURI,
      words: [...document.querySelectorAll('text')].map(({ textContent }) => textContent),
      lines: document.querySelectorAll('path[stroke-width="2"]').length,
    };
  }, text);
  expect(read.fault).toBe('');
  expect(read.root).toBe('http://www.w3.org/2000/svg');
  expect(read.lines).toBe(3);
  expect(read.words).toEqual(
    expect.arrayContaining(['1/ε', 'β₀ components', 'β₁ loops', 'β₂ voids', '1, 1, 0']),
  );
});

test('more formats: each is what its name says, of the step that is shown', async ({ page }) => {
  await page.locator('.cards button[data-betti="1,2,1"]').first().click();
  const step = await state(page, 'step');
  await page.getByText('More formats').click();
  const save = async (button: string): Promise<{ name: string; bytes: Buffer }> => {
    const download = page.waitForEvent('download');
    await page.getByRole('button', { name: button }).click();
    const file = await download;
    return { name: file.suggestedFilename(), bytes: await readFile(await file.path()) };
  };
  const begins = { 'Mesh (OFF)': 'OFF', 'Mesh (GLB)': 'glTF', 'Complex (VTK)': '# vtk DataFile' };
  for (const [button, beginning] of Object.entries(begins)) {
    const { name, bytes } = await save(button);
    const ending = button.slice(-4, -1).toLowerCase();
    expect(name).toBe(`torus-step-${step}.${ending}`);
    expect(bytes.subarray(0, beginning.length).toString('latin1')).toBe(beginning);
  }
  const report = await save('Surface in numbers (JSON)');
  expect(report.name).toBe(`torus-step-${step}-surface.json`);
  expect(JSON.parse(report.bytes.toString())).toMatchObject({ step: Number(step) });
  const plateaus = await save('Plateaus (JSON)');
  expect(plateaus.name).toBe('torus-plateaus.json');
  expect(JSON.parse(plateaus.bytes.toString())).toHaveProperty('plateaus');
  const picture = await save('Diagram (PNG)');
  expect(picture.name).toBe('torus-diagram.png');
  expect(picture.bytes.subarray(1, 4).toString('latin1')).toBe('PNG');
  // Width and height, from the header: twice the drawing.
  expect(picture.bytes.readUInt32BE(16)).toBe(1800);
});
