import type { Answer } from './answer.ts';
import { circumcircle } from './circumcircle.ts';
import type { Layer } from './layers.ts';
import { namesOf, witnessName } from './names.ts';
import type { FarthestOrder, PlanePicture, Simplex } from './plane.ts';
import { BOARD, drawn, samePlace, type Point } from './points.ts';
import type { PointKind, PointName } from './sketch-state.ts';
import { draw } from './svg.ts';

/** Everything that is drawn. */
export interface Scene {
  readonly landmarks: readonly Point[];
  readonly witnesses: readonly Point[];
  /** Of these points or, while the core works, of those a moment before. */
  readonly picture: PlanePicture | undefined;
  readonly layers: ReadonlySet<Layer>;
  /** A landmark that can be put in: open while it is out. */
  readonly extra: Point | undefined;
  /** Which landmark it is, once it is in. */
  readonly extraAt: number | undefined;
  readonly scale: FarthestOrder | undefined;
  readonly step: number;
  readonly selected: PointName | undefined;
  /** Where the keyboard would put a point. */
  readonly pen: Point | undefined;
  /** Corners of the simplex that is asked for. */
  readonly asked: readonly number[];
  readonly answer: Answer;
}

/** What a pointer is on. */
export type Target =
  | { readonly kind: PointKind; readonly index: number }
  | { readonly kind: 'simplex'; readonly vertices: readonly number[] };

const MARGIN = 3;
/** More names would hide the points. */
const MOST_NAMES = 40;
/** Of more landmarks than these the points are smaller, or they would hide the edges. */
const MANY = 24;
const sizeFor = ({ landmarks }: Scene): number => (landmarks.length > MANY ? 0.6 : 1);
/** Upwards is more. */
const up = (y: number): number => BOARD.height - y;
const path = (points: readonly Point[]): string =>
  points.map(({ x, y }) => `${Number(x.toFixed(3))},${Number(up(y).toFixed(3))}`).join(' ');

/** The drawing: points, and the layers that are on. It decides nothing; what it shows is the core's. */
export class Board {
  readonly svg = draw('svg', {
    viewBox: `${-MARGIN} ${-MARGIN} ${BOARD.width + 2 * MARGIN} ${BOARD.height + 2 * MARGIN}`,
    class: 'board',
    tabindex: 0,
    role: 'application',
  });
  private held: EventTarget | null = null;
  private readonly ink = draw('g', { 'aria-hidden': 'true' });

  constructor() {
    const paper = { x: -MARGIN, y: -MARGIN, class: 'paper' };
    this.svg.append(
      draw('rect', { ...paper, width: BOARD.width + 2 * MARGIN, height: BOARD.height + 2 * MARGIN }),
      this.ink,
    );
  }

  render(scene: Scene): void {
    const { picture, layers } = scene;
    const parts: SVGElement[] = [];
    if (picture) {
      if (layers.has('pairs')) parts.push(...this.cells(picture.pairCells, 'pair-cell'));
      if (layers.has('cells')) parts.push(...this.cells(picture.cells, 'cell'));
      if (layers.has('cover')) parts.push(...this.cover(scene));
      if (layers.has('delaunay')) parts.push(...this.lines(scene, picture.delaunayEdges, 'delaunay'));
      if (layers.has('complex')) parts.push(...this.complex(scene, picture));
    }
    parts.push(...this.asked(scene));
    if (picture && layers.has('lists')) parts.push(...this.list(scene, picture));
    parts.push(...this.points(scene));
    for (const old of [...this.ink.children]) if (old !== this.held) old.remove();
    this.ink.append(...parts);
  }

  /** What a finger has touched stays in the drawing until it is let go: a finger whose target is gone is heard no more. */
  hold(target: EventTarget | null): void {
    this.held = target;
  }

  /** In units of the board, where the pointer is. */
  placeOf(event: PointerEvent): Point | undefined {
    const matrix = this.svg.getScreenCTM();
    if (!matrix) return undefined;
    const { x, y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix.inverse());
    return { x, y: up(y) };
  }

  /** What was hit, the topmost first. */
  targetOf(event: Event): Target | undefined {
    const hit = event.target instanceof Element ? event.target.closest<SVGElement>('[data-hit]') : null;
    const { hit: kind, at = '' } = hit?.dataset ?? {};
    if (kind === 'landmark' || kind === 'witness') return { kind, index: Number(at) };
    if (kind === 'simplex') return { kind, vertices: at.split(' ').map(Number) };
    return undefined;
  }

  private cells(cells: PlanePicture['cells'], name: string): SVGElement[] {
    return cells.filter(drawn).map(({ of, corners }) => {
      // Four tints in turn keep neighbors apart well enough; the border says the rest.
      const tint = of.reduce((sum, index) => 3 * sum + index, 0) % 4;
      return draw('polygon', { points: path(corners), class: `${name} tint-${tint}` });
    });
  }

  private cover({ landmarks, scale, step }: Scene): SVGElement[] {
    const radius = scale?.epsilon[step - 1];
    if (radius === undefined) return [];
    return landmarks.map(({ x, y }) => draw('circle', { cx: x, cy: up(y), r: radius, class: 'cover' }));
  }

  private lines(scene: Scene, edges: readonly (readonly number[])[], name: string): SVGElement[] {
    return edges.flatMap((vertices) => {
      const ends = this.corners(scene, vertices);
      return ends.length === 2 ? [draw('polyline', { points: path(ends), class: name })] : [];
    });
  }

