/** How often a picture under way is looked at. */
const LOOK_EVERY_MS = 8;

/**
 * Gives the graphics card one picture at a time. Pictures that pile up in front of a slow one would make the page wait
 * for all of them at once; so what is asked for meanwhile becomes one picture after the one under way.
 */
export class GpuPace {
  private fence: WebGLSync | null = null;
  private next: (() => void) | undefined;
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly context: WebGLRenderingContext | WebGL2RenderingContext) {}

  /** Calls `draw` now, or as soon as the card has nothing to do; only the last one waits. */
  whenFree(draw: () => void): void {
    if (!this.busy()) {
      draw();
      return;
    }
    this.next = draw;
    this.timer ??= setTimeout(this.look, LOOK_EVERY_MS);
  }

  /** A picture was handed over. */
  submitted(): void {
    const { context } = this;
    if (!(context instanceof WebGL2RenderingContext)) return;
    this.fence = context.fenceSync(context.SYNC_GPU_COMMANDS_COMPLETE, 0);
    context.flush();
  }

  /** Forgets what waits. */
  dispose(): void {
    clearTimeout(this.timer);
    this.timer = undefined;
    this.next = undefined;
    this.fence = null;
  }

  private readonly look = (): void => {
    this.timer = undefined;
    const { next } = this;
    if (!next) return;
    this.next = undefined;
    this.whenFree(next);
  };

  private busy(): boolean {
    const { context, fence } = this;
    if (!fence || !(context instanceof WebGL2RenderingContext)) return false;
    if (context.getSyncParameter(fence, context.SYNC_STATUS) === context.UNSIGNALED) return true;
    context.deleteSync(fence);
    this.fence = null;
    return false;
  }
}
