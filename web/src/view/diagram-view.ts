import type { PlateauCard } from '../model/plateau-cards.ts';
import type { RunRecord } from '../model/record.ts';
import { axisOf, scaleOf, stepAt, type AxisKind, type ScaleRange } from '../model/scale-axis.ts';
import { readable, grouped } from '../model/numbers.ts';
import { bettiInNumbers } from '../model/words.ts';
import { layOut, scaleToX, STRIP, xToScale, type Band, type DiagramLayout } from './diagram-layout.ts';

/** Reads the value of a CSS variable. */
type Style = (name: string) => string;

function paintBands(
  context: CanvasRenderingContext2D,
  bands: readonly Band[],
  top: number,
  height: number,
  style: Style,
): void {
  context.textAlign = 'left';
  for (const band of bands) {
    context.fillStyle = style(`--band-${band.family}`);
    // A pixel in between tells two bands of one color apart.
    context.fillRect(band.from, top, Math.max(1, band.to - band.from - 1), height);
    // Beginning at the left, out of the way of the playhead in the middle.
    if (band.to - band.from < context.measureText(band.label).width + 10) continue;
    context.fillStyle = style('--ink');
    context.fillText(band.label, band.from + 5, top + 9);
  }
}

/** The plateaus of the earlier run, each with a line in its color below. */
function paintEarlier(context: CanvasRenderingContext2D, layout: DiagramLayout, style: Style): void {
  const top = layout.top - STRIP.height - STRIP.gap;
  paintBands(context, layout.earlier, top, STRIP.height, style);
  for (const { from, to, family } of layout.earlier) {
    context.fillStyle = style(`--mark-${family}`);
    context.fillRect(from, top + STRIP.height, Math.max(1, to - from - 1), 2);
  }
}

/** Upright hatching is for what is not computed yet. */
function paintOpenRange(context: CanvasRenderingContext2D, layout: DiagramLayout, style: Style): void {
  const { top, bottom, right, computedTo } = layout;
  if (computedTo >= right - 0.5) return;
  context.save();
  context.beginPath();
  context.rect(computedTo, top, right - computedTo, bottom - top);
  context.clip();
  context.strokeStyle = style('--hatch');
  context.lineWidth = 1;
  context.beginPath();
  const rise = bottom - top;
  for (let x = computedTo - rise; x < right; x += 8) {
    context.moveTo(x, bottom);
    context.lineTo(x + rise, top);
  }
  context.stroke();
  context.restore();
}

function paintAxes(context: CanvasRenderingContext2D, layout: DiagramLayout, style: Style): void {
  const { left, right, bottom } = layout;
  context.strokeStyle = style('--grid');
  context.fillStyle = style('--muted');
  context.lineWidth = 1;
  for (const { at } of layout.lines) {
    const y = Math.round(at) + 0.5;
    context.beginPath();
    context.moveTo(left, y);
    context.lineTo(right, y);
    context.stroke();
  }
  context.textAlign = 'center';
  context.strokeStyle = style('--muted');
  context.beginPath();
  context.moveTo(left, bottom + 0.5);
  context.lineTo(right, bottom + 0.5);
  for (const { at, label } of layout.columns) {
    context.moveTo(Math.round(at) + 0.5, bottom);
    context.lineTo(Math.round(at) + 0.5, bottom + 4);
    context.fillText(label, at, bottom + 13);
  }
  context.stroke();
}

/** What stays in its place while the diagram is scrolled: the numbers at the left and the names of the axes. */
function paintNames(
  context: CanvasRenderingContext2D,
  layout: DiagramLayout,
  style: Style,
  seen: number,
): void {
  const { left, top, bottom } = layout;
  context.clearRect(0, 0, left, layout.height);
  context.fillStyle = style('--muted');
  context.textAlign = 'right';
  for (const { at, label } of layout.lines) context.fillText(label, left - 7, at);
  if (layout.earlier.length > 0) {
    context.fillText('before', left - 3, top - STRIP.gap - STRIP.height / 2);
  }
  context.textAlign = 'center';
  context.fillText('1/ε', (left + seen) / 2, bottom + 28);
}

function paintSeries(context: CanvasRenderingContext2D, layout: DiagramLayout, style: Style): void {
  context.lineWidth = 2;
  context.lineJoin = 'round';
  layout.series.forEach((corners, k) => {
    context.strokeStyle = style(`--betti-${k}`);
    context.beginPath();
    for (let i = 0; i + 1 < corners.length; i += 2) context.lineTo(corners[i] ?? 0, corners[i + 1] ?? 0);
    context.stroke();
  });
}

/** No e-fold of scale gets less room, up to a width at which a diagram is readable in any case. */
const LEAST_E_FOLD = 130;
const READABLE_WIDTH = 560;
/** The playhead keeps this far from the end of what is seen. */
const EDGE = 24;

