import { listenToBoardKeys, listenToPointers, type BoardActions, type Tool } from './board-input.ts';
import { LAYERS, type Layer, type Target } from './board.ts';
import { Computation, questionOf, type Computed, type Setting } from './computation.ts';
import type { PlaneCore, PlanePicture, PlaneQuestion, Reason } from './plane.ts';
import { BOARD, onBoard, parsePoints, type Point } from './points.ts';
import { figureInWords } from './figure-in-words.ts';
import { pointInWords, summary } from './sketch-words.ts';
import { arrange, createParts, type SketchParts } from './sketch-parts.ts';
import * as states from './sketch-state.ts';
import type { PointKind, PointName, SketchState } from './sketch-state.ts';
import { sketchStyle } from './sketch-style.ts';
import { Voice } from './voice.ts';
import { WhyPanel } from './why-panel.ts';
import { readable } from '../model/numbers.ts';

let core: PlaneCore | undefined;
let made = 0;

/** Who computes for all sketches of the page. */
export function computeWith(answering: PlaneCore): void {
  core = answering;
}

function planeCore(): PlaneCore {
  if (!core) throw new Error('computeWith comes before the first sketch');
  return core;
}

/**
 * `<plane-sketch>`: landmarks and witnesses in the plane, and what the core says of them. Attributes: see
 * docs/course.md; they follow what the reader does.
 */
export class PlaneSketchElement extends HTMLElement {
  static readonly observedAttributes = [...states.SKETCH_ATTRIBUTES, 'aria-label'];

  private readonly parts: SketchParts = createParts(`sketch-${++made}`);
  private readonly computation: Computation;
  private readonly panel: WhyPanel;
  private readonly voice = new Voice(this.parts.spoken);
  private current: SketchState = states.stateFrom(() => null);
  private preset: SketchState | undefined;
  private past: SketchState[] = [];
  private computed: Computed | undefined;
  private layers = new Set<Layer>();
  private selected: PointName | undefined;
  private pen: Point = { x: BOARD.width / 2, y: BOARD.height / 2 };
  private focused = false;
  private dragFrom: SketchState | undefined;
  private reflecting = false;

  constructor() {
    super();
    this.computation = new Computation(
      planeCore(),
      (computed) => this.show(computed),
      (error) => this.fail(error),
    );
    this.panel = new WhyPanel(
      this.parts,
      (vertices) => this.why(vertices),
      () => this.question().landmarks.length,
      () => this.draw(),
      (error) => this.fail(error),
    );
    const root = this.attachShadow({ mode: 'open' });
    root.adoptedStyleSheets = [sketchStyle()];
    root.append(this.parts.box);
    this.listen();
  }

  /** Of the points as they are now; undefined before the first. Wait for `settled` after a change. */
  get picture(): PlanePicture | undefined {
    return this.computed?.picture;
  }

  get state(): SketchState {
    return this.current;
  }

  /** Farthest first: the order of the landmarks, and the scale after each. */
  get scale() {
    return this.computed?.scale;
  }

  get extra(): Point | undefined {
    const text = this.getAttribute('extra');
    return text === null ? undefined : parsePoints(text)[0];
  }

  settled(): Promise<void> {
    return this.computation.settled();
  }

  /** The figure's question with something else in it: what would be, if. */
  question(change: Partial<SketchState> = {}): PlaneQuestion {
    return questionOf({ ...this.current, ...change }, this.setting, this.computed?.scale);
  }

  ask(question: PlaneQuestion): Promise<PlanePicture> {
    return planeCore().picture(question);
  }

  why(vertices: readonly number[], question = this.question()): Promise<Reason> {
    return planeCore().why(question, vertices);
  }

  /** Switches a layer on, as an answer does that shows what it says. */
  showLayer(layer: Layer): void {
    this.setLayers(new Set([...this.layers, layer]));
  }

  /** Asks why these landmarks span a simplex, or why not, and lights its witnesses up. */
  inspect(vertices: readonly number[]): void {
    this.panel.inspect(vertices);
  }

  connectedCallback(): void {
    this.readAttributes();
    this.preset ??= this.current;
  }

  attributeChangedCallback(): void {
    if (this.isConnected && !this.reflecting) this.readAttributes();
  }

  private get setting(): Setting {
    return { extra: this.extra, delaunay: this.getAttribute('complex') !== 'whole' };
  }

