import { listenToBoardKeys, listenToPointers, type BoardActions, type Tool } from './board-input.ts';
import type { Target } from './board.ts';
import { Computation, questionOf, type Computed, type Setting } from './computation.ts';
import { figureInWords } from './figure-in-words.ts';
import { LAYERS, layersIn, type Layer } from './layers.ts';
import { askedNames, landmarksNamed, namesOf } from './names.ts';
import type { PlaneCore, PlanePicture, PlaneQuestion, Reason } from './plane.ts';
import { parsePoints, type Point } from './points.ts';
import { SketchEditor } from './sketch-editor.ts';
import { arrange, createParts, type SketchParts } from './sketch-parts.ts';
import * as states from './sketch-state.ts';
import type { SketchState } from './sketch-state.ts';
import { sketchStyle } from './sketch-style.ts';
import { changeInWords, summary } from './sketch-words.ts';
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

/** A sentence, and the picture that it is about. */
interface Told {
  readonly said: string;
  readonly picture: PlanePicture;
}

/**
 * `<plane-sketch>`: landmarks and witnesses in the plane, and what the core says of them. Attributes: see
 * docs/course.md; they follow what the reader does.
 */
export class PlaneSketchElement extends HTMLElement {
  static readonly observedAttributes = [...states.SKETCH_ATTRIBUTES, 'aria-label'];

  private readonly parts: SketchParts = createParts(`sketch-${++made}`);
  private readonly computation: Computation;
  private readonly editor: SketchEditor;
  private readonly panel: WhyPanel;
  private readonly voice = new Voice(this.parts.spoken, () => (this.heard = this.told));
  /** All attributes as the page had them. */
  private preset: ReadonlyMap<string, string | null> | undefined;
  private computed: Computed | undefined;
  private layers = new Set<Layer>();
  /** What stands under the board, and what has been spoken. */
  private told: Told | undefined;
  private heard: Told | undefined;
  private focused = false;
  /** The attributes make no sense: what is drawn is what they said before. */
  private misread = false;
  private reflecting = false;

