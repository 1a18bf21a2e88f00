import {
  fragmentOf,
  LONGEST_LINK,
  type Linked,
  type LinkedBeside,
  type LinkedSource,
} from '../model/link.ts';
import { grouped, readable } from '../model/numbers.ts';
import { packed } from '../model/packed-points.ts';
import { commandWords } from '../model/run-words.ts';
import { viewOf } from '../model/view-state.ts';
import type { Comparison } from './comparison.ts';
import { byId } from './dom.ts';
import { samePoints, type ShownRun } from './earlier-run.ts';
import type { Page } from './page.ts';
import { COMPUTED_SAMPLES } from './samples.ts';
import { fileStem } from './source.ts';

/** What the sheet says: in words, and as a link where there can be one. */
interface Shared {
  readonly words: string;
  readonly fragment?: string;
}

/** The points of a run as a link holds them; none: there are too many. */
interface SharedSource {
  readonly source?: LinkedSource;
  /** What there is to know of them. */
  readonly words: string;
}

const WITH_LINK = 'The link holds points, settings, step and view. Whoever opens it sees what you see.';
const WITH_BOTH =
  'The link holds both runs, their points and settings, the scale and the views. Whoever opens it sees what you see.';
const AS_SESSION = 'A session is a file that holds all of it and can be dropped on this page.';
const SESSION_EACH = 'A session is a file that holds one run: save it where that run is alone on the page.';

async function sharedSource({ choice, opened }: ShownRun): Promise<SharedSource> {
  if (choice.kind === 'sample') return { source: choice, words: '' };
  const { coordinates, dimension, points } = opened;
  const what = `${grouped(points)} points`;
  const tooLarge = { words: `${what} do not fit into a link.` };
  if (dimension === 0) return { words: tooLarge.words.replace('points', 'points by their distances') };
  // Two bytes a coordinate hardly compress to less than half.
  if (coordinates.length > 2 * LONGEST_LINK) return tooLarge;
  const all = await packed(coordinates, dimension);
  if (!all) return tooLarge;
  return {
    source: { kind: 'points', points: all.text, name: fileStem(choice) },
    words:
      ` Your ${what} travel inside it, rounded to steps of ${readable(all.unit)}: ` +
      'numbers and hash behind the link are those of the rounded points.',
  };
}

/** A link to a run, and to one beside it if there is one. */
async function shared(
  run: ShownRun,
  state: Omit<Linked, 'source' | 'beside'>,
  beside: (Omit<LinkedBeside, 'source'> & { readonly run: ShownRun }) | undefined,
): Promise<Shared> {
  const first = await sharedSource(run);
  const others = beside && !samePoints(run.choice, beside.run.choice);
  const second = others ? await sharedSource(beside.run) : undefined;
  const elsewhere = beside ? SESSION_EACH : AS_SESSION;
  if (!first.source) return { words: `${first.words} ${elsewhere}` };
  if (second && !second.source) return { words: `${second.words} ${elsewhere}` };
  const fragment = fragmentOf({
    ...state,
    source: first.source,
    ...(beside ? { beside: { ...beside, source: second?.source } } : {}),
  });
  if (fragment.length > LONGEST_LINK)
    return { words: `${grouped(run.opened.points)} points do not fit into a link. ${elsewhere}` };
  return { fragment, words: `${beside ? WITH_BOTH : WITH_LINK}${first.words}${second?.words ?? ''}` };
}

/** A session runs with its own options, as the command does; unless its stop at the noise was lifted here. */
function runsAsSaved({ options, opened, record }: ShownRun): boolean {
  const { noiseStopFrom = Infinity } = options;
  return opened.session !== undefined && (record.endedAtNoise || opened.points < noiseStopFrom);
}

/**
 * The command that computes the run again; none where its points are on no disk, where it did not come to its end, or
 * where settings of a session were changed: those that were cleared the command would take from the file.
 */
function commandOf(run: ShownRun): string {
  const { choice, options, opened, record } = run;
  if (record.state !== 'finished') return '';
  const ofSession = opened.session !== undefined || (choice.kind === 'file' && choice.newOptions === true);
  if (ofSession && !runsAsSaved(run)) return '';
  const words = ofSession ? '' : commandWords(options);
  const end = record.endedAtNoise && !ofSession ? ' --until noise' : '';
  const nth = record.plateausPassed > 0 ? ` --nth ${record.plateausPassed + 1}` : '';
  const tail = `${words === '' ? '' : ` ${words}`}${end}${nth} --hash`;
  if (choice.kind === 'file') {
    if (choice.onDisk === false) return '';
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

  constructor(
    private readonly page: Page,
    private readonly comparison: Comparison,
  ) {
    byId('copy-link', HTMLButtonElement).addEventListener('click', () => void this.copy(this.link));
    byId('copy-command', HTMLButtonElement).addEventListener('click', () => void this.copy(this.command));
    byId('share-session', HTMLButtonElement).addEventListener('click', () =>
      byId('export-session', HTMLButtonElement).click(),
    );
  }

  async open(): Promise<void> {
    const { page } = this;
    const { pair } = this.comparison;
    const run = page.shownRun();
    if (!run) {
      page.showError('There is nothing to share yet.');
      return;
    }
    const { record } = run;
    const reached = record.plateausPassed > 0 ? record.stepCount : 0;
    const state = {
      options: run.options,
      reached,
      step: pair?.firstStep ?? page.currentStep,
      view: viewOf(page.viewState()),
    };
    const second = pair?.runs[1];
    const beside = pair && second ? { ...pair.view, run: second, options: second.options } : undefined;
    const { words, fragment } = await shared(run, state, beside);
    byId('share-words', HTMLElement).textContent = words;
    byId('share-link-row', HTMLElement).hidden = fragment === undefined;
    byId('share-session-row', HTMLElement).hidden = fragment !== undefined || pair !== undefined;
    const { origin, pathname } = location;
    this.link.value = fragment === undefined ? '' : `${origin}${pathname}#${fragment}`;
    const runs = second ? [run, second] : [run];
    const commands = runs.map(commandOf);
    this.command.value = commands.join('; ');
    byId('share-command-row', HTMLElement).hidden = commands.includes('');
    const hashes = runs.map(({ record }) => record.hash).join(' and ');
    byId('share-prints', HTMLElement).textContent = second
      ? `They print the same numbers, and the same hashes: ${hashes}.`
      : `It prints the same numbers, and the same hash: ${hashes}.`;
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
