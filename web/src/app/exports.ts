import type { RemoteRun } from '../client/plateau-client.ts';
import type { ExportFormat } from '../worker/protocol.ts';
import { diagramSvg } from '../view/diagram-svg.ts';
import { pngOf } from '../view/diagram-png.ts';
import { byId } from './dom.ts';
import type { Page } from './page.ts';
import { saveFile } from './save-file.ts';
import { fileStem, sourceName } from './source.ts';

/** What the core writes: the ending of its name, its type, and whether it is about the step that is shown. */
interface CoreExport {
  readonly button: string;
  readonly format: ExportFormat;
  readonly ending: string;
  readonly type: string;
  readonly ofStep: boolean;
}

const BYTES = 'application/octet-stream';

const CORE_EXPORTS: readonly CoreExport[] = [
  { button: 'export-csv', format: 'betti-csv', ending: '-betti.csv', type: 'text/csv', ofStep: false },
  { button: 'export-json', format: 'plateaus-json', ending: '-plateaus.json', type: BYTES, ofStep: false },
  { button: 'export-ply', format: 'mesh-ply', ending: '.ply', type: BYTES, ofStep: true },
  { button: 'export-off', format: 'mesh-off', ending: '.off', type: BYTES, ofStep: true },
  { button: 'export-glb', format: 'mesh-glb', ending: '.glb', type: 'model/gltf-binary', ofStep: true },
  { button: 'export-vtk', format: 'complex-vtk', ending: '.vtk', type: BYTES, ofStep: true },
  { button: 'export-report', format: 'surface-report', ending: '-surface.json', type: BYTES, ofStep: true },
];

function runOf(page: Page): RemoteRun {
  if (!page.run) throw new Error('There is nothing to save yet.');
  return page.run;
}

/** The buttons that save files. */
export function offerExports(page: Page): void {
  const on = (button: string, save: (stem: string) => Promise<void>): void =>
    byId(button, HTMLButtonElement).addEventListener('click', () => {
      const choice = page.currentChoice;
      if (!choice) page.showError('There is nothing to save yet.');
      else save(fileStem(choice)).catch((error: unknown) => page.showError(error));
    });

  for (const { button, format, ending, type, ofStep } of CORE_EXPORTS) {
    on(button, async (stem) => {
      const step = page.currentStep;
      const bytes = await runOf(page).exportFile(format, ofStep ? step : undefined);
      saveFile(`${stem}${ofStep ? `-step-${step}` : ''}${ending}`, type, new Uint8Array(bytes));
    });
  }
  on('export-session', async (stem) => {
    const bytes = await runOf(page).exportFile('session', page.currentStep, page.viewState());
    saveFile(`${stem}.plateau`, BYTES, new Uint8Array(bytes));
  });

  const diagram = (): string => {
    const { record, currentCards, currentChoice } = page;
    if (!record || !currentChoice) throw new Error('There is nothing to save yet.');
    const title = `Betti numbers over 1/ε: ${sourceName(currentChoice)}`;
    return diagramSvg(record, currentCards, title, page.diagram.axisKind);
  };
  on('export-svg', (stem) => {
    saveFile(`${stem}-diagram.svg`, 'image/svg+xml', diagram());
    return Promise.resolve();
  });
  on('export-png', async (stem) => saveFile(`${stem}-diagram.png`, 'image/png', await pngOf(diagram())));
}
