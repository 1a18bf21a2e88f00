import type { PumpHistogram } from '../model/pump-histogram.ts';

const SVG = 'http://www.w3.org/2000/svg';
const WIDTH = 272;
const HEIGHT = 124;
const [LEFT, TOP, FLOOR] = [28, 8, 104];
/** Between the pairs of bars. */
const GAP = 4;

function element(name: string, attributes: Readonly<Record<string, string | number>>, text = ''): SVGElement {
  const node = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, String(value));
  node.textContent = text;
  return node;
}

/** Pairs of bars, before and after, over an axis with numbers; colors are those of the style sheet. */
export function drawPumps(svg: SVGSVGElement, { bins }: PumpHistogram): void {
  svg.setAttribute('viewBox', `0 0 ${WIDTH} ${HEIGHT}`);
  const most = Math.max(1, ...bins.flatMap(({ before, after }) => [before, after]));
  const pair = (WIDTH - LEFT) / bins.length;
  const bar = (x: number, count: number, kind: string): SVGElement => {
    const height = ((FLOOR - TOP) * count) / most;
    return element('rect', { class: kind, x, y: FLOOR - height, width: (pair - GAP) / 2, height });
  };
  const label = (x: number, y: number, anchor: string, text: string): SVGElement =>
    element('text', { x, y, 'text-anchor': anchor }, text);
  const nodes = [
    element('path', { class: 'axis', d: `M${LEFT} ${TOP}H${WIDTH}M${LEFT} ${FLOOR}H${WIDTH}` }),
    label(LEFT - 6, TOP + 4, 'end', String(most)),
    label(LEFT - 6, FLOOR + 4, 'end', '0'),
  ];
  bins.forEach(({ from, before, after }, i) => {
    const x = LEFT + i * pair + GAP / 2;
    nodes.push(bar(x, before, 'pump-before'), bar(x + (pair - GAP) / 2, after, 'pump-after'));
    const last = i === bins.length - 1;
    if (i % 4 === 0)
      nodes.push(label(LEFT + i * pair, FLOOR + 16, i === 0 ? 'start' : 'middle', String(from)));
    if (last) nodes.push(label(WIDTH, FLOOR + 16, 'end', `${from} +`));
  });
  svg.replaceChildren(...nodes);
}
