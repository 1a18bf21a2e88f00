import type { Parts } from './parts.ts';

const EMPTY = 'Nothing to show yet: this element needs a shape or a src.';
const REFUSED = 'Nothing to show: the points could not be opened.';

/** The sentences that lie over the shape: what went wrong, and which attributes were not understood. */
export class Trouble {
  /** What was not understood stays so until that is mended or dismissed. */
  private complaint = '';
  private dismissed = '';

  /** `again` tries once more what failed. */
  constructor(
    private readonly parts: Parts,
    again: () => void,
  ) {
    parts.again.addEventListener('click', again);
    parts.dismiss.addEventListener('click', () => {
      this.dismissed = this.complaint;
      this.hide();
    });
  }

  /** `retry`: it may help to try again. */
  say(sentence: string, retry = false): void {
    this.parts.said.textContent = sentence;
    this.parts.again.hidden = !retry;
    this.parts.trouble.hidden = false;
  }

  /** Returns whether there is something new that was not understood; '': all was. */
  complain(sentence: string): boolean {
    if (sentence === this.complaint) return false;
    this.complaint = sentence;
    this.dismissed = '';
    if (sentence === '') this.hide();
    return sentence !== '';
  }

  /** What went wrong is over. */
  quiet(): void {
    if (this.complaint === this.dismissed) this.hide();
    else this.say(this.complaint);
  }

  /** Why nothing is shown; `name`: what is to be. */
  note(name: string | undefined, busy: boolean, refused: boolean): void {
    const { empty, readout, status } = this.parts;
    const text = name === undefined ? EMPTY : refused ? REFUSED : busy ? `Reading ${name} …` : '';
    empty.textContent = readout.textContent = status.textContent = text;
    empty.hidden = text === '';
  }

  /** The focus does not fall out of the element with the button that had it. */
  private hide(): void {
    const { trouble, transport, view } = this.parts;
    const focused = trouble.matches(':focus-within');
    trouble.hidden = true;
    if (!focused) return;
    transport.play.focus({ preventScroll: true });
    if (!transport.play.matches(':focus')) view.focus({ preventScroll: true });
  }
}
