import { grouped, readable } from '../model/numbers.ts';
import type { RunRecord, StepSummary } from '../model/record.ts';
import { bettiInNumbers, torsionInNumbers } from '../model/words.ts';

const SPOKEN_EVERY_MS = 1_000;

/** "step 5 of 3,000 · ε 0.52 · β 1, 0, 0 · surface". */
export function stepInWords(record: RunRecord, at: StepSummary | undefined): string {
  const step = `step ${grouped(at?.step ?? 0)} of ${grouped(record.stepsPlanned)}`;
  if (!at) return `${step} · ε – · β –`;
  const torsion = at.torsion ? ` · ${torsionInNumbers(at.torsion)}` : '';
  return `${step} · ε ${readable(at.epsilon)} · ${bettiInNumbers(at.betti)}${torsion} · ${at.family}`;
}

/** A name and its number stay in one line. */
export function heldTogether(text: string): string {
  return text.replace(/(step|ε|β) /g, '$1\u00a0');
}

/**
 * The numbers of the playhead twice: for eyes at every frame, for screen readers at most once a second while the film
 * runs. They can be read there at any time, but they are spoken only when the visitor moved the playhead: of the film
 * the announcer tells plateaus.
 */
export class StatusLine {
  private spokenAt = -Infinity;

  constructor(
    private readonly readout: HTMLElement,
    private readonly status: HTMLElement,
  ) {}

  show(record: RunRecord, at: StepSummary | undefined, moving: boolean): void {
    const text = stepInWords(record, at);
    this.readout.textContent = heldTogether(text);
    this.say(text, moving);
  }

  /** For screen readers alone. */
  say(text: string, moving: boolean): void {
    this.status.setAttribute('aria-live', moving ? 'off' : 'polite');
    const now = performance.now();
    if (moving && now - this.spokenAt < SPOKEN_EVERY_MS) return;
    this.spokenAt = now;
    if (this.status.textContent !== text) this.status.textContent = text;
  }
}
