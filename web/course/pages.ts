// What all pages of the course have in common, put in while they are built: so they are whole without any script.

/** In the order in which they are read. */
export const COURSE_PAGES = [
  { file: 'voronoi', title: 'Voronoi and Delaunay', idea: 'Who is nearest, and who are neighbors?' },
  {
    file: 'witnesses',
    title: 'Witnesses and landmarks',
    idea: 'Let the data say which landmarks belong together.',
  },
  {
    file: 'order-two',
    title: 'Why a finite sample witnesses little',
    idea: 'Some cells are too thin to be hit.',
  },
  { file: 'farthest', title: 'Farthest first', idea: 'From coarse to fine, one landmark at a time.' },
  {
    file: 'curves',
    title: 'Curves in the plane',
    idea: 'Where the witness complex is right, and where it is not.',
  },
  { file: 'surfaces', title: 'Surfaces', idea: 'Slivers, holes, and how they are mended.' },
  {
    file: 'plateaus',
    title: 'Betti numbers and plateaus',
    idea: 'Several scales, several answers; and some fakes.',
  },
  {
    file: 'dimensions',
    title: 'More dimensions',
    idea: 'Why witnesses become balls and landmarks get weights.',
  },
] as const;

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
const FORMULAS: Readonly<Record<string, string>> = {
  L: '<mi>L</mi>',
  W: '<mi>W</mi>',
  w: '<mi>w</mi>',
  D: of('<mi>D</mi>'),
  DS: of('<msup><mi>D</mi><mi>S</mi></msup>'),
  S: '<mi>S</mi>',
  CW: of(witnessComplex),
  CW_in_D: row(of(witnessComplex), '<mo>⊆</mo>', of('<mi>D</mi>')),
  CNU: of(relaxed),
  CNUD: row(of(relaxed), '<mo>∩</mo>', of('<mi>D</mi>')),
  surface: '<mover><mi>S</mi><mo>^</mo></mover>',
  nu: '<mi>ν</mi>',
  nu1: '<msub><mi>ν</mi><mn>1</mn></msub>',
  nuk: '<msub><mi>ν</mi><mi>k</mi></msub>',
  nu123: row('<mi>ν</mi><mo>=</mo>', list(1, 2, 3)),
  nu133: row('<mi>ν</mi><mo>=</mo>', list(1, 3, 3)),
  nu1234: row('<mi>ν</mi><mo>=</mo>', list(1, 2, 3, 4)),
  nu1664: row('<mi>ν</mi><mo>=</mo>', list(1, 6, 6, 4)),
  epsilon: '<mi>ε</mi>',
  delta: '<mi>δ</mi>',
  epsiloni: of('<mi>ε</mi>', '<mi>i</mi>'),
  Li: of('<mi>L</mi>', '<mi>i</mi>'),
  beta0: beta(0),
  beta1: beta(1),
  beta2: beta(2),
  beta3: beta(3),
  k: '<mi>k</mi>',
  kplus1: row('<mi>k</mi><mo>+</mo><mn>1</mn>'),
  sigma: '<mi>σ</mi>',
  zeta: '<mi>ζ</mi>',
  Wzeta: '<msup><mi>W</mi><mi>ζ</mi></msup>',
  omega: of('<mi>ω</mi>', '<mi>p</mi>'),
  Rd: '<msup><mi>ℝ</mi><mi>d</mi></msup>',
  R3: '<msup><mi>ℝ</mi><mn>3</mn></msup>',
  R4: '<msup><mi>ℝ</mi><mn>4</mn></msup>',
  S3: '<msup><mi>S</mi><mn>3</mn></msup>',
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

/** A page of the course in full; `file` without its folder and ending. */
export function coursePage(html: string, file: string): string {
  const current = COURSE_PAGES.findIndex((page) => page.file === file);
  const title = /<title>([^<]*?)(?: · [^<]*)?<\/title>/.exec(html)?.[1] ?? '';
  const shown = current < 0 ? title : `${current + 1}. ${title}`;
  return html
    .replace('<!-- course: top -->', () => top(current, shown))
    .replace('<!-- course: contents -->', contents)
    .replace('<!-- course: end -->', () => end(current))
    .replace(/<!-- math: (\w+) -->/g, (_, name: string) => formula(name));
}
