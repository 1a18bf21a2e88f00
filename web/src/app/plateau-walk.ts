import { readable } from '../model/numbers.ts';
import { cardName, type PlateauCard } from '../model/plateau-cards.ts';
import type { RunRecord } from '../model/record.ts';
import type { Announcer } from './announcer.ts';
import { byId, setNotice } from './dom.ts';

/** In a run that stops at no length of its own: ε falls to six tenths. */
const SIGNIFICANT = 0.5;

/** The core compares ratios, and lengths are their logarithms. */
const ROUNDING = 1e-9;

/** What the walk moves. */
export interface WalkScreen {
  readonly record: RunRecord | undefined;
  readonly currentStep: number;
  readonly currentCards: readonly PlateauCard[];
  goTo(step: number): void;
  /** The playhead follows the computation; one that ended at a plateau goes on. */
  seek(): void;
}

/** From plateau to plateau: along those that are computed, and on to those that are not yet. */
export class PlateauWalk {
  private readonly words = byId('walk-words', HTMLElement);
  private readonly button = byId('next-significant', HTMLButtonElement);
  /** Those that lay behind when the next one was asked for. */
  private passed: ReadonlySet<string> = new Set();

  constructor(
    private readonly screen: WalkScreen,
    private readonly announcer: Announcer,
  ) {
    this.button.addEventListener('click', () => this.nextSignificant());
  }

  /** The playhead goes another way, or there is another run. */
  leave(): void {
    this.button.disabled = false;
    if (!this.words.hidden) this.write('');
  }

  /** The next plateau along the film, the first one after the last. */
  next(): void {
    const along = this.screen.currentCards.map((card) => card.middleStep).sort((a, b) => a - b);
    const next = along.find((step) => step > this.screen.currentStep) ?? along[0];
    if (next !== undefined) this.screen.goTo(next);
  }

  /** The next one that is long enough; where it is not computed, the computation is followed to it. */
  nextSignificant(): void {
    const { record, currentStep } = this.screen;
    if (!record) return;
    const behind = this.significant.filter(({ firstStep }) => firstStep <= currentStep);
    this.passed = new Set(behind.map(cardName));
    if (this.look()) return;
    if (record.ended && !record.endedAtPlateau) {
      this.sayNone(record);
      return;
    }
    this.write(`Computing on to the next plateau of length ${readable(this.least)} or more …`);
    this.screen.seek();
  }

  /** Goes to the plateau that was asked for, if it is found by now. */
  look(): boolean {
    const found = this.significant
      .filter((card) => !this.passed.has(cardName(card)))
      .sort((a, b) => a.firstStep - b.firstStep)[0];
    if (!found) return false;
    this.screen.goTo(found.middleStep);
    this.announcer.tell(found);
    return true;
  }

  /** The run has ended while the next one was looked for. */
  ended(): void {
    const { record } = this.screen;
    if (!record) return;
    const isKnown = (card: PlateauCard): boolean => card.lastStep + 1 >= record.stepCount;
    // Equal plateaus with a short interruption are one card: the next of them is no new answer.
    if (record.endedAtPlateau && this.significant.some(isKnown)) {
      this.screen.seek();
      return;
    }
    this.screen.goTo(this.screen.currentStep);
    if (!record.endedAtPlateau) this.sayNone(record);
  }

  private get least(): number {
    return this.screen.record?.minLength || SIGNIFICANT;
  }

  private get significant(): PlateauCard[] {
    return this.screen.currentCards.filter(({ length }) => length >= this.least - ROUNDING);
  }

  private sayNone({ state }: RunRecord): void {
    const end = state === 'stopped' ? 'the run was stopped' : 'the run has come to its end';
    this.write(`No further plateau of length ${readable(this.least)} or more: ${end}.`);
  }

  private write(words: string): void {
    setNotice(this.words, words);
    this.announcer.say(words);
  }
}