  private readAttributes(): void {
    const { parts } = this;
    parts.board.svg.setAttribute(
      'aria-label',
      this.getAttribute('aria-label') ?? 'Sketch of landmarks and witnesses',
    );
    try {
      this.current = states.stateFrom((name) => this.getAttribute(name));
      parts.extra.hidden = !this.extra;
    } catch (error) {
      this.fail(error);
      return;
    }
    const shown = (this.getAttribute('show') ?? 'complex names').split(/[\s,_]+/);
    this.layers = new Set(LAYERS.filter((layer) => shown.includes(layer)));
    for (const [layer, box] of parts.layerBoxes) box.checked = this.layers.has(layer);
    parts.whole.checked = this.setting.delaunay;
    arrange(parts, this.getAttribute('offer') ?? 'edits nu layers why', this.current.step > 0);
    this.past = [];
    this.select(undefined);
    this.refresh();
  }

  private listen(): void {
    const { parts } = this;
    const actions: BoardActions = {
      tool: () => this.tool,
      select: (name) => this.select(name),
      step: (forward) => this.select(states.nextPoint(this.current, this.selected, forward)),
      nudge: (dx, dy) => this.nudge(dx, dy),
      drag: (place) => this.drag(place),
      drop: () => this.drop(),
      add: (kind, place) => this.add(kind, place),
      remove: () => this.removeSelected(),
      pick: (target) => this.pick(target),
      pickSelected: () => {
        if (this.selected?.kind === 'landmark') this.pick(this.selected);
      },
      undo: () => this.undo(),
      focus: (on) => {
        this.focused = on && parts.board.svg.matches(':focus-visible');
        this.draw();
      },
    };
    listenToPointers(parts.board, actions);
    listenToBoardKeys(parts.board, actions);
    parts.remove.addEventListener('click', () => this.removeSelected());
    parts.undo.addEventListener('click', () => this.undo());
    parts.reset.addEventListener('click', () => this.preset && this.commit(this.preset));
    parts.back.addEventListener('click', () => this.toStep(this.current.step - 1));
    parts.forward.addEventListener('click', () => this.toStep(this.current.step + 1));
    parts.insert.addEventListener('click', () =>
      this.commit({ ...this.current, withExtra: !this.current.withExtra }),
    );
    parts.whole.addEventListener('change', () => {
      this.reflect({ complex: parts.whole.checked ? 'delaunay' : 'whole' });
      this.refresh();
    });
    parts.ranks.forEach((input) => input.addEventListener('change', () => this.takeNu()));
    for (const [layer, box] of parts.layerBoxes) {
      box.addEventListener('change', () => {
        const layers = new Set(this.layers);
        if (box.checked) layers.add(layer);
        else layers.delete(layer);
        this.setLayers(layers);
      });
    }
  }

  private get tool(): Tool {
    for (const [tool, radio] of this.parts.tools) if (radio.checked) return tool;
    return 'move';
  }

  private takeNu(): void {
    const nu = this.parts.ranks.map(({ value }) => Number(value));
    try {
      this.commit({ ...this.current, nu: states.parseNu(nu.join()) });
    } catch (error) {
      this.fail(error);
    }
  }

  private toStep(step: number): void {
    const last = Math.min(this.computed?.scale?.order.length ?? 1, this.current.witnesses.length);
    this.commit({ ...this.current, step: Math.max(1, Math.min(step, last)) });
  }

  private setLayers(layers: Set<Layer>): void {
    this.layers = layers;
    for (const [layer, box] of this.parts.layerBoxes) box.checked = layers.has(layer);
    this.reflect({ show: LAYERS.filter((layer) => layers.has(layer)).join(' ') });
    this.draw();
  }

  /** Farthest first, a landmark is one of the witnesses. */
  private own(name: PointName | undefined): PointName | undefined {
    if (name?.kind !== 'landmark' || this.current.step === 0) return name;
    const index = this.computed?.scale?.order[name.index];
    return index === undefined ? undefined : { kind: 'witness', index };
  }

  private select(chosen: PointName | undefined): void {
    const name = this.own(chosen);
    const left = this.selected && states.pointAt(this.current, this.selected);
    if (left) this.pen = left;
    this.selected = name;
    if (name) this.voice.say('place', this.selectedInWords());
    this.parts.remove.disabled = !name;
    this.draw();
  }

  private selectedInWords(): string {
    const { selected, current, pen } = this;
    const place = selected && states.pointAt(current, selected);
    if (!selected || !place) return `Cross at ${pen.x}, ${pen.y}`;
    return pointInWords(selected, place, this.computed?.picture.lists[selected.index]);
  }

