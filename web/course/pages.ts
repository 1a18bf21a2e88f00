// What all pages of the course have in common, put in while they are built: so they are whole without any script.

/** In the order in which they are read. */
export const COURSE_PAGES = [
  {
    file: 'voronoi',
    title: 'Voronoi and Delaunay',
    idea: 'Who is nearest, and who are neighbors?',
    description: 'Voronoi cells, the Delaunay triangulation and the empty disc.',
  },
  {
    file: 'witnesses',
    title: 'Witnesses and landmarks',
    idea: 'Let the data say which landmarks belong together.',
    description: 'The witness complex, from its definition.',
  },
  {
    file: 'order-two',
    title: 'Why a finite sample witnesses little',
    idea: 'Some cells are too thin to be hit.',
    description: 'Voronoi cells of order two, slivers, and the relaxed witness complex.',
  },
  {
    file: 'farthest',
    title: 'Farthest first',
    idea: 'From coarse to fine, one landmark at a time.',
    description: 'How landmarks are chosen, and what the scale means.',
  },
  {
    file: 'curves',
    title: 'Curves in the plane',
    idea: 'Where the witness complex is right, and where it is not.',
    description: 'Where the witness complex of a curve is right, and where it is not.',
  },
  {
    file: 'surfaces',
    title: 'Surfaces',
    idea: 'Slivers, holes, and how they are mended.',
    description: 'Slivers and holes in space, the relaxed complex, and the surface inside it.',
  },
  {
    file: 'plateaus',
    title: 'Betti numbers and plateaus',
    idea: 'Several scales, several answers; and some fakes.',
    description: 'Betti numbers over the scale, several answers for one cloud, and fake plateaus.',
  },
  {
    file: 'dimensions',
    title: 'More dimensions',
    idea: 'Why witnesses become balls and landmarks get weights.',
    description: 'Why witnesses are dilated and landmarks get weights from three dimensions on.',
  },
] as const;

/** Beside the way through: what it begins with, and where it leads. */
const OTHER_PAGES = [
  {
    file: 'index',
    title: 'A course on witness complexes',
    description:
      'Eight pages on how a cloud of points becomes a shape, with the real computation in every figure.',
  },
  {
    file: 'sketch',
    title: 'A board of your own',
    description: 'A sketch of landmarks and witnesses in the plane, for trying out.',
  },
] as const;

export const COURSE_FILES = [...OTHER_PAGES, ...COURSE_PAGES].map(({ file }) => file);

const row = (...parts: readonly string[]): string => `<mrow>${parts.join('')}</mrow>`;
const math = (inner: string): string => `<math>${inner}</math>`;
const of = (what: string, argument = '<mi>L</mi>'): string =>
  `${what}<mo stretchy="false">(</mo>${argument}<mo stretchy="false">)</mo>`;
const list = (...entries: readonly (number | string)[]): string =>
  `<mo stretchy="false">(</mo>${entries.map((entry) => `<mn>${entry}</mn>`).join('<mo>,</mo>')}<mo stretchy="false">)</mo>`;
const witnessComplex = '<msup><mi>C</mi><mi>W</mi></msup>';
const relaxed = '<msubsup><mi>C</mi><mi>ν</mi><mi>W</mi></msubsup>';
const beta = (k: number): string => `<msub><mi>β</mi><mn>${k}</mn></msub>`;
const distance = (a: string, b: string): string =>
  `<mi>d</mi><mo stretchy="false">(</mo>${a}<mo>,</mo>${b}<mo stretchy="false">)</mo>`;
const corner = '<msub><mi>p</mi><mi>i</mi></msub>';

/** Formulas by name, as `<!-- math: name -->`. */
export const FORMULAS: Readonly<Record<string, string>> = {
  L: '<mi>L</mi>',
  w: '<mi>w</mi>',
  D: of('<mi>D</mi>'),
  DS: of('<msup><mi>D</mi><mi>S</mi></msup>'),
  S: '<mi>S</mi>',
  CW: of(witnessComplex),
  CW_in_D: row(of(witnessComplex), '<mo>⊆</mo>', of('<mi>D</mi>')),
  CNU: of(relaxed),
  surface: '<mover><mi>S</mi><mo>^</mo></mover>',
  nu1: '<msub><mi>ν</mi><mn>1</mn></msub>',
  nuk: '<msub><mi>ν</mi><mi>k</mi></msub>',
  nu123: row('<mi>ν</mi><mo>=</mo>', list(1, 2, 3)),
  nu133: row('<mi>ν</mi><mo>=</mo>', list(1, 3, 3)),
  nu1234: row('<mi>ν</mi><mo>=</mo>', list(1, 2, 3, 4)),
  nu1664: row('<mi>ν</mi><mo>=</mo>', list(1, 6, 6, 4)),
  epsilon: '<mi>ε</mi>',
  overEpsilon: row('<mn>1</mn><mo>/</mo>', of('<mi>ε</mi>', '<mi>i</mi>')),
  delta: '<mi>δ</mi>',
  epsiloni: of('<mi>ε</mi>', '<mi>i</mi>'),
  Li: of('<mi>L</mi>', '<mi>i</mi>'),
  beta0: beta(0),
  beta1: beta(1),
  beta2: beta(2),
  k: '<mi>k</mi>',
  zeta: '<mi>ζ</mi>',
  Wzeta: '<msup><mi>W</mi><mi>ζ</mi></msup>',
  omega: of('<mi>ω</mi>', '<mi>p</mi>'),
  R3: '<msup><mi>ℝ</mi><mn>3</mn></msup>',
  R4: '<msup><mi>ℝ</mi><mn>4</mn></msup>',
  euler: row('<mi>χ</mi><mo>=</mo>', beta(0), '<mo>−</mo>', beta(1), '<mo>+</mo>', beta(2)),
  triangles: row('<mn>2</mn><mi>n</mi><mo>−</mo><mn>2</mn><mo>−</mo><mi>h</mi>'),
  edges: row('<mn>3</mn><mi>n</mi><mo>−</mo><mn>3</mn><mo>−</mo><mi>h</mi>'),
  witnessed: row(distance('<mi>w</mi>', corner), '<mo>≤</mo>', distance('<mi>w</mi>', '<mi>q</mi>')),
  length: row(
    '<mi>ln</mi><mo stretchy="false">(</mo>',
    of('<mi>ε</mi>', '<mtext>first</mtext>'),
    '<mo>/</mo>',
    of('<mi>ε</mi>', '<mtext>after the last</mtext>'),
    '<mo stretchy="false">)</mo>',
  ),
  power: row(
    '<msup>',
    row('<mo>|</mo><mi>c</mi><mo>−</mo><mi>p</mi><mo>|</mo>'),
    '<mn>2</mn></msup><mo>−</mo><mi>ω</mi>',
    '<msup>',
    row('<mo stretchy="false">(</mo><mi>p</mi><mo stretchy="false">)</mo>'),
    '<mn>2</mn></msup>',
  ),
};

