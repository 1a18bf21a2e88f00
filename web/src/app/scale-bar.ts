import { readable } from '../model/numbers.ts';

/** The bar is the longest 1, 2 or 5 that is no wider. */
const BAR_PIXELS = 120;

/** How large the shape is, in the units of its points. */
export class ScaleBar {
  constructor(
    private readonly bar: HTMLElement,
    private readonly length: HTMLElement,
    private readonly text: HTMLElement,
  ) {}

  /** Told after each drawing. */
  readonly show = (unitsPerPixel: number): void => {
    const most = BAR_PIXELS * unitsPerPixel;
    const decade = 10 ** Math.floor(Math.log10(most));
    const length = decade * ([5, 2].find((factor) => factor * decade <= most) ?? 1);
    this.bar.hidden = false;
    this.length.style.width = `${length / unitsPerPixel}px`;
    const amount = readable(length)
      .replace(/(\.\d*?)0+$/, '$1')
      .replace(/\.$/, '');
    const text = `${amount} ${length === 1 ? 'unit' : 'units'}`;
    if (this.text.textContent !== text) this.text.textContent = text;
  };
}
