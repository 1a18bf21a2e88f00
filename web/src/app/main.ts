import './theme.css';
import './controls.css';
import '../view/diagram.css';
import './cards.css';
import './page.css';
import './film-and-cards.css';
import './tools.css';
import './sheets.css';
import './why.css';
import './phone.css';
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
import { startFrom } from './source.ts';
import { explainTerms } from './term-tips.ts';
import { WhySheet } from './why-sheet.ts';

const page = new Page();
const fileInput = byId('file', HTMLInputElement);
const sampleSelect = byId('sample', HTMLSelectElement);

function openFile(file: File): void {
  void page.open({ kind: 'file', file }, {}, 'answer');
}

function openSample({ shape, size, options = {} }: Sample): void {
  void page.open({ kind: 'sample', shape, size }, options, 'answer');
}

fileInput.addEventListener('change', () => {
  const file = fileInput.files?.[0];
  // The same file can be chosen again, for example after it was corrected.
  fileInput.value = '';
  if (file) openFile(file);
});
acceptDrops(byId('plateau', HTMLElement), openFile);
acceptPastes(openFile);

sampleSelect.append(
  new Option('Choose …', ''),
  ...SAMPLES.map(({ shape, label }) => new Option(label, shape)),
);
sampleSelect.addEventListener('change', () => {
  const sample = SAMPLES.find(({ shape }) => shape === sampleSelect.value);
  if (sample) openSample(sample);
});

byId('columns-form', HTMLFormElement).addEventListener('submit', (event) => {
  event.preventDefault();
  try {
    page.openFailedWith(parseList(byId('columns', HTMLInputElement).value, 1, 'Columns'), {});
  } catch (error) {
    page.showError(error);
  }
});

byId('open-as-matrix', HTMLButtonElement).addEventListener('click', () =>
  page.openFailedWith([], { metric: 'matrix' }),
);

byId('dismiss', HTMLButtonElement).addEventListener('click', () => page.dismissError());

offerExports(page);

const gallery = new Gallery(page.client, openSample);
const help = new HelpSheet();
const share = new ShareSheet(page);
const why = new WhySheet(page);
closeSheets();
explainTerms(byId('plateau', HTMLElement));
byId('open-gallery', HTMLButtonElement).addEventListener('click', () => gallery.open());
byId('empty-gallery', HTMLButtonElement).addEventListener('click', () => gallery.open());
byId('open-share', HTMLButtonElement).addEventListener('click', () => void share.open());
byId('open-help', HTMLButtonElement).addEventListener('click', () => help.open());
byId('undo', HTMLButtonElement).addEventListener('click', () => page.travel(-1));
byId('redo', HTMLButtonElement).addEventListener('click', () => page.travel(1));

const axis = byId('axis', HTMLSelectElement);
axis.addEventListener('change', () => page.diagram.setAxis(axis.value === 'linear' ? 'linear' : 'log'));
const speed = byId('speed', HTMLSelectElement);
speed.addEventListener('change', () => {
  page.speed = Number(speed.value);
});

function turnAxis(): void {
  axis.value = axis.value === 'log' ? 'linear' : 'log';
  page.diagram.setAxis(axis.value === 'linear' ? 'linear' : 'log');
}

listenToKeys({
  togglePlay: () => page.togglePlay(),
  move: (steps) => page.move(steps),
  toStart: () => page.goTo(1),
  toEnd: () => page.goTo(Infinity),
  undo: () => page.travel(-1),
  redo: () => page.travel(1),
  turn: (across, upright) => page.shape?.turn(across, upright),
  zoom: (factor) => page.shape?.zoom(factor),
  singleKeysOn: () => help.singleKeys,
  single: {
    p: () => page.nextPlateau(),
    o: () => fileInput.click(),
    g: () => gallery.open(),
    '1': () => page.tools.toggleLayer(0),
    '2': () => page.tools.toggleLayer(1),
    '3': () => page.tools.toggleLayer(2),
    '4': () => page.tools.toggleLayer(3),
    c: () => page.tools.toggleColor(),
    x: () => page.tools.toggleSection(),
    d: () => page.tools.toggleTurning(),
    l: turnAxis,
    f: () => page.shape?.fit(),
    s: () => void share.open(),
    i: () => why.toggle(),
    '?': () => help.open(),
  },
});

matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => page.applyTheme());

const { choice, options, memoryLimit } = startFrom(location.search);
page.memoryLimit = memoryLimit;
if (!(await openLink(page))) {
  if (!choice) page.showEmpty();
  else
    void page.open(choice, options, matchMedia('(prefers-reduced-motion: reduce)').matches ? 'wait' : 'play');
}
addEventListener('hashchange', () => void openLink(page));
workOffline();