  constructor() {
    super();
    const fail = (error: unknown): void => this.fail(error);
    this.computation = new Computation(planeCore(), (computed) => this.show(computed), fail);
    this.editor = new SketchEditor({
      changed: (lasting) => this.changed(lasting),
      redraw: () => this.draw(),
      say: (sentence) => this.voice.say('place', sentence),
      order: () => this.scale?.order,
      list: (witness) => this.picture?.lists[witness],
      landmarkName: (landmark) => namesOf(this.question())(landmark),
    });
    this.panel = new WhyPanel(
      this.parts,
      (vertices, question) => this.why(vertices, question),
      (names) => this.askFor(names),
      () => this.draw(),
      fail,
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
    return this.editor.state;
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
    return questionOf({ ...this.state, ...change }, this.setting, this.scale);
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
    this.askFor(askedNames(vertices, this.question()));
  }

  connectedCallback(): void {
    this.preset ??= new Map(states.SKETCH_ATTRIBUTES.map((name) => [name, this.getAttribute(name)]));
    this.readAttributes();
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
    this.offerReset();
    this.misread = !this.attempt(() => {
      const state = this.stateAsked();
      parts.extra.hidden = !this.extra;
      this.editor.open(state);
      this.readLook();
      this.panel.show(state.asked);
      this.refresh();
    });
  }

  private stateAsked(): SketchState {
    return states.stateFrom((name) => this.getAttribute(name));
  }

  /** What is shown of the state, and what can be changed. */
  private readLook(): void {
    const { parts } = this;
    this.layers = new Set(layersIn(this.getAttribute('show') ?? 'complex names'));
    for (const [layer, box] of parts.layerBoxes) box.checked = this.layers.has(layer);
    parts.whole.checked = this.setting.delaunay;
    this.editor.editable = arrange(parts, {
      offer: this.getAttribute('offer'),
      layers: this.getAttribute('layers'),
      farthestFirst: this.hasAttribute('step'),
    });
  }

  private attempt(act: () => void): boolean {
    try {
      act();
      return true;
    } catch (error) {
      this.fail(error);
      return false;
    }
  }

  private listen(): void {
    const { parts, editor } = this;
    const actions: BoardActions = {
      tool: () => this.tool,
      editable: () => editor.editable,
      select: (name) => editor.select(name),
      step: (forward) => editor.step(forward),
      nudge: (dx, dy) => editor.nudge(dx, dy),
      drag: (place) => editor.drag(place),
      drop: () => editor.drop(),
      add: (kind, place) => {
        const offered = !parts.tools.get(kind)?.parentElement?.hidden;
        if (kind === 'landmark' || offered) editor.add(kind, place);
      },
      remove: () => editor.remove(),
      pick: (target) => this.pick(target),
      pickSelected: () => {
        if (editor.selected?.kind === 'landmark') this.pick(editor.selected);
      },
      undo: () => editor.undo(),
      focus: (on) => {
        this.focused = on && parts.board.svg.matches(':focus-visible');
        this.draw();
      },
    };
    listenToPointers(parts.board, actions);
    listenToBoardKeys(parts.board, actions);
    // A button that has no more to do loses the focus: the board takes it.
    const press = (button: HTMLButtonElement, act: () => void): void =>
      button.addEventListener('click', () => {
        act();
        if (button.disabled) parts.board.svg.focus();
      });
    press(parts.remove, () => editor.remove());
    press(parts.undo, () => editor.undo());
    press(parts.clear, () => editor.clear());
    press(parts.reset, () => this.reset());
    press(parts.back, () => this.toStep(-1));
    press(parts.forward, () => this.toStep(1));
    press(parts.insert, () => editor.commit({ ...this.state, withExtra: !this.state.withExtra }));
    parts.whole.addEventListener('change', () => {
      this.reflect({ complex: parts.whole.checked ? null : 'whole' });
      this.refresh();
    });
    parts.ranks.forEach((input) => input.addEventListener('change', () => this.takeNu()));
    for (const [layer, box] of parts.layerBoxes) {
      box.addEventListener('change', () => {
        const others = [...this.layers].filter((other) => other !== layer);
        this.setLayers(new Set(box.checked ? [...others, layer] : others));
      });
    }
  }

  private get tool(): Tool {
    for (const [tool, radio] of this.parts.tools) if (radio.checked) return tool;
    return 'move';
  }

  private takeNu(): void {
    // An empty field is no number, and certainly not 0.
    const nu = this.parts.ranks.map(({ value }) => (value === '' ? '?' : value));
    this.attempt(() => this.editor.commit({ ...this.state, nu: states.parseNu(nu.join()) }));
  }

  /** From the step that is shown: an address may have asked for more than there are. */
  private toStep(change: number): void {
    const last = this.scale?.order.length;
    if (last === undefined) return;
    const step = Math.min(this.state.step, last) + change;
    this.editor.commit({ ...this.state, step: Math.max(1, Math.min(step, last)) });
  }

  private setLayers(layers: Set<Layer>): void {
    this.layers = layers;
    for (const [layer, box] of this.parts.layerBoxes) box.checked = layers.has(layer);
    this.reflect({ show: LAYERS.filter((layer) => layers.has(layer)).join(' ') });
    this.tell();
    this.draw();
  }

  /** All as the page had it, what is shown as well as the points. */
  private reset(): void {
    this.editor.select(undefined);
    this.reflect(Object.fromEntries(this.preset ?? []));
    this.attempt(() => {
      this.readLook();
      this.editor.commit(this.stateAsked());
    });
  }

  private pick(target: Target): void {
    if (target.kind === 'witness') this.editor.select(target);
    if (target.kind === 'witness' || this.parts.why.hidden) return;
    if (target.kind === 'simplex') this.inspect(target.vertices);
    else this.toggleCorner(target.index);
  }

  /** Into the question why, or out of it. */
  private toggleCorner(landmark: number): void {
    const question = this.question();
    const corners = landmarksNamed(this.state.asked, question);
    this.inspect(
      corners.includes(landmark) ? corners.filter((other) => other !== landmark) : [...corners, landmark],
    );
  }

  private askFor(names: readonly string[]): void {
    this.editor.ask(names);
    this.reflect(states.attributesOf(this.state));
    this.panel.show(names);
    void this.panel.tell(names, this.question());
  }

  /** The attributes say every state that lasts. */
  private changed(lasting: boolean): void {
    this.misread = false;
    if (lasting) this.reflect(states.attributesOf(this.state));
    this.panel.show(this.state.asked);
    this.refresh();
  }

  private reflect(attributes: Readonly<Record<string, string | null>>): void {
    this.reflecting = true;
    for (const [name, value] of Object.entries(attributes)) {
      if (value === null) this.removeAttribute(name);
      else this.setAttribute(name, value);
    }
    this.reflecting = false;
    this.offerReset();
  }

  private offerReset(): void {
    this.parts.reset.disabled = [...(this.preset ?? [])].every(
      ([name, value]) => this.getAttribute(name) === value,
    );
  }

  private refresh(): void {
    const { parts, state } = this;
    parts.undo.disabled = !this.editor.canUndo;
    parts.ranks.forEach((input, k) => (input.value = String(state.nu[k] ?? 0)));
    parts.insert.setAttribute('aria-pressed', String(state.withExtra));
    parts.insert.textContent = state.withExtra ? 'Take a out' : 'Insert a';
    this.toggleAttribute('data-busy', true);
    this.draw();
    this.computation.want(state, this.setting);
  }

  private show(computed: Computed): void {
    const { parts } = this;
    this.computed = computed;
    parts.trouble.hidden = !this.misread;
    this.tell();
    const { step } = computed.state;
    const epsilon = computed.scale?.epsilon[Math.min(step, computed.scale.order.length) - 1];
    if (epsilon !== undefined)
      parts.scale.textContent = `step ${computed.landmarks.length} · ε ${readable(epsilon)}`;
    parts.listBody.replaceChildren(figureInWords(computed.picture));
    this.toggleAttribute('data-busy', false);
    this.dataset['betti'] = computed.picture.betti.join();
    void this.panel.tell(this.state.asked, this.question());
    this.draw();
  }

  /** In words, under the board; what has become another since it was last spoken is spoken. */
  private tell(): void {
    const { picture, layers } = this;
    if (!picture) return;
    const said = summary(picture, layers);
    this.parts.readout.textContent = said;
    this.told = { said, picture };
    this.heard ??= this.told;
    const change = changeInWords(this.heard.picture, picture, layers);
    const news = said !== this.heard.said || change !== '';
    this.voice.say('summary', news ? `${said}${change === '' ? '' : ` ${change}`}` : undefined);
  }

  private fail(error: unknown): void {
    this.toggleAttribute('data-busy', false);
    if (!this.computed) this.parts.readout.textContent = '';
    this.parts.trouble.textContent = error instanceof Error ? error.message : String(error);
    this.parts.trouble.hidden = false;
  }

  private draw(): void {
    const { computed, state, layers, extra, panel, editor } = this;
    const question = this.question();
    this.parts.remove.disabled = !editor.selected;
    this.parts.board.render({
      landmarks: question.landmarks,
      witnesses: state.witnesses,
      picture: computed?.picture,
      layers,
      extra,
      extraAt: question.extra,
      scale: computed?.scale,
      step: state.step,
      selected: editor.selected,
      pen: this.focused && editor.editable && !editor.selected ? editor.pen : undefined,
      asked: landmarksNamed(state.asked, question),
      answer: panel.answer,
    });
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'plane-sketch': PlaneSketchElement;
  }
}
