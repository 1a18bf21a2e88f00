import { readable } from '../model/numbers.ts';
import type { Section, ShapeView } from '../view/shape-view.ts';
import type { CloudFrame } from '../worker/protocol.ts';
import { DimensionTools } from './dimension-tools.ts';
import { byId } from './dom.ts';

const LAYERS = ['witnesses', 'landmarks', 'edges', 'faces'] as const;
/** The scale bar is the longest 1, 2 or 5 that is no wider. */
const BAR_PIXELS = 120;

/** What is drawn, how it is colored, where it is cut, and how large it is. */
export class ViewTools {
  private readonly boxes = LAYERS.map((layer) => byId(`layer-${layer}`, HTMLInputElement));
  private readonly colorBy = byId('color-by', HTMLSelectElement);
  private readonly section = byId('section', HTMLInputElement);
  private readonly axis = byId('section-axis', HTMLSelectElement);
  private readonly place = byId('section-place', HTMLInputElement);
  private readonly bar = byId('scale-bar', HTMLElement);
  private readonly barLength = byId('scale-length', HTMLElement);
  private readonly barText = byId('scale-text', HTMLElement);
  private readonly dimensions = new DimensionTools();
  private shape: ShapeView | undefined;
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
    const most = BAR_PIXELS * unitsPerPixel;
    const decade = 10 ** Math.floor(Math.log10(most));
    const length = decade * ([5, 2].find((factor) => factor * decade <= most) ?? 1);
    this.bar.hidden = false;
    this.barLength.style.width = `${length / unitsPerPixel}px`;
    const amount = readable(length)
      .replace(/(\.\d*?)0+$/, '$1')
      .replace(/\.$/, '');
    const text = `${amount} ${length === 1 ? 'unit' : 'units'}`;
    if (this.barText.textContent !== text) this.barText.textContent = text;
  };

  private apply(): void {
    const [witnesses = true, landmarks = true, edges = true, faces = true] = this.boxes.map(
      ({ checked }) => checked,
    );
    const byAge = this.colorBy.value === 'age';
    byId('age-key', HTMLElement).hidden = !byAge;
    byId('section-controls', HTMLElement).hidden = !this.section.checked;
    this.shape?.setLayers({ witnesses, landmarks, edges, faces });
    this.shape?.colorByAge(byAge);
    this.shape?.cutAt(this.section.checked ? this.sectionAsked() : undefined);
  }

  private sectionAsked(): Section {
    const axis = this.axis.value === '0' ? 0 : this.axis.value === '1' ? 1 : 2;
    return { axis, place: this.place.valueAsNumber };
  }
}
