/** What a reader who does not see the board is told once all has come to rest. */
const SPEAK_AFTER_MS = 500;

/** Where a point is in the end, and what became of the complex: two things, said together. */
export class Voice {
  private readonly unsaid = new Map<'place' | 'summary', string>();
  private speaking: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly element: HTMLElement) {}

  say(kind: 'place' | 'summary', sentence: string): void {
    this.unsaid.set(kind, sentence);
    clearTimeout(this.speaking);
    this.speaking = setTimeout(() => {
      const parts = [this.unsaid.get('place'), this.unsaid.get('summary')];
      this.element.textContent = parts.filter((part) => part !== undefined).join('. ');
      this.unsaid.clear();
    }, SPEAK_AFTER_MS);
  }
}
