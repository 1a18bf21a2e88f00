// The growth chart: time, time over T_D and peak memory against the number of points, as an SVG that reads on light
// and dark ground alike.
import { BASE } from './plan.mjs';
import { rowOf } from './results.mjs';

// Okabe-Ito; T_D takes the color of the text.
const series = [
  { what: BASE, label: 'T_D: CGAL alone', mark: 'none', dash: '5 4' },
  { what: 'delaunay', label: 'delaunay', mark: 'circle' },
  { what: 'surface', label: 'surface', mark: 'square' },
  { what: 'witness', label: 'witness', mark: 'diamond' },
];
const seconds = [
  [1e-3, '1 ms'],
  [1e-2, '10 ms'],
  [0.1, '0.1 s'],
  [1, '1 s'],
  [10, '10 s'],
  [100, '100 s'],
  [1000, '1,000 s'],
  [1e4, '10,000 s'],
];
const bytes = [
  [1, '1 MB'],
  [10, '10 MB'],
  [100, '100 MB'],
  [1e3, '1 GB'],
  [1e4, '10 GB'],
  [1e5, '100 GB'],
];
const ratios = [0.5, 1, 2, 3, 5, 10, 20, 30, 50, 100, 200, 500, 1000, 2000, 5000].map((each) => [
  each,
  String(each),
]);
const points = [
  [1e3, '10³'],
  [1e4, '10⁴'],
  [1e5, '10⁵'],
  [1e6, '10⁶'],
];

const WIDTH = 960;
const HEIGHT = 416;
const panel = { width: 232, height: 250, top: 78, gap: 82, left: 66 };

const style = `
  svg { color: #1f2328; background: #ffffff; --grid: #d9dde2; --soft: #59636e;
        --delaunay: #0072b2; --surface: #c75b00; --witness: #00835f; --ground: #ffffff; }
  @media (prefers-color-scheme: dark) {
    svg { color: #e6edf3; background: #0d1117; --grid: #30363d; --soft: #9198a1;
          --delaunay: #56b4e9; --surface: #e69f00; --witness: #2fc79a; --ground: #0d1117; }
  }
  text { font: 12px system-ui, sans-serif; fill: currentColor; font-variant-numeric: tabular-nums; }
  .title { font-size: 13px; font-weight: 600; }
  .soft { fill: var(--soft); }
  .grid { stroke: var(--grid); stroke-width: 1; }
  .line { fill: none; stroke-width: 2; stroke-linejoin: round; }
  .mark { stroke: var(--ground); stroke-width: 1; }`;

const round = (value) => Math.round(value * 100) / 100;
const escaped = (text) => text.replaceAll('&', '&amp;').replaceAll('<', '&lt;');
const text = (x, y, words, more = '') =>
  `<text x="${round(x)}" y="${round(y)}"${more}>${escaped(words)}</text>`;
const colorOf = (what) => (what === BASE ? 'currentColor' : `var(--${what})`);

function marker(kind, x, y, color) {
  const at = `class="mark" fill="${color}"`;
  if (kind === 'circle') return `<circle cx="${x}" cy="${y}" r="4.5" ${at}/>`;
  if (kind === 'square') return `<rect x="${round(x - 4)}" y="${round(y - 4)}" width="8" height="8" ${at}/>`;
  if (kind === 'diamond') return `<path d="M${x} ${round(y - 5.5)}l5.5 5.5l-5.5 5.5l-5.5 -5.5z" ${at}/>`;
  return '';
}

/** The part of the ticks that holds all values, with one tick around them. */
function covering(ticks, values) {
  const [least, most] = [Math.min(...values), Math.max(...values)];
  const from = Math.max(
    0,
    ticks.findLastIndex(([tick]) => tick <= least),
  );
  const to = ticks.findIndex(([tick]) => tick >= most);
  return ticks.slice(from, (to < 0 ? ticks.length - 1 : to) + 1);
}

