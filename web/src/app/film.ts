import { Afterglow } from '../model/afterglow.ts';
import { Playback } from '../model/playback.ts';
import type { Scales } from '../model/scale-axis.ts';

/** The longest that a frame counts for: a tab that was hidden does not leap. */
const LONGEST_FRAME_MS = 250;

/** What the film runs along: it waits at the last step, and ends there if no more will come. */
export interface FilmTrack extends Scales {
  readonly ended: boolean;
}

/** What the film moves. */
export interface FilmScreen {
  readonly record: FilmTrack | undefined;
  readonly currentStep: number;
  /** Shows a step; what was born or died since `recent` glows or fades. */
  showFrame(step: number, recent: number): void;
  playingChanged(playing: boolean): void;
}

/** Moves the playhead with the time, until the end of what will be computed. */
export class Film {
  private readonly playback = new Playback();
  private readonly afterglow = new Afterglow();
  /** Visitors who asked for less motion see no glow. */
  private readonly calm = matchMedia('(prefers-reduced-motion: reduce)');
  private frameRequest = 0;
  playing = false;

  constructor(private readonly screen: FilmScreen) {}

  set speed(factor: number) {
    this.playback.speed = factor;
  }

  play(): void {
    if (this.playing) return;
    this.playing = true;
    this.playback.restart();
    this.afterglow.restart(this.screen.currentStep);
    this.screen.playingChanged(true);
    let before = performance.now();
    const frame = (now: number): void => {
      const elapsed = Math.min(LONGEST_FRAME_MS, Math.max(0, now - before));
      before = now;
      this.advance(elapsed);
      if (this.playing) this.frameRequest = requestAnimationFrame(frame);
    };
    this.frameRequest = requestAnimationFrame(frame);
  }

  pause(): void {
    if (!this.playing) return;
    this.playing = false;
    cancelAnimationFrame(this.frameRequest);
    this.screen.playingChanged(false);
  }

  private advance(elapsedMs: number): void {
    const { record, currentStep } = this.screen;
    if (!record) return;
    const next = this.playback.advance(record, currentStep, elapsedMs);
    const recent = this.calm.matches ? next : this.afterglow.follow(next, elapsedMs);
    this.screen.showFrame(next, recent);
    if (record.ended && next >= record.stepCount && recent === next) this.pause();
  }
}
