import './theme.css';
import './page.css';
import './film-and-cards.css';
import './phone.css';
import { diagramSvg } from '../view/diagram-svg.ts';
import { byId } from './dom.ts';
import { acceptDrops } from './file-drop.ts';
import { listenToKeys } from './keyboard.ts';
import { Page } from './page.ts';
import { acceptPastes } from './paste.ts';
import { SAMPLES } from './samples.ts';
import { saveFile } from './save-file.ts';
import { fileStem, parseList, sourceName, startFrom } from './source.ts';

const page = new Page();
const fileInput = byId('file', HTMLInputElement);
const sampleSelect = byId('sample', HTMLSelectElement);

function openFile(file: File): void {
  void page.open({ kind: 'file', file }, {}, 'answer');
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
  if (sample) void page.open({ kind: 'sample', shape: sample.shape, size: sample.size }, {}, 'answer');
});

byId('columns-form', HTMLFormElement).addEventListener('submit', (event) => {
  event.preventDefault();
  try {
    page.openWithColumns(parseList(byId('columns', HTMLInputElement).value, 1, 'Columns'));
  } catch (error) {
    page.showError(error);
  }
});

byId('dismiss', HTMLButtonElement).addEventListener('click', () => page.dismissError());

async function saveExport(format: 'betti-csv' | 'mesh-ply'): Promise<void> {
  try {
    const { currentChoice, currentStep } = page;
    const stem = currentChoice ? fileStem(currentChoice) : 'plateau';
    if (format === 'betti-csv') {
      saveFile(`${stem}-betti.csv`, 'text/csv', new Uint8Array(await page.exportFile(format)));
    } else {
      const bytes = await page.exportFile(format, currentStep);
      saveFile(`${stem}-step-${currentStep}.ply`, 'application/octet-stream', new Uint8Array(bytes));
    }
  } catch (error) {
    page.showError(error);
  }
}
byId('export-csv', HTMLButtonElement).addEventListener('click', () => void saveExport('betti-csv'));
byId('export-ply', HTMLButtonElement).addEventListener('click', () => void saveExport('mesh-ply'));
byId('export-svg', HTMLButtonElement).addEventListener('click', () => {
  const { record, currentCards, currentChoice } = page;
  if (!record || !currentChoice) return;
  const svg = diagramSvg(record, currentCards, `Betti numbers over 1/ε: ${sourceName(currentChoice)}`);
  saveFile(`${fileStem(currentChoice)}-diagram.svg`, 'image/svg+xml', svg);
});

listenToKeys({
  togglePlay: () => page.togglePlay(),
  move: (steps) => page.move(steps),
  toStart: () => page.goTo(1),
  toEnd: () => page.goTo(Infinity),
  nextPlateau: () => page.nextPlateau(),
  open: () => fileInput.click(),
});

matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => page.applyTheme());

const { choice, options } = startFrom(location.search);
void page.open(choice, options, matchMedia('(prefers-reduced-motion: reduce)').matches ? 'wait' : 'play');