  private nudge(dx: number, dy: number): void {
    const place = this.selected && states.pointAt(this.current, this.selected);
    if (!this.selected || !place) {
      this.pen = onBoard(this.pen.x + dx, this.pen.y + dy);
      this.voice.say('place', this.selectedInWords());
      this.draw();
      return;
    }
    const next = states.moved(this.current, this.selected, onBoard(place.x + dx, place.y + dy));
    if (next) this.commit(next);
    this.voice.say('place', this.selectedInWords());
  }

  private drag(place: Point): void {
    const next = this.selected && states.moved(this.current, this.selected, place);
    if (!next) return;
    this.dragFrom ??= this.current;
    this.current = next;
    this.refresh();
  }

  private drop(): void {
    if (!this.dragFrom) return;
    this.past.push(this.dragFrom);
    this.dragFrom = undefined;
    this.reflect(states.attributesOf(this.current));
    this.refresh();
  }

  private add(kind: PointKind, place = this.pen): void {
    if (kind === 'landmark' && this.current.step > 0) {
      this.voice.say('place', 'Landmarks are chosen farthest first here: take the next one instead.');
      return;
    }
    const next = states.added(this.current, kind, place);
    if (!next) {
      this.voice.say('place', `There is no room for another ${kind} at ${place.x}, ${place.y}.`);
      return;
    }
    this.commit(next);
    this.select({ kind, index: states.pointsOf(next, kind).length - 1 });
  }

  private removeSelected(): void {
    if (!this.selected) return;
    const next = states.removed(this.current, this.selected);
    const said = this.selectedInWords();
    this.select(undefined);
    this.commit(next);
    this.voice.say('place', `Removed: ${said}`);
    this.parts.board.svg.focus();
  }

  private undo(): void {
    const before = this.past.pop();
    if (!before) return;
    this.current = before;
    this.select(undefined);
    this.reflect(states.attributesOf(before));
    this.refresh();
  }

  private pick(target: Target): void {
    if (target.kind === 'witness') this.select(target);
    else if (target.kind === 'simplex') this.inspect(target.vertices);
    else this.panel.toggle(target.index);
  }

  /** Another state: it can be undone, and the attributes say it. */
  private commit(next: SketchState): void {
    this.past.push(this.current);
    this.current = next;
    this.reflect(states.attributesOf(next));
    this.refresh();
  }

  private reflect(attributes: Readonly<Record<string, string | null>>): void {
    this.reflecting = true;
    for (const [name, value] of Object.entries(attributes)) {
      if (value === null) this.removeAttribute(name);
      else this.setAttribute(name, value);
    }
    this.reflecting = false;
  }

  private refresh(): void {
    const { parts, current } = this;
    parts.undo.disabled = this.past.length === 0;
    parts.ranks.forEach((input, k) => (input.value = String(current.nu[k] ?? 0)));
    parts.insert.setAttribute('aria-pressed', String(current.withExtra));
    parts.insert.textContent = current.withExtra ? 'Take a out' : 'Insert a';
    this.toggleAttribute('data-busy', true);
    this.draw();
    this.computation.want(current, this.setting);
  }

  private show(computed: Computed): void {
    const { parts } = this;
    this.computed = computed;
    parts.trouble.hidden = true;
    const said = summary(computed.picture);
    if (parts.readout.textContent !== '' && said !== parts.readout.textContent)
      this.voice.say('summary', said);
    parts.readout.textContent = said;
    const { step } = computed.state;
    const epsilon = computed.scale?.epsilon[Math.min(step, computed.scale.order.length) - 1];
    if (epsilon !== undefined)
      parts.scale.textContent = `step ${computed.landmarks.length} · ε ${readable(epsilon)}`;
    parts.listBody.replaceChildren(figureInWords(computed.picture));
    this.toggleAttribute('data-busy', false);
    this.dataset['betti'] = computed.picture.betti.join();
    this.panel.follow();
    this.draw();
  }

  private fail(error: unknown): void {
    this.toggleAttribute('data-busy', false);
    this.parts.trouble.textContent = error instanceof Error ? error.message : String(error);
    this.parts.trouble.hidden = false;
  }

  private draw(): void {
    const { computed, current, layers, selected, extra, panel } = this;
    const asked = questionOf(current, this.setting, computed?.scale);
    this.parts.board.render({
      landmarks: asked.landmarks,
      witnesses: current.witnesses,
      picture: computed?.picture,
      layers,
      extra,
      extraIn: current.withExtra,
      scale: computed?.scale,
      step: current.step,
      selected,
      pen: this.focused && !selected ? this.pen : undefined,
      picked: panel.picked,
      lit: panel.lit,
    });
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'plane-sketch': PlaneSketchElement;
  }
}
