import { cardName, cardWords, type PlateauCard } from '../model/plateau-cards.ts';

const SPOKEN_EVERY_MS = 1_000;

/** Tells screen readers on which plateau the playhead has arrived; steps go unsaid. */
export class Announcer {
  private saidAt = -Infinity;
  private said: string | undefined;

  /** `what`: with what each sentence begins. */
  constructor(
    private readonly element: HTMLElement,
    private readonly what = 'Plateau',
  ) {}

  /** Another run: what was said is over. */
  restart(): void {
    this.said = undefined;
    this.element.textContent = '';
  }

  /** The card whose shape is shown, if any. What the film leaves within a second goes unsaid. */
  at(card: PlateauCard | undefined): void {
    const name = card && cardName(card);
    if (!card || name === this.said || performance.now() - this.saidAt < SPOKEN_EVERY_MS) return;
    this.tell(card);
  }

  /** What was asked for is told in any case. */
  tell(card: PlateauCard): void {
    this.said = cardName(card);
    this.saidAt = performance.now();
    const { shape, counts, scale } = cardWords(card);
    this.say(`${this.what}: ${shape}: ${counts}, ${scale}`);
  }

  say(words: string): void {
    this.element.textContent = words;
  }
}
