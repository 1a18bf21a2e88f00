import { History } from '../model/history.ts';
import { byId } from './dom.ts';
import type { Opening } from './opening.ts';

/** Undo and redo. What is shown has a place in the history, which an opening under way may be ahead of. */
export class Travel {
  private readonly history = new History<Opening>();
  private shownPlace = -1;

  /** What was shown before (-1) or after (1); undefined: nothing. */
  go(by: -1 | 1): Opening | undefined {
    const opening = this.history.peek(by);
    if (!opening) return undefined;
    this.history.go(by);
    this.mark();
    return opening;
  }

  /** What was being opened led nowhere. */
  turnBack(): void {
    this.history.returnTo(this.shownPlace);
    this.mark();
  }

  /** What the history leads to is shown now; `opened`: it is new there. */
  arrive(opened: Opening | undefined): void {
    if (opened) this.history.add(opened);
    this.shownPlace = this.history.place;
    this.mark();
  }

  private mark(): void {
    byId('undo', HTMLButtonElement).disabled = !this.history.peek(-1);
    byId('redo', HTMLButtonElement).disabled = !this.history.peek(1);
  }
}
