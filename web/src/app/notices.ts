import { PlateauError, WORKER_FAILED, type ErrorCode } from '../client/plateau-error.ts';
import { distancesInWords } from '../model/forecast.ts';
import { flatness } from '../model/flatness.ts';
import type { Opened } from '../worker/protocol.ts';
import { byId, setNotice } from './dom.ts';

/** What the command says to its own users; here the form asks. */
const COMMAND_OPTION = / with --columns\b[^.]*\.?$/;
/** Of a table that was read without its last columns. */
const ALL_COLUMNS = / Take points of R\^\d with --columns ([\d,]+)\./;

const ADVICE = 'Nothing was changed here. Mend the file and open it again, or open another.';
/** What is no table of points may still be one of distances: triangular, or with names. */
const MAY_BE_DISTANCES =
  'Nothing was changed here. Are they distances? Else mend the file and open it again.';
const WORKER_ADVICE = 'What is shown stays. Open the points again to go on.';
const NO_NUMBERS_OR_RAGGED: readonly string[] = [
  'not-a-number',
  'ragged-rows',
  'malformed-input',
] satisfies readonly ErrorCode[];
const TABLE = /\.(csv|tsv|txt|dat)$/i;

const FLAT_NOTES = {
  line: 'All points lie on one line, so there is nothing but pieces of it to see.',
  plane: 'All points lie in one plane, so there is no surface to find: what is seen are pieces and loops.',
} as const;

function adviceOn(message: string, asksForColumns: boolean, asksForDistances: boolean): string {
  if (!asksForColumns && !asksForDistances) return ADVICE;
  const memory = distancesInWords(Number(/(\d+) columns/.exec(message)?.[1] ?? 0));
  return [asksForDistances ? MAY_BE_DISTANCES : '', memory].filter(Boolean).join(' ');
}

/** What went wrong, what else the visitor should know, and the question which columns are coordinates. */
export class Notices {
  private readonly alert = byId('alert', HTMLElement);
  private readonly advice = byId('advice', HTMLElement);
  private readonly trouble = byId('trouble', HTMLElement);
  private readonly home = this.trouble.parentElement;
  private readonly columns = byId('columns-form', HTMLFormElement);
  private readonly columnsEntry = byId('columns-entry', HTMLElement);
  private readonly columnsField = byId('columns', HTMLInputElement);
  private readonly distances = byId('open-as-matrix', HTMLElement);
  private readonly warning = byId('warning', HTMLElement);

  /** `about`: the file that the error came from, if it can be read anew with other columns. */
  error(error: unknown, about = ''): void {
    const asksForColumns =
      about !== '' && error instanceof PlateauError && error.code === 'unsupported-dimension';
    const asksForDistances =
      error instanceof PlateauError && TABLE.test(about) && NO_NUMBERS_OR_RAGGED.includes(error.code);
    const message = error instanceof Error ? error.message : String(error);
    const said = asksForColumns ? message.replace(COMMAND_OPTION, '.') : message;
    this.alert.textContent = about === '' ? said : `${about}: ${said}`;
    const lost = error instanceof PlateauError && error.code === WORKER_FAILED;
    const advice = about === '' ? '' : adviceOn(message, asksForColumns, asksForDistances);
    setNotice(this.advice, lost ? WORKER_ADVICE : advice);
    this.trouble.hidden = message === '';
    // A question is no fault.
    this.trouble.classList.toggle('error', !asksForColumns);
    this.trouble.after(this.columns);
    this.columns.hidden = !asksForColumns && !asksForDistances;
    this.columnsEntry.hidden = !asksForColumns;
    this.distances.hidden = false;
    if (message !== '' && this.trouble.parentElement !== this.home)
      this.trouble.scrollIntoView({ block: 'nearest' });
  }

  clear(): void {
    this.error('');
    if (this.trouble.parentElement !== this.home) this.home?.prepend(this.trouble);
  }

  /** What is wrong with a setting is said beside it, until the next opening. */
  nextTo(setting: Element): void {
    setting.after(this.trouble);
  }

  /** What is worth knowing of points that could be read; `mayAsk`: the file can be read anew with other columns. */
  opened({ warnings, coordinates, dimension }: Opened, mayAsk: boolean): void {
    const flat = dimension === 2 || dimension === 3 ? flatness(coordinates, dimension) : undefined;
    const all = warnings.map((text) => ALL_COLUMNS.exec(text)?.[1]).find((columns) => columns !== undefined);
    const said = warnings.map((text) => text.replace(ALL_COLUMNS, ''));
    setNotice(this.warning, [...said, ...(flat ? [FLAT_NOTES[flat]] : [])].join(' '));
    if (all === undefined || !mayAsk) return;
    this.columnsField.value = all.replaceAll(',', ', ');
    this.warning.after(this.columns);
    this.columns.hidden = this.columnsEntry.hidden = false;
    this.distances.hidden = true;
  }
}
