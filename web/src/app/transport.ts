import { readable } from '../model/numbers.ts';
import type { StepSummary } from '../model/record.ts';
import { byId } from './dom.ts';

export interface TransportActions {
  togglePlay(): void;
  move(steps: number): void;
  goTo(step: number): void;
}

/** Back, Play or Pause, Step, and the slider. */
export class Transport {
  private readonly play = byId('play', HTMLButtonElement);
  private readonly label = byId('play-label', HTMLElement);
  private readonly slider = byId('step', HTMLInputElement);

  constructor(actions: TransportActions) {
    this.play.addEventListener('click', () => actions.togglePlay());
    byId('back', HTMLButtonElement).addEventListener('click', () => actions.move(-1));
    byId('forward', HTMLButtonElement).addEventListener('click', () => actions.move(1));
    this.slider.addEventListener('input', () => actions.goTo(this.slider.valueAsNumber));
  }

  setPlaying(playing: boolean): void {
    this.label.textContent = playing ? 'Pause' : 'Play';
    this.play.classList.toggle('playing', playing);
  }

  setSteps(count: number): void {
    this.slider.max = String(Math.max(1, count));
  }

  showStep({ step, epsilon }: StepSummary): void {
    this.slider.value = String(step);
    this.slider.setAttribute('aria-valuetext', `step ${step}, ε ${readable(epsilon)}`);
  }
}
