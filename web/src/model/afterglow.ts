/** How slowly the past fades: after this time a step is three fifths gone. */
const FADE_MS = 320;
/** Nearer to the playhead than this share of a step nothing is seen to fade. */
const UNSEEN = 0.03;

/**
 * The step that the film showed a moment ago: it runs after the playhead. What was born or died in between still
 * glows or fades. Between steps too, so that a single new landmark fades smoothly.
 */
export class Afterglow {
  private behind = 0;

  /** The playhead was moved by hand: nothing fades. */
  restart(step: number): void {
    this.behind = step;
  }

  /** Where it is when `step` is shown, `passedMs` after the call before; `step` itself when all has faded. */
  follow(step: number, passedMs: number): number {
    const left = (step - this.behind) * Math.exp(-passedMs / FADE_MS);
    this.behind = left > UNSEEN ? step - left : step;
    return this.behind;
  }
}
