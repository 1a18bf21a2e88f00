import './browser-check.ts';
import './theme.css';
import './base.css';
import './controls.css';
import '../view/diagram.css';
import './cards.css';
import './page.css';
import './film-and-cards.css';
import './tools.css';
import './pumps.css';
import './sheets.css';
import './why.css';
import './phone.css';
import './comparison.css';
import type { AxisKind } from '../model/scale-axis.ts';
import { CompareSheet } from './compare-sheet.ts';
import { Comparison } from './comparison.ts';
import { byId } from './dom.ts';
import { parseList } from './entries.ts';
import { openLink } from './open-link.ts';
import { ShareSheet } from './share-sheet.ts';
import { offerExports } from './exports.ts';
import { acceptDrops } from './file-drop.ts';
import { Gallery } from './gallery.ts';
import { closeSheets, HelpSheet } from './help-sheet.ts';
import { listenToKeys } from './keyboard.ts';
import { Page } from './page.ts';
import { workOffline } from './offline.ts';
import { acceptPastes } from './paste.ts';
import { SAMPLES, type Sample } from './samples.ts';
import { startFrom, type SourceChoice } from './source.ts';
import { explainTerms } from './term-tips.ts';
import type { TransportActions } from './transport.ts';
import type { RunOptions } from '../worker/protocol.ts';
import { WhySheet } from './why-sheet.ts';

const page = new Page();
const fileInput = byId('file', HTMLInputElement);
const sampleSelect = byId('sample', HTMLSelectElement);

const axis = byId('axis', HTMLSelectElement);

function setAxis(kind: AxisKind): void {
  axis.value = kind;
  page.diagram.setAxis(kind);
  comparison.pair?.setAxis(kind);
}

const comparison: Comparison = new Comparison(page, setAxis);
const compareSheet = new CompareSheet(page, (second) => void comparison.open(second));

/** What is opened while two runs are compared is the second one. */
function open(choice: SourceChoice, options: RunOptions): void {
  if (comparison.pair) void comparison.open({ choice, options });
  else {
    comparison.close();
    void page.open(choice, options, 'answer');
  }
}

function openFile(file: File, onDisk = true): void {
  if (!compareSheet.take(file, onDisk)) open({ kind: 'file', file, onDisk }, {});
}

function openSample({ shape, size, options = {} }: Sample): void {
  open({ kind: 'sample', shape, size }, options);
}

function player(): TransportActions {
  return comparison.pair ?? page;
}

fileInput.addEventListener('change', () => {
  const file = fileInput.files?.[0];
  // The same file can be chosen again, for example after it was corrected.
  fileInput.value = '';
  if (file) openFile(file);
});
acceptDrops(byId('plateau', HTMLElement), (file) => openFile(file));
acceptPastes(openFile);

sampleSelect.append(
  new Option('Choose …', ''),
  ...SAMPLES.map(({ shape, label }) => new Option(label, shape)),
);
sampleSelect.addEventListener('change', () => {
  const sample = SAMPLES.find(({ shape }) => shape === sampleSelect.value);
  if (sample) openSample(sample);
});

/** The file that could not be read, of the page or of the second run. */
function openFailedWith(columns: readonly number[], options: RunOptions): void {
  if (!comparison.openRefusedWith(columns, options)) page.openFailedWith(columns, options);
}

byId('columns-form', HTMLFormElement).addEventListener('submit', (event) => {
  event.preventDefault();
  try {
    openFailedWith(parseList(byId('columns', HTMLInputElement).value, 1, 'Columns'), {});
  } catch (error) {
    page.showError(error);
  }
});

byId('open-as-matrix', HTMLButtonElement).addEventListener('click', () =>
  openFailedWith([], { metric: 'matrix' }),
);

byId('dismiss', HTMLButtonElement).addEventListener('click', () => page.dismissError());

offerExports(page);

const gallery = new Gallery(page.client, openSample);
const help = new HelpSheet();
const share = new ShareSheet(page, comparison);
const why = new WhySheet(page);
closeSheets();
explainTerms(byId('plateau', HTMLElement));
byId('open-gallery', HTMLButtonElement).addEventListener('click', () => gallery.open());
byId('empty-gallery', HTMLButtonElement).addEventListener('click', () => gallery.open());
byId('open-share', HTMLButtonElement).addEventListener('click', () => void share.open());
byId('open-help', HTMLButtonElement).addEventListener('click', () => help.open());
byId('open-compare', HTMLButtonElement).addEventListener('click', () => compareSheet.open());
byId('undo', HTMLButtonElement).addEventListener('click', () => page.travel(-1));
byId('redo', HTMLButtonElement).addEventListener('click', () => page.travel(1));

axis.addEventListener('change', () => setAxis(axis.value === 'linear' ? 'linear' : 'log'));
const speed = byId('speed', HTMLSelectElement);
speed.addEventListener('change', () => {
  page.speed = Number(speed.value);
});

function compareOrNot(): void {
  if (comparison.pair) comparison.close();
  else compareSheet.open();
}

/** Undo and redo are of the page alone. */
function travel(by: -1 | 1): void {
  if (!comparison.pair) page.travel(by);
}

function shapeInFocus() {
  return comparison.pair?.shapeInFocus ?? page.shape;
}

listenToKeys({
  togglePlay: () => player().togglePlay(),
  move: (steps) => player().move(steps),
  toStart: () => player().goTo(1),
  toEnd: () => player().goTo(Infinity),
  undo: () => travel(-1),
  redo: () => travel(1),
  turn: (across, upright) => shapeInFocus()?.turn(across, upright),
  zoom: (factor) => shapeInFocus()?.zoom(factor),
  singleKeysOn: () => help.singleKeys,
  single: {
    p: () => (comparison.pair ? comparison.pair.nextPlateau() : page.walk.next()),
    n: () => page.walk.nextSignificant(),
    o: () => fileInput.click(),
    g: () => gallery.open(),
    '1': () => page.tools.toggleLayer(0),
    '2': () => page.tools.toggleLayer(1),
    '3': () => page.tools.toggleLayer(2),
    '4': () => page.tools.toggleLayer(3),
    c: () => page.tools.toggleColor(),
    x: () => page.tools.toggleSection(),
    d: () => page.tools.toggleTurning(),
    l: () => setAxis(axis.value === 'log' ? 'linear' : 'log'),
    f: () => (comparison.pair ?? page.shape)?.fit(),
    s: () => void share.open(),
    v: compareOrNot,
    i: () => why.toggle(),
    '?': () => help.open(),
  },
});

matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => {
  page.shape?.applyTheme();
  page.diagram.requestPaint();
  comparison.pair?.applyTheme();
});

const { choice, options, memoryLimit } = startFrom(location.search);
page.memoryLimit = memoryLimit;
if (!(await openLink(page, comparison))) {
  if (!choice) page.showEmpty();
  else
    void page.open(choice, options, matchMedia('(prefers-reduced-motion: reduce)').matches ? 'wait' : 'play');
}
addEventListener('hashchange', () => void openLink(page, comparison));
workOffline();
