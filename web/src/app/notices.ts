import { PlateauError } from '../client/plateau-error.ts';
import { flatness } from '../model/flatness.ts';
import type { Opened } from '../worker/protocol.ts';
import { byId, setNotice } from './dom.ts';

/** What the command says to its own users; here the form asks. */
const COMMAND_OPTION = / with --columns\b[^.]*\.?$/;

const ADVICE = 'Nothing was changed here. Mend the file and open it again, or open another.';

const FLAT_NOTES = {
  line: 'All points lie on one line, so there is nothing but pieces of it to see.',
  plane: 'All points lie in one plane, so there is no surface to find: what is seen are pieces and loops.',
} as const;

/** What went wrong, what else the visitor should know, and the question which columns are coordinates. */
export class Notices {
  private readonly alert = byId('alert', HTMLElement);
  private readonly advice = byId('advice', HTMLElement);
  private readonly trouble = byId('trouble', HTMLElement);
  private readonly columns = byId('columns-form', HTMLFormElement);
  private readonly warning = byId('warning', HTMLElement);

  /** `about`: the file that the error came from, if it can be read anew with other columns. */
  error(error: unknown, about = ''): void {
    const asksForColumns =
      about !== '' && error instanceof PlateauError && error.code === 'unsupported-dimension';
    const message = error instanceof Error ? error.message : String(error);
    const said = asksForColumns ? message.replace(COMMAND_OPTION, '.') : message;
    this.alert.textContent = about === '' ? said : `${about}: ${said}`;
    setNotice(this.advice, about === '' || asksForColumns ? '' : ADVICE);
    this.trouble.hidden = message === '';
    // A question is no fault.
    this.trouble.classList.toggle('error', !asksForColumns);
    this.columns.hidden = !asksForColumns;
  }

  clear(): void {
    this.error('');
  }

  /** What is worth knowing of points that could be read. */
  opened({ warnings, coordinates, dimension }: Opened): void {
    const flat = dimension === 2 || dimension === 3 ? flatness(coordinates, dimension) : undefined;
    setNotice(this.warning, [...warnings, ...(flat ? [FLAT_NOTES[flat]] : [])].join(' '));
  }
}
