import { fragmentOf, LONGEST_LINK, type Linked } from '../model/link.ts';
import { grouped, readable } from '../model/numbers.ts';
import { packed } from '../model/packed-points.ts';
import { commandWords } from '../model/run-words.ts';
import { viewOf } from '../model/view-state.ts';
import { byId } from './dom.ts';
import type { ShownRun } from './earlier-run.ts';
import type { Page } from './page.ts';
import { COMPUTED_SAMPLES } from './samples.ts';
import { fileStem } from './source.ts';

/** What the sheet says: in words, and as a link where there can be one. */
interface Shared {
  readonly words: string;
  readonly fragment?: string;
}

const WITH_LINK = 'The link holds points, settings, step and view. Whoever opens it sees what you see.';

/** Points that travel in the link, if they are few enough. */
async function sharedPoints(run: ShownRun, state: Omit<Linked, 'source'>): Promise<Shared> {
  const { coordinates, dimension, points } = run.opened;
  const what = `${grouped(points)} points`;
  const tooLarge = `${what} do not fit into a link. A session is a file that holds all of it and can be dropped on this page.`;
  if (dimension === 0) return { words: tooLarge.replace('points', 'points by their distances') };
  // Two bytes a coordinate hardly compress to less than half.
  if (coordinates.length > 2 * LONGEST_LINK) return { words: tooLarge };
  const all = await packed(coordinates, dimension);
  if (!all) return { words: tooLarge };
  const source = { kind: 'points', points: all.text, name: fileStem(run.choice) } as const;
  const fragment = fragmentOf({ ...state, source });
  if (fragment.length > LONGEST_LINK) return { words: tooLarge };
  return {
    fragment,
    words:
      `${WITH_LINK} Your ${what} travel inside it, rounded to steps of ${readable(all.unit)}: ` +
      'numbers and hash behind the link are those of the rounded points.',
  };
}

/** The command that computes the run again; none where its points are on no disk. */
function commandOf({ choice, options, record }: ShownRun): string {
  const words = commandWords(options);
  const nth = record.plateausPassed > 0 ? ` --nth ${record.plateausPassed + 1}` : '';
  const tail = `${words === '' ? '' : ` ${words}`}${nth} --hash`;
  if (choice.kind === 'file') {
    const columns = choice.columns?.length ? ` --columns ${choice.columns.join(',')}` : '';
    return `plateau run '${choice.file.name.replaceAll("'", "'\\''")}'${columns}${tail}`;
  }
  if (!COMPUTED_SAMPLES.some(({ shape }) => shape === choice.shape)) return '';
  const noise = choice.noise ? ` --noise ${choice.noise}` : '';
  return `plateau sample ${choice.shape} --n ${choice.size}${noise} | plateau run -${tail}`;
}

/** A link to what is shown, and the command that computes it. */
export class ShareSheet {
  private readonly dialog = byId('share', HTMLDialogElement);
  private readonly link = byId('share-link', HTMLInputElement);
  private readonly command = byId('share-command', HTMLInputElement);
  private readonly copied = byId('copied', HTMLElement);

  constructor(private readonly page: Page) {
    byId('copy-link', HTMLButtonElement).addEventListener('click', () => void this.copy(this.link));
    byId('copy-command', HTMLButtonElement).addEventListener('click', () => void this.copy(this.command));
    byId('share-session', HTMLButtonElement).addEventListener('click', () =>
      byId('export-session', HTMLButtonElement).click(),
    );
  }

  async open(): Promise<void> {
    const { page } = this;
    const run = page.shownRun();
    if (!run) {
      page.showError('There is nothing to share yet.');
      return;
    }
    const { choice, options, record } = run;
    const reached = record.plateausPassed > 0 ? record.stepCount : 0;
    const state = { options, step: page.currentStep, reached, view: viewOf(page.viewState()) };
    const { words, fragment }: Shared =
      choice.kind === 'sample'
        ? { words: WITH_LINK, fragment: fragmentOf({ ...state, source: choice }) }
        : await sharedPoints(run, state);
    byId('share-words', HTMLElement).textContent = words;
    byId('share-link-row', HTMLElement).hidden = fragment === undefined;
    byId('share-session-row', HTMLElement).hidden = fragment !== undefined;
    const { origin, pathname } = location;
    this.link.value = fragment === undefined ? '' : `${origin}${pathname}#${fragment}`;
    this.command.value = commandOf(run);
    byId('share-command-row', HTMLElement).hidden = this.command.value === '' || !record.ended;
    byId('share-hash', HTMLElement).textContent = record.hash;
    this.copied.textContent = '';
    this.dialog.showModal();
    this.link.select();
  }

  private async copy(field: HTMLInputElement): Promise<void> {
    field.select();
    try {
      await navigator.clipboard.writeText(field.value);
      this.copied.textContent = 'Copied.';
    } catch {
      this.copied.textContent =
        'This browser does not let pages copy. The text is selected: copy it by Ctrl+C.';
    }
  }
}
