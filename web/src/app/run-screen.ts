import type { PlateauCard } from '../model/plateau-cards.ts';
import type { RunRecord, StepSummary } from '../model/record.ts';
import { DiagramView } from '../view/diagram-view.ts';
import type { ShapeView } from '../view/shape-view.ts';
import { CardList } from './card-list.ts';

/** While a run grows: the computation needs the time between two pictures. */
const PICTURES_EVERY_MS = 120;

/** Where a run is shown. */
export interface ScreenParts {
  /** Carries the state as data, for style sheets and tests. */
  readonly state: HTMLElement;
  readonly diagram: HTMLElement;
  readonly timeline: HTMLElement;
  readonly cards: HTMLElement;
  readonly noCards: HTMLElement;
}

/** What the visitor does on it. */
export interface ScreenActions {
  /** Along the diagram, to a place; `step` has begun there. */
  scrub(step: number, scale: number): void;
  choose(card: PlateauCard): void;
}

/**
 * One run as it is seen: its shape, its diagram and its plateaus, at a step. It has no playhead of its own, so there
 * can be several that follow one.
 */
export class RunScreen {
  /** None without WebGL, or while nobody looks. */
  shape: ShapeView | undefined;
  readonly diagram: DiagramView;
  private readonly cardList: CardList;
  private readonly dataset: DOMStringMap;
  private record: RunRecord | undefined;
  private step = 0;
  private picturesDue = 0;

  constructor({ state, diagram, timeline, cards, noCards }: ScreenParts, actions: ScreenActions) {
    this.dataset = state.dataset;
    this.diagram = new DiagramView(diagram, timeline, (step, scale) => actions.scrub(step, scale));
    this.cardList = new CardList(cards, noCards, (card) => actions.choose(card));
  }

  /** 0 before the first. */
  get currentStep(): number {
    return this.step;
  }

  /** Another run from its beginning. */
  setRecord(record: RunRecord): void {
    this.record = record;
    this.step = 0;
    this.picturesDue = 0;
    this.shape?.setRecord(record);
    this.diagram.setRecord(record, []);
    this.cardList.show([], false);
    this.showState();
  }

  /** The record has grown. Returns whether it is time for a picture. */
  grown(): boolean {
    const { record } = this;
    if (!record) return false;
    this.showState();
    const first = this.step === 0 && record.stepCount > 0;
    if (!record.ended && !first && performance.now() < this.picturesDue) return false;
    this.picturesDue = performance.now() + PICTURES_EVERY_MS;
    this.shape?.sync();
    this.diagram.requestPaint();
    return true;
  }

  /** Returns the card of what is shown, if there is one. */
  showCards(cards: readonly PlateauCard[]): PlateauCard | undefined {
    const { record } = this;
    if (!record) return undefined;
    this.diagram.setCards(cards);
    this.cardList.show(cards, record.ended);
    return this.step > 0 ? this.cardList.mark(record.summary(this.step)) : undefined;
  }

  /** `recent`: the step of a moment ago, while the film plays; `scale`: where the playhead stands, if not at the step. */
  showStep(
    record: RunRecord,
    step: number,
    recent: number,
    scale?: number,
  ): { summary: StepSummary; card: PlateauCard | undefined } {
    this.step = step;
    const summary = record.summary(step);
    this.shape?.showStep(step, recent);
    this.diagram.showStep(step, scale);
    this.dataset['step'] = String(step);
    this.dataset['epsilon'] = String(summary.epsilon);
    this.dataset['family'] = summary.family;
    this.dataset['betti'] = summary.betti.join(',');
    return { summary, card: this.cardList.mark(summary) };
  }

  applyTheme(): void {
    this.shape?.applyTheme();
    this.diagram.requestPaint();
  }

  private showState(): void {
    this.dataset['runState'] = this.record?.state ?? 'empty';
    this.dataset['steps'] = String(this.record?.stepCount ?? 0);
    this.dataset['hash'] = this.record?.hash ?? '';
  }
}