function scale(ticks, from, to) {
  const [low, high] = [Math.log(ticks[0][0]), Math.log(ticks.at(-1)[0])];
  return (value) => round(from + ((Math.log(value) - low) / (high - low || 1)) * (to - from));
}

function drawPanel(index, { title, ticks, value }, rows) {
  const left = panel.left + index * (panel.width + panel.gap);
  const bottom = panel.top + panel.height;
  const curves = series.map((each) => ({
    ...each,
    places: points
      .map(([n]) => [n, value(rowOf(rows, 'native', 'torus', n, each.what), n)])
      .filter(([, y]) => Number.isFinite(y) && y > 0),
  }));
  const places = curves.flatMap((curve) => curve.places);
  const across = covering(points, places.map(([n]) => n)); // prettier-ignore
  const up = covering(ticks, places.map(([, y]) => y)); // prettier-ignore
  const x = scale(across, left, left + panel.width);
  const y = scale(up, bottom, panel.top);
  const parts = [text(left - 46, panel.top - 16, title, ' class="title"')];
  for (const [tick, label] of up) {
    parts.push(`<path class="grid" d="M${left} ${y(tick)}h${panel.width}"/>`);
    parts.push(text(left - 8, y(tick) + 4, label, ' class="soft" text-anchor="end"'));
  }
  for (const [tick, label] of across) {
    parts.push(`<path class="grid" d="M${x(tick)} ${panel.top}v${panel.height}"/>`);
    parts.push(text(x(tick), bottom + 18, label, ' class="soft" text-anchor="middle"'));
  }
  parts.push(text(left + panel.width / 2, bottom + 38, 'points', ' class="soft" text-anchor="middle"'));
  for (const { what, mark, dash, places: own } of curves) {
    if (own.length === 0) continue;
    const path = own.map(([n, v], i) => `${i === 0 ? 'M' : 'L'}${x(n)} ${y(v)}`).join('');
    const dashes = dash ? ` stroke-dasharray="${dash}"` : '';
    parts.push(`<path class="line" d="${path}" stroke="${colorOf(what)}"${dashes}/>`);
    for (const [n, v] of own) parts.push(marker(mark, x(n), y(v), colorOf(what)));
  }
  return parts.join('\n');
}

function legend() {
  let x = panel.left - 46;
  return series
    .map(({ what, label, mark, dash }) => {
      const dashes = dash ? ` stroke-dasharray="${dash}"` : '';
      const parts = [
        `<path class="line" d="M${x} 30h34" stroke="${colorOf(what)}"${dashes}/>`,
        marker(mark, x + 17, 30, colorOf(what)),
        text(x + 42, 34, label),
      ];
      x += 64 + 7.2 * label.length;
      return parts.join('\n');
    })
    .join('\n');
}

function caption(lines) {
  const small = ' class="soft" style="font-size: 11px"';
  return lines.map((line, i) => text(panel.left - 46, HEIGHT - 24 + 15 * i, line, small)).join('\n');
}

export function growthChart({ machine, rows }) {
  const base = (n) => rowOf(rows, 'native', 'torus', n, BASE)?.seconds;
  const panels = [
    { title: 'Time of a whole run', ticks: seconds, value: (row) => row?.seconds },
    { title: 'Time over T_D', ticks: ratios, value: (row, n) => row && row.seconds / base(n) },
    { title: 'Peak memory', ticks: bytes, value: (row) => row?.megabytes },
  ];
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${WIDTH} ${HEIGHT}" width="${WIDTH}" height="${HEIGHT}" role="img" aria-labelledby="title what">
<title id="title">Growth of whole runs with the number of points of a torus</title>
<desc id="what">Three charts with logarithmic axes: time, time over T_D, and peak memory of whole runs of the families delaunay, surface and witness, and of CGAL alone, from a thousand to a million points.</desc>
<style>${style}
</style>
${legend()}
${panels.map((each, index) => drawPanel(index, each, rows)).join('\n')}
${caption(['Torus, all points inserted, Betti numbers at every step. Logarithmic axes.', machine])}
</svg>
`;
}
