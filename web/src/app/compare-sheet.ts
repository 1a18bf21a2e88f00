import { byId, setNotice } from './dom.ts';
import { parseList, wholeFrom } from './entries.ts';
import type { RunOptions } from '../worker/protocol.ts';
import type { Opening } from './opening.ts';
import type { Page } from './page.ts';
import { SAMPLES, type Sample } from './samples.ts';
import { isFamily } from './source.ts';

const SAME = 'same';
const FILE = 'file';

/** The witness complex as it is without a wider ν: what a wider one is compared with. */
function plainNu(nu: readonly number[]): readonly number[] {
  const plain = nu.map((_, i) => i + 1);
  return plain.join() === nu.join() ? [] : plain;
}

/** Asks what the second run is. */
export class CompareSheet {
  private readonly dialog = byId('compare', HTMLDialogElement);
  private readonly points = byId('compare-points', HTMLSelectElement);
  private readonly file = byId('compare-file', HTMLInputElement);
  private readonly size = byId('compare-size', HTMLInputElement);
  private readonly family = byId('compare-family', HTMLSelectElement);
  private readonly nu = byId('compare-nu', HTMLInputElement);
  private readonly first = byId('compare-first', HTMLInputElement);
  private readonly alert = byId('compare-alert', HTMLElement);
  /** Whether the file is one: pasted text is not. */
  private onDisk = true;

  constructor(
    private readonly page: Page,
    onChoose: (second: Opening) => void,
  ) {
    const gallery = document.createElement('optgroup');
    gallery.label = 'Gallery';
    gallery.append(...SAMPLES.map(({ shape, label }) => new Option(label, shape)));
    this.points.append(new Option('Those of run A', SAME), new Option('A file', FILE), gallery);
    this.family.append(
      ...[...byId('family', HTMLSelectElement).options].map(({ text, value }) => new Option(text, value)),
    );
    this.points.addEventListener('change', () => this.fill());
    this.file.addEventListener('change', () => (this.onDisk = true));
    // Each family has a ν of its own.
    this.family.addEventListener('change', () => (this.nu.value = ''));
    byId('compare-form', HTMLFormElement).addEventListener('submit', (event) => {
      try {
        onChoose(this.asked());
      } catch (error) {
        event.preventDefault();
        setNotice(this.alert, error instanceof Error ? error.message : String(error));
      }
    });
  }

  open(): void {
    if (!this.page.shownRun()) {
      this.page.showError('There is nothing to compare with yet: open a point cloud first.');
      return;
    }
    this.fill();
    this.dialog.showModal();
  }

  /** A file that is dropped or pasted while the sheet asks is the answer. */
  take(file: File, onDisk: boolean): boolean {
    if (!this.dialog.open) return false;
    this.onDisk = onDisk;
    const transfer = new DataTransfer();
    transfer.items.add(file);
    this.file.files = transfer.files;
    this.points.value = FILE;
    this.fill();
    return true;
  }

  /** What fits the points that are chosen. */
  private fill(): void {
    const { value } = this.points;
    const run = this.page.shownRun();
    const sample = this.sample;
    setNotice(this.alert, '');
    byId('compare-file-row', HTMLElement).hidden = value !== FILE;
    byId('compare-size-row', HTMLElement).hidden = !sample;
    this.size.value = sample ? String(sample.size) : '';
    const options = value === SAME ? run?.options : sample?.options;
    const nu = value === SAME && run ? plainNu(run.opened.nu) : options?.nu;
    this.family.value = options?.family ?? '';
    this.nu.value = nu?.join(', ') ?? '';
    this.first.value = options?.first === undefined ? '' : String(options.first);
  }

  private get sample(): Sample | undefined {
    return SAMPLES.find(({ shape }) => shape === this.points.value);
  }

  /** Throws a sentence where an entry makes no sense. */
  private asked(): Opening {
    const nu = parseList(this.nu.value, 0, 'ν');
    const first = wholeFrom(0, this.first, 'The first landmark');
    const size = wholeFrom(1, this.size, 'How many');
    const { family } = this;
    const own = {
      ...(isFamily(family.value) ? { family: family.value } : {}),
      ...(nu.length > 0 ? { nu } : {}),
      ...(first === undefined ? {} : { first }),
    };
    const { sample } = this;
    if (sample) {
      const choice = { kind: 'sample', shape: sample.shape, size: size ?? sample.size } as const;
      return { choice, options: { ...without(sample.options ?? {}), ...own } };
    }
    if (this.points.value === FILE) {
      const file = this.file.files?.[0];
      if (!file) throw new Error('Choose a file, or drop one on the page.');
      return { choice: { kind: 'file', file, onDisk: this.onDisk }, options: own };
    }
    const run = this.page.shownRun();
    if (!run) throw new Error('The points of run A are gone.');
    return { choice: run.choice, options: { ...without(run.options), ...own } };
  }
}

/** The options that the sheet does not ask for. */
function without(options: RunOptions): RunOptions {
  const others: Record<string, unknown> = { ...options };
  for (const asked of ['family', 'nu', 'first']) delete others[asked];
  return others;
}
