import type { Section, ShapeView } from '../view/shape-view.ts';
import type { CloudFrame } from '../worker/protocol.ts';
import { DimensionTools } from './dimension-tools.ts';
import { byId } from './dom.ts';
import { ScaleBar } from './scale-bar.ts';

const LAYERS = ['witnesses', 'landmarks', 'edges', 'faces'] as const;

/** What is drawn, how it is colored, where it is cut, and how large it is. */
export class ViewTools {
  private readonly boxes = LAYERS.map((layer) => byId(`layer-${layer}`, HTMLInputElement));
  private readonly colorBy = byId('color-by', HTMLSelectElement);
  private readonly section = byId('section', HTMLInputElement);
  private readonly axis = byId('section-axis', HTMLSelectElement);
  private readonly place = byId('section-place', HTMLInputElement);
  private readonly scaleBar = new ScaleBar(
    byId('scale-bar', HTMLElement),
    byId('scale-length', HTMLElement),
    byId('scale-text', HTMLElement),
  );
  private readonly dimensions = new DimensionTools();
  private shape: ShapeView | undefined;
  private beside: ShapeView | undefined;
  /** Called after each drawing: for what lies over the shape. */
  onDrawn: () => void = () => undefined;

  constructor() {
    const form = byId('tools', HTMLFormElement);
    form.addEventListener('submit', (event) => event.preventDefault());
    form.addEventListener('input', () => this.apply());
  }

  /** The view that the tools act on; there is none without WebGL. */
  attach(shape: ShapeView | undefined): void {
    this.shape = shape;
    this.dimensions.attach(shape);
    byId('tools', HTMLElement).hidden = !shape;
    this.apply();
  }

  /** A second shape is drawn as the first is; `alike`: its dimensions are those of the first. */
  attachBeside(shape: ShapeView | undefined, alike: boolean): void {
    this.beside = shape;
    this.dimensions.attachBeside(alike ? shape : undefined);
    this.apply();
  }

  /** Another cloud. */
  show(frame: CloudFrame): void {
    this.dimensions.show(frame);
  }

  toggleTurning(): void {
    this.dimensions.toggleTurning();
  }

  /** `index` as in the row of boxes, from 0. */
  toggleLayer(index: number): void {
    this.boxes[index]?.click();
  }

  toggleColor(): void {
    this.colorBy.value = this.colorBy.value === 'age' ? 'plateau' : 'age';
    this.apply();
  }

  toggleSection(): void {
    this.section.click();
  }

  /** Told after each drawing. */
  readonly showScale = (unitsPerPixel: number): void => {
    this.onDrawn();
    this.scaleBar.show(unitsPerPixel);
  };

  private apply(): void {
    const [witnesses = true, landmarks = true, edges = true, faces = true] = this.boxes.map(
      ({ checked }) => checked,
    );
    const byAge = this.colorBy.value === 'age';
    byId('age-key', HTMLElement).hidden = !byAge;
    byId('section-controls', HTMLElement).hidden = !this.section.checked;
    for (const shape of [this.shape, this.beside]) {
      shape?.setLayers({ witnesses, landmarks, edges, faces });
      shape?.colorByAge(byAge);
      shape?.cutAt(this.section.checked ? this.sectionAsked() : undefined);
    }
  }

  private sectionAsked(): Section {
    const axis = this.axis.value === '0' ? 0 : this.axis.value === '1' ? 1 : 2;
    return { axis, place: this.place.valueAsNumber };
  }
}
