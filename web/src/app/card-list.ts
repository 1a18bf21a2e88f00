import { cardName, cardWords, type PlateauCard } from '../model/plateau-cards.ts';
import type { StepSummary } from '../model/record.ts';

const NONE_YET = 'The first plateaus appear here while the run goes on.';
const NONE =
  'No scale at which the shape stands still: too few points, or too much noise? Try more points, a thinned-out ' +
  'cloud without outliers, or another family below.';

/** One card on the page. */
interface Item {
  readonly element: HTMLLIElement;
  readonly button: HTMLButtonElement;
  card: PlateauCard;
}

/**
 * The plateaus as buttons, longest first; a click goes to the middle of one. While a run grows its cards stay the same
 * buttons, so that none slips away under the pointer and the focus stays.
 */
export class CardList {
  private items: Item[] = [];

  constructor(
    private readonly list: HTMLElement,
    private readonly empty: HTMLElement,
    private readonly onChoose: (card: PlateauCard) => void,
  ) {}

  show(cards: readonly PlateauCard[], complete: boolean): void {
    this.empty.hidden = cards.length > 0;
    this.empty.textContent = complete ? NONE : NONE_YET;
    const known = new Map(this.items.map((item) => [cardName(item.card), item]));
    const items = cards.map((card) => {
      const item = known.get(cardName(card)) ?? this.itemFor(card);
      item.card = card;
      write(item);
      return item;
    });
    const moved = items.length !== this.items.length || items.some((item, i) => item !== this.items[i]);
    this.items = items;
    if (!moved) return;
    const focused = items.find(({ button }) => button.matches(':focus'));
    this.list.replaceChildren(...items.map(({ element }) => element));
    focused?.button.focus();
  }

  /** Marks the card whose shape the step shows, and returns it. */
  mark({ step, family, betti }: StepSummary): PlateauCard | undefined {
    let shown: PlateauCard | undefined;
    for (const { card, button } of this.items) {
      const within = card.firstStep <= step && step <= card.lastStep;
      const here = within && card.family === family && card.betti.join() === betti.join();
      if (here) button.setAttribute('aria-current', 'step');
      else button.removeAttribute('aria-current');
      if (here) shown ??= card;
    }
    return shown;
  }

  private itemFor(card: PlateauCard): Item {
    const button = document.createElement('button');
    button.type = 'button';
    button.className = 'card';
    const element = document.createElement('li');
    element.append(button);
    const item: Item = { element, button, card };
    button.addEventListener('click', () => this.onChoose(item.card));
    return item;
  }
}

function write({ card, button }: Item): void {
  const { shape, counts, scale, family, torsion, note } = cardWords(card);
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
  button.replaceChildren(
    line('card-shape', shape),
    line('for-readers', ': '),
    line('card-counts', counts),
    ...(torsion ? [line('for-readers', ' · '), line('card-torsion', torsion)] : []),
    line('for-readers', ' · '),
    line('card-scale', `${scale} · ${family}`),
    ...(note ? [line('for-readers', ' · '), line('card-note', note)] : []),
  );
}
