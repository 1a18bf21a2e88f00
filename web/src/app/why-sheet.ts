import { picked, stepsOf } from '../model/picking.ts';
import { WhyMarks, type Marked } from '../view/why-marks.ts';
import type { Inspection } from '../worker/inspection.ts';
import { byId } from './dom.ts';
import { parseList } from './entries.ts';
import type { Page } from './page.ts';

/** A pointer that moved further has turned the shape. */
const STILL = 4;
/** While the playhead moves the answer waits until it stands. */
const SETTLED_MS = 150;

/** Why the landmarks that are named or clicked span a simplex at the step shown, or why not; and who sees it. */
export class WhySheet {
  private readonly dialog = byId('why', HTMLDialogElement);
  private readonly field = byId('why-landmarks', HTMLInputElement);
  private readonly adds = byId('why-add', HTMLInputElement);
  private readonly answer = byId('why-answer', HTMLElement);
  private readonly button = byId('open-why', HTMLButtonElement);
  private readonly shape = byId('shape', HTMLElement);
  private readonly marks = new WhyMarks(this.shape);
  private marked: Marked | undefined;
  private pressed: { readonly x: number; readonly y: number } | undefined;
  private asked = 0;
  private settling: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly page: Page) {
    this.button.addEventListener('click', () => this.toggle());
    byId('close-why', HTMLButtonElement).addEventListener('click', () => this.close());
    byId('why-form', HTMLFormElement).addEventListener('submit', (event) => {
      event.preventDefault();
      void this.ask();
    });
    this.dialog.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape') return;
      event.preventDefault();
      this.close();
    });
    this.shape.addEventListener('pointerdown', ({ clientX, clientY, button }) => {
      this.pressed = button === 0 ? { x: clientX, y: clientY } : undefined;
    });
    // Captured: the shape's own controls keep the pointer to themselves.
    this.shape.addEventListener('pointerup', (event) => this.released(event), { capture: true });
    page.tools.onDrawn = () => this.drawMarks();
    new MutationObserver(() => this.moved()).observe(byId('plateau', HTMLElement), {
      attributeFilter: ['data-step', 'data-source', 'data-hash'],
    });
  }

  toggle(): void {
    if (this.dialog.open) this.close();
    else this.open();
  }

  private open(): void {
    if (!this.page.record) return;
    // Something to begin with: the newest landmark.
    if (this.field.value === '') this.field.value = String(Math.max(1, this.page.currentStep));
    this.show();
    this.field.focus();
    this.field.select();
    void this.ask();
  }

  private show(): void {
    if (!this.dialog.open) this.dialog.show();
    this.button.setAttribute('aria-expanded', 'true');
  }

  private close(): void {
    const hadFocus = this.dialog.contains(document.activeElement);
    this.dialog.close();
    this.button.setAttribute('aria-expanded', 'false');
    this.adds.checked = false;
    this.mark(undefined);
    if (hadFocus) this.button.focus();
  }

  private released({ clientX, clientY, shiftKey }: PointerEvent): void {
    const { pressed, page } = this;
    this.pressed = undefined;
    const { record, currentStep } = page;
    const placeOf = page.shape?.projector;
    if (!pressed || !record || currentStep < 1 || !placeOf) return;
    if (Math.hypot(clientX - pressed.x, clientY - pressed.y) > STILL) return;
    const { left, top } = this.shape.getBoundingClientRect();
    const steps = stepsOf(record, picked(record, currentStep, clientX - left, clientY - top, placeOf));
    if (steps.length === 0) return;
    // A finger has no shift key.
    const adding = this.dialog.open && (shiftKey || this.adds.checked);
    this.field.value = (adding ? this.toggled(steps) : steps).join(', ');
    this.show();
    void this.ask();
  }

  /** One more landmark or one less; of what was clicked before nothing is lost. */
  private toggled(steps: readonly number[]): readonly number[] {
    const before = this.field.value.split(',').map(Number).filter(Boolean);
    const [only] = steps;
    if (steps.length === 1 && only !== undefined && before.includes(only)) {
      return before.filter((step) => step !== only);
    }
    return [...new Set([...before, ...steps])].sort((a, b) => a - b);
  }

  /** Another step, another run: the same question is asked again once it stands. */
  private moved(): void {
    if (!this.dialog.open) return;
    clearTimeout(this.settling);
    this.settling = setTimeout(() => void this.ask(), SETTLED_MS);
  }

  private async ask(): Promise<void> {
    const { run, record, currentStep } = this.page;
    if (!run || !record || !this.dialog.open) return;
    const question = ++this.asked;
    try {
      const vertices = parseList(this.field.value, 1, 'Landmarks');
      const inspection = await run.inspect(Math.max(1, currentStep), vertices);
      if (question !== this.asked || !this.dialog.open) return;
      this.say(inspection.text);
      this.mark(this.markedBy(inspection));
    } catch (error) {
      if (question !== this.asked) return;
      this.say(error instanceof Error ? error.message : String(error));
      this.mark(undefined);
    }
  }

  private markedBy({ simplex, verdict, witnesses, best, blockers }: Inspection): Marked {
    const { record } = this.page;
    const landmarks = (steps: Uint32Array): number[] =>
      [...steps]
        .filter((step) => record && step <= record.stepCount)
        .map((step) => record?.landmark(step) ?? 0);
    return {
      asked: landmarks(simplex),
      present: verdict === 'present',
      witnesses: [...witnesses],
      missed: verdict === 'notWitnessed' && best ? [best.witness] : [],
      blockers: landmarks(blockers),
    };
  }

  private say(text: string): void {
    if (this.answer.textContent !== text) this.answer.textContent = text;
  }

  private mark(marked: Marked | undefined): void {
    this.marked = marked;
    this.drawMarks();
  }

  private drawMarks(): void {
    this.marks.draw(this.marked, this.page.shape?.projector);
  }
}
