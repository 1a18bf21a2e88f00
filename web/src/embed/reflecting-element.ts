import { ATTRIBUTES, type AttributeName, type Panels, type Theme } from './settings.ts';
import { TellingElement } from './telling-element.ts';

/** Attributes as properties: what is written to one is found in the other. */
export class ReflectingElement extends TellingElement {
  /** One of the built-in shapes: `helix`, `torus`, `sphere` and others; '' for none. */
  get shape(): string {
    return this.text('shape');
  }
  set shape(name: string) {
    this.write('shape', name);
  }

  /** How many points of the shape; each has a usual number of its own. */
  get size(): number | undefined {
    return this.number('size');
  }
  set size(count: number | undefined) {
    this.write('size', count);
  }

  /** Radius of a ball in which each point of the shape is shaken, in its units. */
  get noise(): number | undefined {
    return this.number('noise');
  }
  set noise(radius: number | undefined) {
    this.write('noise', radius);
  }

  /** Another seed is another sample of the same shape; 1 unless given. */
  get seed(): number | undefined {
    return this.number('seed');
  }
  set seed(seed: number | undefined) {
    this.write('seed', seed);
  }

  /** Address of a file of points or of a session (.plateau), relative to the page; goes before `shape`. '' for none. */
  get src(): string {
    return this.text('src');
  }
  set src(address: string) {
    this.write('src', address);
  }

  /** Which columns of the file are the coordinates, from 1: "1,2,3"; a table of more than three needs them. */
  get columns(): string {
    return this.text('columns');
  }
  set columns(list: string) {
    this.write('columns', list);
  }

  /** Which complex is followed: `witness`, `delaunay`, `surface`, `auto` or `dilated`; '' as the points need it. */
  get family(): string {
    return this.text('family');
  }
  set family(name: string) {
    this.write('family', name);
  }

  /** ν of the witness complex, an entry a dimension: "1,6,6,4"; '' as the family needs it. */
  get nu(): string {
    return this.text('nu');
  }
  set nu(list: string) {
    this.write('nu', list);
  }

  /** How many landmarks the run takes at most; all points unless given. */
  get steps(): number | undefined {
    return this.number('steps');
  }
  set steps(count: number | undefined) {
    this.write('steps', count);
  }

  /** The step that is shown, as soon as it is computed; with `autoplay` the film begins there. */
  get step(): number | undefined {
    return this.number('step');
  }
  set step(step: number | undefined) {
    this.write('step', step);
  }

  /** Whose middle is shown, as soon as it is known: 1 is the longest plateau, which is shown unless something else is asked for. */
  get plateau(): number | undefined {
    return this.number('plateau');
  }
  set plateau(rank: number | undefined) {
    this.write('plateau', rank);
  }

  /** The film begins when the element comes into view, unless the visitor has asked for less motion. */
  get autoplay(): boolean {
    return this.hasAttribute('autoplay');
  }
  set autoplay(plays: boolean) {
    // Written once more it is asked for once more.
    if (plays) this.setAttribute('autoplay', '');
    else this.removeAttribute('autoplay');
  }

  /** What is shown; `both` unless given. */
  get panels(): Panels {
    const text = this.text('panels');
    return text === 'shape' || text === 'diagram' || text === 'full' ? text : 'both';
  }
  set panels(panels: Panels) {
    this.write('panels', panels);
  }

  /** Light or dark; as the visitor's system asks unless given. */
  get theme(): Theme {
    const text = this.text('theme');
    return text === 'light' || text === 'dark' ? text : 'auto';
  }
  set theme(theme: Theme) {
    this.write('theme', theme);
  }

  /** What was set as a property before the element was defined becomes an attribute like everything else. */
  protected upgradeProperties(): void {
    for (const name of ATTRIBUTES) {
      const own = Object.getOwnPropertyDescriptor(this, name);
      if (!own) continue;
      Reflect.deleteProperty(this, name);
      Reflect.set(this, name, own.value);
    }
  }

  private text(name: AttributeName): string {
    return this.getAttribute(name) ?? '';
  }

  private number(name: AttributeName): number | undefined {
    const value = Number(this.text(name) || NaN);
    return Number.isFinite(value) ? value : undefined;
  }

  private write(name: AttributeName, value: string | number | undefined): void {
    if (value === undefined || value === '') this.removeAttribute(name);
    else this.setAttribute(name, String(value));
  }
}