/**
 * The Betti numbers over 1/ε with plateau bands and a playhead. Dragging asks for a step; the playhead is an element
 * of its own, so moving it paints nothing. On a narrow screen the diagram is wider than its box and scrolls along 1/ε:
 * then a finger scrolls and taps, and drags the playhead by its grip.
 */
export class DiagramView {
  private readonly canvas = document.createElement('canvas');
  private readonly playhead = document.createElement('div');
  private readonly reading = document.createElement('div');
  private readonly resizing: ResizeObserver;
  private record: RunRecord | undefined;
  private cards: readonly PlateauCard[] = [];
  private earlier: readonly PlateauCard[] = [];
  private layout: DiagramLayout | undefined;
  private step = 0;
  private paintRequest = 0;
  private kind: AxisKind = 'log';
  private range: ScaleRange | undefined;
  /** Where the playhead stands, if not where its step begins. */
  private place: number | undefined;
  private dragged = false;
  /** The finger that is down scrolls, or taps. */
  private tapped = false;
  /** The playhead was moved to where the next picture shows it. */
  private moved = false;

  constructor(
    private readonly container: HTMLElement,
    private readonly scroller: HTMLElement,
    private readonly onScrub: (step: number, scale: number) => void,
  ) {
    this.playhead.className = 'playhead';
    this.playhead.hidden = true;
    this.canvas.setAttribute('aria-hidden', 'true');
    this.reading.className = 'reading';
    this.reading.hidden = true;
    container.append(this.canvas, this.playhead, this.reading);
    container.addEventListener('pointerdown', this.startDrag);
    container.addEventListener('click', this.tap);
    container.addEventListener('pointermove', this.read);
    container.addEventListener('pointerleave', this.stopReading);
    this.resizing = new ResizeObserver(() => this.requestPaint());
    this.resizing.observe(scroller);
    scroller.addEventListener('scroll', this.repaint);
  }

  /** `earlier`: the plateaus of a run of the same points to compare with. */
  setRecord(record: RunRecord, earlier: readonly PlateauCard[]): void {
    this.record = record;
    this.cards = [];
    this.earlier = earlier;
    this.step = 0;
    this.requestPaint();
  }

  setCards(cards: readonly PlateauCard[]): void {
    this.cards = cards;
    this.requestPaint();
  }

  /** Moves the playhead; `scale`: to this place, where the step has begun already. */
  showStep(step: number, scale?: number): void {
    this.step = step;
    this.place = scale;
    this.moved = this.paintRequest !== 0;
    this.placePlayhead();
    this.keepInSight();
  }

  get axisKind(): AxisKind {
    return this.kind;
  }

  setAxis(kind: AxisKind): void {
    this.kind = kind;
    this.requestPaint();
  }

  /** Shows this part of the scale and not just that of the run: several diagrams have one axis. */
  setRange(range: ScaleRange): void {
    if (this.range?.low === range.low && this.range.high === range.high) return;
    this.range = range;
    this.requestPaint();
  }

  requestPaint(): void {
    this.paintRequest ||= requestAnimationFrame(() => {
      this.paintRequest = 0;
      this.paint();
    });
  }

  dispose(): void {
    cancelAnimationFrame(this.paintRequest);
    this.resizing.disconnect();
    this.scroller.removeEventListener('scroll', this.repaint);
    this.container.removeEventListener('pointerdown', this.startDrag);
    this.container.removeEventListener('click', this.tap);
    this.container.removeEventListener('pointermove', this.read);
    this.container.removeEventListener('pointerleave', this.stopReading);
    this.canvas.remove();
    this.playhead.remove();
    this.reading.remove();
  }

  private readonly repaint = (): void => this.requestPaint();

  /** As wide as the box, or wider where that would press the scales together. */
  private get width(): number {
    const { clientWidth } = this.scroller;
    if (!this.record) return clientWidth;
    const { low, high } = this.range ?? axisOf(this.record);
    return Math.max(clientWidth, Math.min(READABLE_WIDTH, Math.round((high - low) * LEAST_E_FOLD)));
  }

