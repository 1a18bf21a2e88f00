const LONGEST = 50;

/** What was opened, one after another. Going back forgets nothing until something new is added. */
export class History<T> {
  private readonly entries: T[] = [];
  private at = -1;

  /** Where it stands, for `returnTo`. */
  get place(): number {
    return this.at;
  }

  add(entry: T): void {
    this.entries.length = this.at + 1;
    this.entries.push(entry);
    if (this.entries.length > LONGEST) this.entries.shift();
    this.at = this.entries.length - 1;
  }

  /** The entry that many places away, if there is one. */
  peek(by: -1 | 1): T | undefined {
    return this.entries[this.at + by];
  }

  /** Goes there. */
  go(by: -1 | 1): void {
    if (this.peek(by) !== undefined) this.at += by;
  }

  /** Takes steps back that led nowhere: to a place since which nothing was added. */
  returnTo(place: number): void {
    this.at = Math.max(-1, Math.min(place, this.entries.length - 1));
  }
}
