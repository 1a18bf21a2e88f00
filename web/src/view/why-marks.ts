import type { Projector } from './projector.ts';

const SVG = 'http://www.w3.org/2000/svg';
/** More dots would hide what they are about. */
const MOST_WITNESSES = 300;

/** What an answer is about, by input indices of points. */
export interface Marked {
  /** The landmarks asked about; lines between them are whole if the simplex is there. */
  readonly asked: readonly number[];
  readonly present: boolean;
  /** Witnesses, or the closest miss. */
  readonly witnesses: readonly number[];
  readonly missed: readonly number[];
  /** Landmarks that keep it out of the Delaunay triangulation. */
  readonly blockers: readonly number[];
}

/** Rings and dots over the shape. */
export class WhyMarks {
  private readonly svg = document.createElementNS(SVG, 'svg');

  constructor(container: Element) {
    this.svg.setAttribute('class', 'why-marks');
    this.svg.setAttribute('aria-hidden', 'true');
    container.append(this.svg);
  }

  draw(marked: Marked | undefined, placeOf: Projector | undefined): void {
    this.svg.replaceChildren();
    if (!marked || !placeOf) return;
    const { asked, present, witnesses, missed, blockers } = marked;
    const corners = asked.map(placeOf).filter((place) => place !== undefined);
    if (corners.length > 1) {
      const line = document.createElementNS(SVG, 'path');
      // Every two of them.
      const sides = corners.flatMap(([x, y], i) =>
        corners.slice(0, i).map(([u, v]) => `M${u} ${v}L${x} ${y}`),
      );
      line.setAttribute('d', sides.join(''));
      line.setAttribute('class', present ? 'span' : 'span missing');
      this.svg.append(line);
    }
    this.dots(witnesses.slice(0, MOST_WITNESSES), 'sees', 3.5, placeOf);
    this.dots(missed, 'misses', 6, placeOf);
    this.dots(blockers, 'blocks', 9, placeOf);
    this.dots(asked, 'asked', 9, placeOf);
  }

  private dots(indices: readonly number[], kind: string, radius: number, placeOf: Projector): void {
    for (const index of indices) {
      const place = placeOf(index);
      if (!place) continue;
      const dot = document.createElementNS(SVG, 'circle');
      dot.setAttribute('class', kind);
      dot.setAttribute('cx', place[0].toFixed(1));
      dot.setAttribute('cy', place[1].toFixed(1));
      dot.setAttribute('r', String(radius));
      this.svg.append(dot);
    }
  }
}
