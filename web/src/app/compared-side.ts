import { memoryInWords } from '../model/forecast.ts';
import { grouped } from '../model/numbers.ts';
import type { PlateauCard } from '../model/plateau-cards.ts';
import type { RunRecord } from '../model/record.ts';
import { scaleOf, stepAt } from '../model/scale-axis.ts';
import { Announcer } from './announcer.ts';
import type { Letter, SideParts } from './comparison-parts.ts';
import type { ShownRun } from './earlier-run.ts';
import { make } from './make.ts';
import { RunScreen } from './run-screen.ts';
import { sourceName } from './source.ts';
import { heldTogether, stepInWords } from './status-line.ts';

/** Where one playhead stands for all runs: at a place of ln(1/ε). */
export interface Place {
  readonly scale: number;
  /** Where it was a moment ago, while the film plays: between two places, nearer to the second by `part`. */
  readonly recent: readonly [from: number, to: number, part: number];
}

/** A place that was come to by hand. */
export function standingAt(scale: number): Place {
  return { scale, recent: [scale, scale, 0] };
}

/** One of two runs that are compared: it shows the step that it has at the place of the playhead. */
export class ComparedSide {
  readonly screen: RunScreen;
  private readonly announcer: Announcer;
  private shownCards: readonly PlateauCard[] = [];

  constructor(
    readonly letter: Letter,
    readonly parts: SideParts,
    readonly run: ShownRun,
    timeline: HTMLElement,
    goTo: (scale: number) => void,
  ) {
    const { record, choice, opened } = run;
    this.screen = new RunScreen(
      { ...parts, state: parts.head, timeline },
      {
        scrub: (_, scale) => goTo(scale),
        choose: (card) => {
          goTo(placeOf(record, card));
          this.screen.shape?.frameAll();
        },
      },
    );
    this.announcer = new Announcer(parts.spoken, `Plateau of run ${letter}`);
    const name = sourceName(choice);
    parts.name.textContent = `${name} · ${grouped(opened.points)} points`;
    parts.cardsOf.textContent = name;
    this.screen.setRecord(record);
    this.showCards(run.cards);
    this.showSettings();
  }

  get record(): RunRecord {
    return this.run.record;
  }

  get cards(): readonly PlateauCard[] {
    return this.shownCards;
  }

  /** Where its cards lie along the film. */
  get cardPlaces(): readonly number[] {
    return this.shownCards.map((card) => placeOf(this.record, card));
  }

  showCards(cards: readonly PlateauCard[]): void {
    this.shownCards = cards;
    this.screen.showCards(cards);
  }

  /** The record has grown. Returns whether it is time for a picture. */
  grown(): boolean {
    if (!this.screen.grown()) return false;
    this.showSettings();
    return true;
  }

  showAt({ scale, recent: [from, to, part] }: Place): void {
    const { record } = this;
    if (record.stepCount === 0) return;
    const [before, after] = [stepAt(record, from), stepAt(record, to)];
    const recent = before + (after - before) * part;
    const { summary, card } = this.screen.showStep(record, stepAt(record, scale), recent, scale);
    this.parts.readout.textContent = heldTogether(stepInWords(record, summary));
    this.announcer.at(card);
  }

  /** "A: step 5 of 300 · ε 0.3 · …". */
  get words(): string {
    const { currentStep } = this.screen;
    const at = currentStep > 0 ? this.record.summary(currentStep) : undefined;
    return `${this.letter}: ${stepInWords(this.record, at)}`;
  }

  private showSettings(): void {
    const memory = memoryInWords(this.record.memoryBytes);
    const more = make('span', { class: 'spare' }, ' in use');
    this.parts.settings.replaceChildren(`${settingsInWords(this.run)} · ${memory}`, more);
  }
}

/** "automatic family · ν 1, 6, 6, 4 · first landmark 0". */
function settingsInWords({ opened: { family, nu }, options: { first, dilation } }: ShownRun): string {
  const followed = family === 'auto' ? 'automatic family' : `family ${family}`;
  const reach = family === 'dilated' ? `dilation ${dilation ?? 0.2}` : `ν ${nu.join(', ')}`;
  return `${followed} · ${reach} · first landmark ${first ?? 0}`;
}

/** Where the middle of a plateau lies; a step whose ε is 0 has no other place than its own. */
function placeOf(record: RunRecord, { middleStep }: PlateauCard): number {
  return scaleOf(record, Math.min(middleStep, record.stepCount));
}