function formula(name: string): string {
  const found = FORMULAS[name];
  if (found === undefined) throw new Error(`There is no formula "${name}".`);
  return math(found);
}

/** What leads out of the course leads out of the frame that a page may stand in: elsewhere none is allowed. */
const outward = (html: string): string =>
  html.replace(/<a(?=[^>]*\shref="(?:\.\.|https:))/g, '<a target="_top"');

const link = (href: string, text: string, more = ''): string => `<a href="${href}"${more}>${text}</a>`;

/** The list of all pages, where one is the current one or none. */
function pageList(current: number): string {
  const entries = COURSE_PAGES.map(
    ({ file, title }, i) =>
      `<li>${link(`./${file}.html`, title, i === current ? ' aria-current="page"' : '')}</li>`,
  );
  return `<nav class="pages" aria-label="Pages of the course"><ol>${entries.join('')}</ol></nav>`;
}

function contents(): string {
  const entries = COURSE_PAGES.map(
    ({ file, title, idea }) => `<li>${link(`./${file}.html`, title)}<span>${idea}</span></li>`,
  );
  return `<ol class="contents">${entries.join('')}</ol>`;
}

function top(current: number, title: string): string {
  const home = `<header class="course-head"><p>${link('../', 'Plateau')} · ${link('./', 'Course')}</p></header>`;
  const skip = link('#text', 'Skip to the text', ' class="skip"');
  return `${skip}${home}${current < 0 ? '' : pageList(current)}<main id="text"><h1>${title}</h1>`;
}

function end(current: number): string {
  const steps: string[] = [];
  const before = COURSE_PAGES[current - 1];
  const after = COURSE_PAGES[current + 1];
  if (before) steps.push(link(`./${before.file}.html`, `← ${before.title}`, ' rel="prev"'));
  if (current >= 0)
    steps.push(
      after
        ? link(`./${after.file}.html`, `${after.title} →`, ' rel="next"')
        : link('./sketch.html', 'A board of your own →', ' rel="next"'),
    );
  const nav =
    steps.length > 0 ? `<nav class="steps" aria-label="Previous and next page">${steps.join('')}</nav>` : '';
  const credit = `Free software: ${link('../source.tar.gz', 'source', ' download')} · ${link('../licences.txt', 'licences')}`;
  return `${nav}</main><footer class="course-foot"><p>${credit}</p></footer><noscript>The figures are computed in your browser and need JavaScript.</noscript>`;
}

function head(title: string, description: string): string {
  return `<head>
    <meta charset="utf-8" />
    <meta name="viewport" content="width=device-width, initial-scale=1" />
    <meta name="color-scheme" content="light dark" />
    <meta name="description" content="${description}" />
    <title>${title} · Plateau</title>
    <link rel="icon" href="/icon.svg" type="image/svg+xml" />
    <script type="module" src="../src/course/main.ts"></script>
  </head>`;
}

/** A page of the course in full, from its text; `file` without its folder and ending. */
export function coursePage(text: string, file: string): string {
  const whole = text
    .replace('<!-- course: contents -->', contents)
    .replace(/<!-- math: (\w+) -->/g, (_, name: string) => formula(name));
  const page = [...COURSE_PAGES, ...OTHER_PAGES].find((each) => each.file === file);
  if (!page) throw new Error(`There is no page "${file}".`);
  const current = COURSE_PAGES.findIndex((each) => each.file === file);
  const shown = current < 0 ? page.title : `${current + 1}. ${page.title}`;
  return `<!doctype html>
<html lang="en">
  ${head(page.title, page.description)}
  <body>${outward(top(current, shown) + whole + end(current))}</body>
</html>`;
}
