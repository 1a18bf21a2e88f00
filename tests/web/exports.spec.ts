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

/** What a reader of the picture sees who knows nothing of the program: labelled axes, and three stepped lines. */
interface Drawing {
  /** What is written beside the axis, and where its line is. */
  readonly acrossTicks: readonly (readonly [value: number, x: number])[];
  readonly uprightTicks: readonly (readonly [value: number, y: number])[];
  /** The corners of each line. */
  readonly lines: readonly (readonly (readonly [x: number, y: number])[])[];
}

function readDrawing(page: Page, svg: string): Promise<Drawing> {
  return page.evaluate((text) => {
    const document = new DOMParser().parseFromString(text, 'image/svg+xml');
    const pathsLike = (pattern: RegExp): RegExpExecArray[] =>
      [...document.querySelectorAll('path')]
        .map((path) => pattern.exec(path.getAttribute('d') ?? ''))
        .filter((found) => found !== null);
    const labels = (anchor: string, axis: 'x' | 'y', places: readonly number[], near: number) =>
      [...document.querySelectorAll(`text[text-anchor="${anchor}"]`)].flatMap((label) => {
        const at = Number(label.getAttribute(axis));
        const value = Number(label.textContent.replaceAll(',', ''));
        const place = places.find((candidate) => Math.abs(candidate - at) <= near);
        return Number.isNaN(value) || place === undefined ? [] : [[value, place] as const];
      });
    const columns = pathsLike(/^M([\d.]+) [\d.]+v5$/).map(([, x]) => Number(x));
    const rows = pathsLike(/^M[\d.]+ ([\d.]+)H[\d.]+$/).map(([, y]) => Number(y));
    return {
      acrossTicks: labels('middle', 'x', columns, 0.01),
      uprightTicks: labels('end', 'y', rows, 4.01),
      lines: [...document.querySelectorAll('path[stroke-width="2"]')].map((path) =>
        [...(path.getAttribute('d') ?? '').matchAll(/[ML]([\d.]+) ([\d.]+)/g)].map(
          ([, x, y]) => [Number(x), Number(y)] as const,
        ),
      ),
    };
  }, svg);
}

test('Diagram (SVG): its lines are at the Betti numbers of the table, step by step', async ({ page }) => {
  const table = (await saved(page, 'Betti numbers (CSV)')).text
    .trimEnd()
    .split('\n')
    .slice(1)
    .map((line) => line.split(',').map(Number));
  const { acrossTicks, uprightTicks, lines } = await readDrawing(
    page,
    (await saved(page, 'Diagram (SVG)')).text,
  );
  // The axis of 1/ε is logarithmic: two of its labels say where every scale is.
  const [low, high] = [acrossTicks[0], acrossTicks.at(-1)];
  if (!low || !high || low === high) throw new Error('The axis has too few labels.');
  const unit = (high[1] - low[1]) / Math.log(high[0] / low[0]);
  const place = (epsilon: number): number => low[1] + unit * Math.log(1 / epsilon / low[0]);
  for (const [value, x] of acrossTicks) expect(Math.abs(place(1 / value) - x)).toBeLessThan(0.1);

  /** Equal numbers are drawn side by side. */
  const near = 7;
  let compared = 0;
  table.slice(0, -1).forEach(([step = 0, , epsilon = 0, , ...betti], i) => {
    const [from, to] = [place(epsilon), place(table[i + 1]?.[2] ?? 0)];
    // Narrower ones are drawn together, as one upright stroke.
    if (!(to - from > 2) || to === Infinity) return;
    betti.forEach((count, k) => {
      const corners = lines[k] ?? [];
      const after = corners.findIndex(([x]) => x > (from + to) / 2);
      const y = corners[after - 1]?.[1] ?? NaN;
      expect(y, `step ${step}: β${k} is level there`).toBe(corners[after]?.[1]);
      const below = uprightTicks.filter(([value]) => value <= count).at(-1);
      const above = uprightTicks.find(([value]) => value >= count);
      expect(y, `step ${step}: β${k} is ${count}`).toBeLessThanOrEqual((below?.[1] ?? NaN) + near);
      expect(y, `step ${step}: β${k} is ${count}`).toBeGreaterThanOrEqual((above?.[1] ?? 0) - near);
      compared += 1;
    });
  });
  expect(compared).toBeGreaterThan(90);
});

test('Diagram (PNG): a picture of twice the size, in the colors of the drawing', async ({ page }) => {
  await page.getByText('More formats').click();
  const download = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Diagram (PNG)' }).click();
  const bytes = [...(await readFile(await (await download).path()))];
  const seen = await page.evaluate(async (picture) => {
    const image = await createImageBitmap(new Blob([Uint8Array.from(picture)], { type: 'image/png' }));
    const canvas = new OffscreenCanvas(image.width, image.height);
    const context = canvas.getContext('2d');
    context?.drawImage(image, 0, 0);
    const { data } = context?.getImageData(0, 0, image.width, image.height) ?? { data: [] };
    const counts = new Map<string, number>();
    for (let i = 0; i + 3 < data.length; i += 4) {
      const color = [data[i], data[i + 1], data[i + 2]].map((part = 0) => part.toString(16).padStart(2, '0'));
      const name = `#${color.join('')}${data[i + 3] === 255 ? '' : ' transparent'}`;
      counts.set(name, (counts.get(name) ?? 0) + 1);
    }
    return { width: image.width, height: image.height, counts: Object.fromEntries(counts) };
  }, bytes);
  expect([seen.width, seen.height]).toEqual([1800, 748]);
  // Components, loops, voids: each a line two units thick, and its sample in the legend.
  for (const color of ['#0072b2', '#d55e00', '#009e73']) expect(seen.counts[color]).toBeGreaterThan(500);
  expect(seen.counts['#ffffff']).toBeGreaterThan((1800 * 748) / 2);
  // The band of the torus: blue, at 0.28 on white.
  const bands = Object.entries(seen.counts).filter(([name]) => /^#d[0-2]e[a-c]f/.test(name));
  expect(Math.max(0, ...bands.map(([, count]) => count))).toBeGreaterThan(10_000);
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
  expect((await save('Diagram (PNG)')).name).toBe('torus-diagram.png');
});