  private complex(scene: Scene, { edges, triangles, vertices }: PlanePicture): SVGElement[] {
    const shapes = (simplices: readonly Simplex[], name: string): SVGElement[] =>
      simplices.flatMap(({ vertices: names }) => {
        const corners = this.corners(scene, names);
        if (corners.length !== names.length) return [];
        const hit = { 'data-hit': 'simplex', 'data-at': names.join(' ') };
        const shape = draw('polygon', { points: path(corners), class: name, ...hit });
        // An edge is thin to look at and wide to hit.
        const wide = draw('polygon', { points: path(corners), class: 'wide', ...hit });
        return names.length === 2 ? [shape, wide] : [shape];
      });
    const rings = vertices.flatMap(({ vertices: [index = 0] }) => {
      const place = scene.landmarks[index];
      return place
        ? [draw('circle', { cx: place.x, cy: up(place.y), r: 2.4 * sizeFor(scene), class: 'vertex' })]
        : [];
    });
    return [...shapes(triangles, 'triangle'), ...shapes(edges, 'edge'), ...rings];
  }

  /** The simplex that was asked for, there or not; and why not: the face that is missing, who lies in the disc. */
  private asked(scene: Scene): SVGElement[] {
    const { face, blockers, disc } = scene.answer;
    const outline = (vertices: readonly number[], name: string): SVGElement[] => {
      const corners = this.corners(scene, vertices);
      return corners.length > 0 ? [draw('polygon', { points: path(corners), class: name })] : [];
    };
    const rings = this.corners(scene, blockers).map(({ x, y }) =>
      draw('circle', { cx: x, cy: up(y), r: 3.4, class: 'blocker' }),
    );
    const circle = circumcircle(this.corners(scene, disc));
    const discs = circle
      ? [draw('circle', { cx: circle.x, cy: up(circle.y), r: circle.radius, class: 'disc' })]
      : [];
    return [...discs, ...outline(scene.asked, 'asked'), ...outline(face, 'missing'), ...rings];
  }

  /** From the selected witness to its nearest landmarks, with their places in its list. */
  private list({ landmarks, witnesses, selected, answer }: Scene, { lists }: PlanePicture): SVGElement[] {
    const chosen = selected?.kind === 'witness' ? [selected.index] : answer.lit.slice(0, 1);
    return chosen.flatMap((index) => {
      const from = witnesses[index];
      if (!from) return [];
      return (lists[index] ?? []).flatMap((landmark, rank) => {
        const to = landmarks[landmark];
        if (!to) return [];
        const [x, y] = [(from.x + 2 * to.x) / 3, up((from.y + 2 * to.y) / 3)];
        return [
          draw('polyline', { points: path([from, to]), class: `list rank-${Math.min(rank, 3)}` }),
          draw('text', { x: x + 0.8, y: y - 0.8, class: 'rank' }, String(rank + 1)),
        ];
      });
    });
  }

  private points(scene: Scene): SVGElement[] {
    const { landmarks, witnesses, selected, layers, extra, extraAt, pen } = scene;
    const { lit } = scene.answer;
    const parts: SVGElement[] = [];
    const reach: SVGElement[] = [];
    const names = layers.has('names');
    const point = (kind: PointKind, { x, y }: Point, index: number, label: string): void => {
      const chosen = selected?.kind === kind && selected.index === index;
      const glows = kind === 'witness' && lit.includes(index);
      const about = { 'data-hit': kind, 'data-at': index };
      const classes = [kind, ...(chosen ? ['selected'] : []), ...(glows ? ['lit'] : [])].join(' ');
      const radius = (kind === 'landmark' ? 1.7 : glows ? 1.5 : 1) * sizeFor(scene);
      parts.push(draw('circle', { cx: x, cy: up(y), r: radius, class: classes, ...about }));
      // Where a witness is a landmark, the landmark is what a press means.
      if (kind === 'landmark' || !landmarks.some((place) => samePlace(place, { x, y })))
        reach.push(
          draw('circle', { cx: x, cy: up(y), r: kind === 'landmark' ? 4 : 3, class: 'reach', ...about }),
        );
      if (label !== '') parts.push(draw('text', { x: x + 2.2, y: up(y) - 2, class: `${kind}-name` }, label));
    };
    // Where a witness is a landmark there is room for one name.
    const namesWitness = (place: Point, index: number): boolean =>
      ((names && witnesses.length <= MOST_NAMES) || lit.includes(index)) &&
      !landmarks.some((other) => samePlace(other, place));
    const nameOf = namesOf({ extra: extraAt });
    landmarks.forEach((place, i) => point('landmark', place, i, names || i === extraAt ? nameOf(i) : ''));
    witnesses.forEach((place, i) => point('witness', place, i, namesWitness(place, i) ? witnessName(i) : ''));
    if (extra && extraAt === undefined) {
      parts.push(
        draw('circle', { cx: extra.x, cy: up(extra.y), r: 1.7, class: 'extra' }),
        draw('text', { x: extra.x + 2.2, y: up(extra.y) - 2, class: 'landmark-name' }, 'a'),
      );
    }
    const marked = selected && (selected.kind === 'landmark' ? landmarks : witnesses)[selected.index];
    const cross = marked ?? pen;
    if (cross) {
      const [x, y] = [cross.x, up(cross.y)];
      const arms = `M${x - 6} ${y}h4M${x + 2} ${y}h4M${x} ${y - 6}v4M${x} ${y + 2}v4`;
      parts.push(draw('path', { d: arms, class: marked ? 'cross chosen' : 'cross' }));
    }
    return [...parts, ...reach];
  }

  private corners({ landmarks }: Scene, vertices: readonly number[]): Point[] {
    return vertices.flatMap((index) => landmarks[index] ?? []);
  }
}
