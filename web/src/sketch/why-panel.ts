import { answerOf, NO_ANSWER, type Answer } from './answer.ts';
import { landmarksNamed, namesOf, parseAsked } from './names.ts';
import type { PlaneQuestion, Reason } from './plane.ts';
import { reasonInWords } from './sketch-words.ts';
import type { SketchParts } from './sketch-parts.ts';

/** Corners at most: what the plane has simplices of. */
const MOST_CORNERS = 3;

/** Why these landmarks span a simplex, or why not: the question in its field, the answer, and what it points at. */
export class WhyPanel {
  private said = '';
  private pointsAt = NO_ANSWER;
  private turn = 0;

  constructor(
    private readonly parts: SketchParts,
    private readonly why: (vertices: readonly number[], question: PlaneQuestion) => Promise<Reason>,
    ask: (names: readonly string[]) => void,
    private readonly changed: () => void,
    private readonly fail: (error: unknown) => void,
  ) {
    parts.why.addEventListener('submit', (event) => {
      event.preventDefault();
      const typed = parts.corners.value;
      try {
        ask(parseAsked(typed));
      } catch (error) {
        ask([]);
        parts.corners.value = typed;
        this.say(error instanceof Error ? error.message : String(error), NO_ANSWER);
      }
    });
  }

  get answer(): Answer {
    return this.pointsAt;
  }

  /** What is asked for stands in the field, whoever asked. */
  show(asked: readonly string[]): void {
    this.parts.corners.value = asked.join(' ');
  }

  /** Answers, now that the question or the points are these. */
  async tell(asked: readonly string[], question: PlaneQuestion): Promise<void> {
    const turn = ++this.turn;
    if (asked.length === 0) return this.say('', NO_ANSWER);
    const vertices = landmarksNamed(asked, question);
    if (vertices.length < asked.length || asked.length > MOST_CORNERS) {
      const own = question.landmarks.length - (question.extra === undefined ? 0 : 1);
      const more = question.extra === undefined ? '' : ', or a';
      return this.say(`Name one to three landmarks from 1 to ${own}${more}.`, NO_ANSWER);
    }
    try {
      const reason = await this.why(vertices, question);
      if (turn !== this.turn) return;
      this.say(reasonInWords(vertices, reason, namesOf(question)), answerOf(vertices, reason));
    } catch (error) {
      if (turn === this.turn) this.fail(error);
    }
  }

  private say(sentence: string, answer: Answer): void {
    this.pointsAt = answer;
    if (sentence !== this.said) this.parts.answer.textContent = this.said = sentence;
    this.changed();
  }
}
