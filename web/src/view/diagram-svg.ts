import type { PlateauCard } from '../model/plateau-cards.ts';
import type { RunRecord } from '../model/record.ts';
import type { AxisKind } from '../model/scale-axis.ts';
import { layOut } from './diagram-layout.ts';

const SIZE = { width: 900, height: 340, resolution: 4 };
const LEGEND_HEIGHT = 34;
const BETTI_COLORS = ['#0072B2', '#D55E00', '#009E73', '#A0408C', '#7A6A00', '#5B5FC7', '#6B7280'];
const BETTI_NAMES = ['β₀ components', 'β₁ loops', 'β₂ voids', 'β₃', 'β₄', 'β₅', 'β₆'];
const LEGEND_STEPS = [140, 110, 105, 65, 65, 65, 65];
const BAND_COLORS = {
  surface: '#56B4E9',
  delaunay: '#F0C75E',
  witness: '#CC79A7',
  dilated: '#CC79A7',
} as const;
const INK = '#1d2530';
const GRAY = '#6b7480';

function escaped(text: string): string {
  return text.replace(/[&<>"]/g, (sign) => ({ '&': '&amp;', '<': '&lt;', '>': '&gt;' })[sign] ?? '&quot;');
}

function number(value: number): string {
  return String(Math.round(value * 100) / 100);
}

function text(x: number, y: number, anchor: string, content: string, more = ''): string {
  const place = `x="${number(x)}" y="${number(y)}" text-anchor="${anchor}"`;
  return `<text ${place} ${more}>${escaped(content)}</text>`;
}

/** The diagram as a file of its own, on white, with axes, legend and bands; vector graphics for papers and slides. */
export function diagramSvg(
  record: RunRecord,
  cards: readonly PlateauCard[],
  title: string,
  kind: AxisKind = 'log',
): string {
  const layout = layOut(record, cards, { ...SIZE, kind });
  const { left, right, top, bottom, width } = layout;
  const height = layout.height + LEGEND_HEIGHT;
  const parts: string[] = [];
  for (const band of layout.bands) {
    const place = `x="${number(band.from)}" y="${top}" width="${number(Math.max(1, band.to - band.from - 1))}" height="${bottom - top}"`;
    parts.push(`<rect ${place} fill="${BAND_COLORS[band.family]}" fill-opacity="0.28"/>`);
    if (band.to - band.from > 7 * band.label.length + 10) {
      parts.push(text(band.from + 6, top + 14, 'start', band.label, `fill="${INK}" font-weight="600"`));
    }
  }
  if (layout.computedTo < right - 0.5) {
    const place = `x="${number(layout.computedTo)}" y="${top}" width="${number(right - layout.computedTo)}" height="${bottom - top}"`;
    parts.push(`<rect ${place} fill="url(#open)"/>`);
  }
  for (const { at, label } of layout.lines) {
    parts.push(`<path d="M${left} ${number(at)}H${right}" stroke="${GRAY}" stroke-opacity="0.25"/>`);
    parts.push(text(left - 7, at + 4, 'end', label, `fill="${GRAY}"`));
  }
  for (const { at, label } of layout.columns) {
    parts.push(`<path d="M${number(at)} ${bottom}v5" stroke="${GRAY}"/>`);
    parts.push(text(at, bottom + 18, 'middle', label, `fill="${GRAY}"`));
  }
  parts.push(`<path d="M${left} ${top}V${bottom}H${right}" fill="none" stroke="${GRAY}"/>`);
  parts.push(text((left + right) / 2, bottom + 33, 'middle', '1/ε', `fill="${INK}"`));
  layout.series.forEach((corners, k) => {
    const path = corners
      .map((value, i) => (i % 2 === 0 ? (i === 0 ? 'M' : 'L') : ' ') + number(value))
      .join('');
    const stroke = `stroke="${BETTI_COLORS[k] ?? INK}" stroke-width="2" stroke-linejoin="round"`;
    if (path) parts.push(`<path d="${path}" fill="none" ${stroke}/>`);
  });
  layout.series.forEach((_, k) => {
    const x = left + LEGEND_STEPS.slice(0, k).reduce((sum, step) => sum + step, 0);
    const y = layout.height + 12;
    parts.push(`<path d="M${x} ${y}h22" stroke="${BETTI_COLORS[k] ?? INK}" stroke-width="3"/>`);
    parts.push(text(x + 29, y + 4, 'start', BETTI_NAMES[k] ?? `β${k}`, `fill="${INK}"`));
  });
  const families = [...new Set(layout.bands.map((band) => band.family))];
  families.forEach((family, i) => {
    const x = right - 150 * (families.length - i);
    const y = layout.height + 5;
    parts.push(
      `<rect x="${x}" y="${y}" width="22" height="13" fill="${BAND_COLORS[family]}" fill-opacity="0.45"/>`,
    );
    parts.push(text(x + 29, y + 11, 'start', `plateau: ${family}`, `fill="${INK}"`));
  });
  return [
    '<?xml version="1.0" encoding="UTF-8"?>',
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}" width="${width}" height="${height}" font-family="system-ui, Helvetica, Arial, sans-serif" font-size="12">`,
    `<title>${escaped(title)}</title>`,
    '<defs><pattern id="open" width="7" height="7" patternUnits="userSpaceOnUse" patternTransform="rotate(45)">' +
      `<path d="M0 0V7" stroke="${GRAY}" stroke-opacity="0.45"/></pattern></defs>`,
    '<rect width="100%" height="100%" fill="#ffffff"/>',
    ...parts,
    '</svg>',
    '',
  ].join('\n');
}
