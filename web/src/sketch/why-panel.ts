import type { Reason } from './plane.ts';
import { reasonInWords } from './sketch-words.ts';
import type { SketchParts } from './sketch-parts.ts';

/** Corners at most: what the plane has simplices of. */
const MOST_CORNERS = 3;

/** Why these landmarks span a simplex, or why not: the corners that are asked for, the answer, and who lights up. */
export class WhyPanel {
  private corners: readonly number[] = [];
  private said = '';
  private shining: readonly number[] = [];

  constructor(
    private readonly parts: SketchParts,
    private readonly why: (vertices: readonly number[]) => Promise<Reason>,
    private readonly landmarkCount: () => number,
    private readonly changed: () => void,
    private readonly fail: (error: unknown) => void,
  ) {
    parts.why.addEventListener('submit', (event) => {
      event.preventDefault();
      const names = parts.corners.value.split(/[^\d]+/).filter((entry) => entry !== '');
      this.inspect(names.map((name) => Number(name) - 1));
    });
  }

  get picked(): readonly number[] {
    return this.corners;
  }

  /** Its witnesses, or the one that came closest. */
  get lit(): readonly number[] {
    return this.shining;
  }

  inspect(vertices: readonly number[]): void {
    this.corners = [...new Set(vertices)].sort((a, b) => a - b);
    this.parts.corners.value = this.corners.map((index) => index + 1).join(' ');
    void this.tell();
  }

  /** In, or out again. */
  toggle(index: number): void {
    const { corners } = this;
    this.inspect(corners.includes(index) ? corners.filter((other) => other !== index) : [...corners, index]);
  }

  /** The points have changed: the answer may be another. */
  follow(): void {
    if (this.corners.length > 0) void this.tell();
  }

  private async tell(): Promise<void> {
    const { corners } = this;
    const known = this.landmarkCount();
    if (corners.length === 0) {
      this.say('', []);
      return;
    }
    if (corners.some((index) => index < 0 || index >= known) || corners.length > MOST_CORNERS) {
      this.say(`Name one to three landmarks from 1 to ${known}.`, []);
      return;
    }
    try {
      const reason = await this.why(corners);
      if (corners !== this.corners) return;
      const nearest = reason.kind === 'no-witness' && reason.closest !== undefined ? [reason.closest] : [];
      this.say(reasonInWords(corners, reason), reason.kind === 'present' ? reason.witnesses : nearest);
    } catch (error) {
      this.fail(error);
    }
  }

  private say(sentence: string, lit: readonly number[]): void {
    this.shining = lit;
    if (sentence !== this.said) this.parts.answer.textContent = this.said = sentence;
    this.changed();
  }
}
