import { readable } from '../model/numbers.ts';
import type { StepSummary } from '../model/record.ts';
import { byId } from './dom.ts';

export interface TransportActions {
  togglePlay(): void;
  move(steps: number): void;
  goTo(step: number): void;
}

export interface TransportParts {
  readonly play: HTMLButtonElement;
  /** The word on it. */
  readonly label: HTMLElement;
  readonly back: HTMLButtonElement;
  readonly forward: HTMLButtonElement;
  readonly slider: HTMLInputElement;
}

/** That of the page. */
export function pageTransport(actions: TransportActions): Transport {
  return new Transport(actions, {
    play: byId('play', HTMLButtonElement),
    label: byId('play-label', HTMLElement),
    back: byId('back', HTMLButtonElement),
    forward: byId('forward', HTMLButtonElement),
    slider: byId('step', HTMLInputElement),
  });
}

/** Back, Play or Pause, Step, and the slider. */
export class Transport {
  private readonly play: HTMLButtonElement;
  private readonly label: HTMLElement;
  private readonly slider: HTMLInputElement;

  constructor(actions: TransportActions, { play, label, back, forward, slider }: TransportParts) {
    this.play = play;
    this.label = label;
    this.slider = slider;
    play.addEventListener('click', () => actions.togglePlay());
    back.addEventListener('click', () => actions.move(-1));
    forward.addEventListener('click', () => actions.move(1));
    slider.addEventListener('input', () => actions.goTo(slider.valueAsNumber));
  }

  setPlaying(playing: boolean): void {
    this.label.textContent = playing ? 'Pause' : 'Play';
    this.play.classList.toggle('playing', playing);
  }

  setSteps(count: number): void {
    this.slider.max = String(Math.max(1, count));
  }

  showStep({ step, epsilon }: StepSummary): void {
    this.showPlace(step, `step ${step}, ε ${readable(epsilon)}`);
  }

  /** `words`: what the place means. */
  showPlace(place: number, words: string): void {
    this.slider.value = String(place);
    this.slider.setAttribute('aria-valuetext', words);
  }
}
