import type { ShapeView } from './shape-view.ts';

/** Two shapes that are turned as one, as long as they are linked. */
export class LinkedCameras {
  private on = false;
  private following = false;

  constructor(
    private readonly first: ShapeView,
    private readonly second: ShapeView,
  ) {
    first.controls.addEventListener('change', this.fromFirst);
    second.controls.addEventListener('change', this.fromSecond);
  }

  get linked(): boolean {
    return this.on;
  }

  /** Linked anew, the second looks from where the first does. */
  set linked(on: boolean) {
    this.on = on;
    this.fromFirst();
  }

  dispose(): void {
    this.first.controls.removeEventListener('change', this.fromFirst);
    this.second.controls.removeEventListener('change', this.fromSecond);
  }

  private readonly fromFirst = (): void => this.follow(this.first, this.second);
  private readonly fromSecond = (): void => this.follow(this.second, this.first);

  /** The one that follows says that it has moved, too. */
  private follow(leader: ShapeView, follower: ShapeView): void {
    if (!this.on || this.following) return;
    this.following = true;
    follower.pose = leader.pose;
    this.following = false;
  }
}
