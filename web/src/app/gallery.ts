import type { PlateauClient } from '../client/plateau-client.ts';
import { previewOf } from '../view/cloud-preview.ts';
import { byId } from './dom.ts';
import { SAMPLES, type Sample } from './samples.ts';
import { cloudSource } from './source.ts';

interface PreviewPoints {
  readonly coordinates: Float64Array | Float32Array;
  readonly dimension: number;
}

/** All shapes with a picture made of their own points; the pictures are drawn when they are first asked for. */
export class Gallery {
  private readonly dialog = byId('gallery', HTMLDialogElement);
  private readonly canvases = new Map<Sample, HTMLCanvasElement>();
  private readonly clouds = new Map<Sample, PreviewPoints>();

  constructor(
    private readonly client: PlateauClient,
    onChoose: (sample: Sample) => void,
  ) {
    byId('shapes', HTMLElement).append(
      ...SAMPLES.map((sample) => {
        const item = document.createElement('li');
        item.append(
          this.buttonFor(sample, () => {
            this.dialog.close();
            onChoose(sample);
          }),
        );
        return item;
      }),
    );
  }

  open(): void {
    this.dialog.showModal();
    void this.drawAll();
  }

  private buttonFor(sample: Sample, choose: () => void): HTMLButtonElement {
    const button = document.createElement('button');
    button.type = 'button';
    button.className = 'shape-card';
    button.dataset['shape'] = sample.shape;
    const canvas = document.createElement('canvas');
    canvas.setAttribute('aria-hidden', 'true');
    this.canvases.set(sample, canvas);
    const line = (className: string, text: string): HTMLElement => {
      const span = document.createElement('span');
      span.className = className;
      span.textContent = text;
      return span;
    };
    button.append(
      canvas,
      line('card-shape', sample.label),
      line('card-counts', sample.lookFor),
      line('card-scale', `${sample.provenance} · ${sample.size.toLocaleString('en')}\u00a0points`),
    );
    button.addEventListener('click', choose);
    return button;
  }

  /** One after another, in the order of the list; again at every opening, for light and dark differ. */
  private async drawAll(): Promise<void> {
    for (const [sample, canvas] of this.canvases) {
      if (!this.dialog.open) return;
      try {
        const cloud = this.clouds.get(sample) ?? (await this.pointsOf(sample));
        this.clouds.set(sample, cloud);
        previewOf(canvas, cloud.coordinates, cloud.dimension);
        canvas.dataset['drawn'] = 'true';
      } catch {
        // Without its picture the shape can be chosen all the same, and says then what is wrong.
      }
    }
  }

  /** The points as a run is given them; the run itself is not wanted. */
  private async pointsOf({ shape, preview, options }: Sample): Promise<PreviewPoints> {
    const source = await cloudSource({ kind: 'sample', shape, size: preview });
    const run = await this.client.open(source, { ...options, maxSteps: 1 });
    run.close().catch(() => undefined);
    const { coordinates, dimension, projection } = run.opened;
    return projection
      ? { coordinates: projection.coordinates, dimension: projection.axes }
      : { coordinates, dimension };
  }
}
