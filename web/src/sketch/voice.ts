/** What a reader who does not see the board is told once all has come to rest. */
const SPEAK_AFTER_MS = 500;

/** Where a point is in the end, and what became of the complex: two things, said together. */
export class Voice {
  private readonly unsaid = new Map<'place' | 'summary', string>();
  private speaking: ReturnType<typeof setTimeout> | undefined;

  /** `heard`: all that was to be said is said. */
  constructor(
    private readonly element: HTMLElement,
    private readonly heard: () => void,
  ) {}

  /** Instead of what was to be said of this kind; undefined: nothing, after all. */
  say(kind: 'place' | 'summary', sentence: string | undefined): void {
    if (sentence === undefined) {
      this.unsaid.delete(kind);
      return;
    }
    this.unsaid.set(kind, sentence);
    clearTimeout(this.speaking);
    this.speaking = setTimeout(() => {
      const parts = [this.unsaid.get('place'), this.unsaid.get('summary')];
      if (this.unsaid.size > 0)
        this.element.textContent = parts.filter((part) => part !== undefined).join('. ');
      this.unsaid.clear();
      this.heard();
    }, SPEAK_AFTER_MS);
  }
}