  private paint(): void {
    const { clientHeight: height } = this.container;
    const { clientWidth: seen, scrollLeft } = this.scroller;
    const context = this.canvas.getContext('2d');
    if (!this.record || !context || seen === 0 || height === 0) return;
    const { width } = this;
    const scrolls = width > seen;
    this.container.style.width = scrolls ? `${width}px` : '';
    this.container.classList.toggle('scrolls', scrolls);
    this.canvas.style.width = `${seen}px`;
    const ratio = Math.min(window.devicePixelRatio, 3);
    const [pixelsX, pixelsY] = [Math.round(seen * ratio), Math.round(height * ratio)];
    if (this.canvas.width !== pixelsX || this.canvas.height !== pixelsY) {
      this.canvas.width = pixelsX;
      this.canvas.height = pixelsY;
    }
    const css = getComputedStyle(this.container);
    const style: Style = (name) => css.getPropertyValue(name).trim();
    const { kind, earlier, range } = this;
    const layout = layOut(this.record, this.cards, {
      ...{ width, height, resolution: ratio, kind, earlier, range },
    });
    context.setTransform(ratio, 0, 0, ratio, -scrollLeft * ratio, 0);
    context.clearRect(scrollLeft, 0, seen, height);
    context.font = `${style('--small')} ${css.fontFamily}`;
    context.textBaseline = 'middle';
    paintBands(context, layout.bands, layout.top, layout.bottom - layout.top, style);
    paintEarlier(context, layout, style);
    if (!this.record.ended) paintOpenRange(context, layout, style);
    paintAxes(context, layout, style);
    paintSeries(context, layout, style);
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    paintNames(context, layout, style, seen);
    this.layout = layout;
    this.placePlayhead();
    if (this.moved) this.keepInSight();
    this.moved = false;
  }

  private placePlayhead(): void {
    if (!this.record || !this.layout || this.step < 1 || this.step > this.record.stepCount) {
      this.playhead.hidden = true;
      return;
    }
    this.playhead.hidden = false;
    this.playhead.style.transform = `translateX(${this.playheadAt}px)`;
  }

  private get playheadAt(): number {
    if (!this.record || !this.layout || this.step < 1) return 0;
    const { left, right } = this.layout;
    const at = scaleToX(this.layout, this.place ?? scaleOf(this.record, this.step));
    return Math.min(right, Math.max(left, at));
  }

  /** A playhead that leaves the visible part of the diagram takes it along. */
  private keepInSight(): void {
    // Sizes are asked only where they matter: the answer waits for the layout of the page.
    if (!this.layout || !this.container.classList.contains('scrolls')) return;
    const { clientWidth, scrollLeft } = this.scroller;
    const at = this.playheadAt - scrollLeft;
    const [first, last] = [this.layout.left, clientWidth - EDGE];
    if (first <= at && at <= last) return;
    // Under a hand the diagram moves no more than it must.
    const place = !this.dragged ? clientWidth / 2 : at < first ? first : last;
    this.scroller.scrollLeft += at - place;
  }

  /** A finger that neither scrolled nor dragged means the place. */
  private readonly tap = (event: MouseEvent): void => {
    if (this.tapped) this.scrubTo(event.clientX);
  };

  private readonly startDrag = (down: PointerEvent): void => {
    const scrolls = this.container.classList.contains('scrolls');
    const byFinger = scrolls && down.pointerType === 'touch' && down.target !== this.playhead;
    this.tapped = byFinger;
    if (down.button !== 0 || byFinger) return;
    this.dragged = true;
    this.container.setPointerCapture(down.pointerId);
    const move = (event: PointerEvent): void => this.scrubTo(event.clientX);
    const end = (): void => {
      this.dragged = false;
      this.container.removeEventListener('pointermove', move);
      this.container.removeEventListener('pointerup', end);
      this.container.removeEventListener('pointercancel', end);
    };
    this.container.addEventListener('pointermove', move);
    this.container.addEventListener('pointerup', end);
    this.container.addEventListener('pointercancel', end);
    this.scrubTo(down.clientX);
  };

  /** What the step under the pointer shows, beside it and never outside the diagram. */
  private readonly read = (event: PointerEvent): void => {
    const { record, layout } = this;
    if (!record || !layout || record.stepCount === 0) return;
    const x = event.clientX - this.container.getBoundingClientRect().left;
    const within = layout.left <= x && x <= layout.computedTo;
    this.reading.hidden = !within;
    if (!within) return;
    const { step, epsilon, betti } = record.summary(stepAt(record, xToScale(layout, x)));
    this.reading.textContent = `step ${grouped(step)} · ε ${readable(epsilon)} · ${bettiInNumbers(betti)}`;
    const onLeft = x - this.scroller.scrollLeft > this.scroller.clientWidth / 2;
    this.reading.classList.toggle('on-left', onLeft);
    this.reading.style.transform = `translateX(${x}px)${onLeft ? ' translateX(-100%)' : ''}`;
  };

  private readonly stopReading = (): void => {
    this.reading.hidden = true;
  };

  private scrubTo(clientX: number): void {
    if (!this.record || !this.layout || this.record.stepCount === 0) return;
    const x = clientX - this.container.getBoundingClientRect().left;
    const scale = xToScale(this.layout, x);
    this.onScrub(stepAt(this.record, scale), scale);
  }
}
