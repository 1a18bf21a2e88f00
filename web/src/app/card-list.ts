import { cardWords, type PlateauCard } from '../model/plateau-cards.ts';
import type { StepSummary } from '../model/record.ts';

const NONE_YET = 'The first plateaus appear here while the run goes on.';
const NONE =
  'No scale at which the shape stands still: too few points, or too much noise? Try more points, a thinned-out ' +
  'cloud without outliers, or another family below.';

/** The plateaus as buttons, longest first; a click goes to the middle of one. */
export class CardList {
  private cards: readonly PlateauCard[] = [];
  private buttons: HTMLButtonElement[] = [];

  constructor(
    private readonly list: HTMLElement,
    private readonly empty: HTMLElement,
    private readonly onChoose: (card: PlateauCard) => void,
  ) {}

  show(cards: readonly PlateauCard[], complete: boolean): void {
    this.empty.hidden = cards.length > 0;
    this.empty.textContent = complete ? NONE : NONE_YET;
    const focused = this.buttons.findIndex((button) => button === document.activeElement);
    this.cards = cards;
    this.buttons = cards.map((card) => this.buttonFor(card));
    this.list.replaceChildren(
      ...this.buttons.map((button) => {
        const item = document.createElement('li');
        item.append(button);
        return item;
      }),
    );
    this.buttons[focused]?.focus();
  }

  /** Marks the card whose shape the step shows, and returns it. */
  mark({ step, family, betti }: StepSummary): PlateauCard | undefined {
    let shown: PlateauCard | undefined;
    this.cards.forEach((card, i) => {
      const within = card.firstStep <= step && step <= card.lastStep;
      const here = within && card.family === family && card.betti.join() === betti.join();
      if (here) this.buttons[i]?.setAttribute('aria-current', 'step');
      else this.buttons[i]?.removeAttribute('aria-current');
      if (here) shown ??= card;
    });
    return shown;
  }

  private buttonFor(card: PlateauCard): HTMLButtonElement {
    const { shape, counts, scale, family, note } = cardWords(card);
    const button = document.createElement('button');
    button.type = 'button';
    button.className = 'card';
    button.dataset['family'] = card.family;
    button.dataset['betti'] = card.betti.join(',');
    button.dataset['first'] = String(card.firstStep);
    button.dataset['last'] = String(card.lastStep);
    const line = (className: string, text: string): HTMLElement => {
      const span = document.createElement('span');
      span.className = className;
      span.textContent = text;
      return span;
    };
    // On screen each part has its line; read aloud they are one sentence.
    button.append(
      line('card-shape', shape),
      line('for-readers', ': '),
      line('card-counts', counts),
      line('for-readers', ' · '),
      line('card-scale', `${scale} · ${family}`),
    );
    if (note) button.append(line('for-readers', ' · '), line('card-note', note));
    button.addEventListener('click', () => this.onChoose(card));
    return button;
  }
}
