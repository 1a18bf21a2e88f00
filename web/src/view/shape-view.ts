import {
  BufferGeometry,
  type DataTexture,
  Group,
  Mesh,
  PerspectiveCamera,
  Points,
  Scene,
  Vector3,
  WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { FIRST_AXES, rowsOf } from '../model/dimensions.ts';
import type { RunRecord } from '../model/record.ts';
import { FRAME_WIDTH } from '../worker/frame.ts';
import type { CloudFrame } from '../worker/protocol.ts';
import { fittingDistance, frameTexture, textureRows } from './cloud-frame.ts';
import { GpuPace } from './gpu-pace.ts';
import { orbit } from './orbit.ts';
import { LifespanLayer } from './lifespan-layer.ts';
import { projectorOf, type Projector } from './projector.ts';
import { createMaterials, NO_CUT, type SceneMaterials } from './scene-materials.ts';

const FIELD_OF_VIEW = 32;
/** How much of the stage the cloud takes. */
const FILL = 0.86;
/** A landmark is drawn this large compared to ε: dots that touch no neighbor. */
const LANDMARK_SHARE = 0.3;

/** So long the first picture of a cloud waits for its first landmarks: a slow card would draw all points twice. */
const HOLD_MS = 400;
/** Buffers that one picture uploads, in bytes: more would hold the page up. */
const BYTES_A_PICTURE = 1_500_000;

/** What of the shape is drawn. */
export interface ShownLayers {
  readonly witnesses: boolean;
  readonly landmarks: boolean;
  readonly edges: boolean;
  readonly faces: boolean;
}

/** A plane across an axis; `place` goes from -1 to 1 through the cloud, what lies beyond it is cut away. */
export interface Section {
  readonly axis: 0 | 1 | 2;
  readonly place: number;
}

/** Why there is no picture: the browser has taken the card away, or the card has no textures for so many points. */
export type ShapeTrouble = 'lost' | 'crowded';

/** Draws a record at a step: orbit with the pointer, drawn only when something changed. Throws without WebGL 2. */
export class ShapeView {
  private readonly renderer: WebGLRenderer;
  private readonly camera = new PerspectiveCamera(FIELD_OF_VIEW, 1, 0.02, 100);
  /** Tell when the eye has moved: see LinkedCameras. */
  readonly controls: OrbitControls;
  private readonly scene = new Scene();
  private readonly materials: SceneMaterials;
  private readonly resizing: ResizeObserver;
  private record: RunRecord | undefined;
  private frame: CloudFrame | undefined;
  private textures: DataTexture[] = [];
  private witnesses: Points | undefined;
  private layers:
    | { points: LifespanLayer; edges: LifespanLayer; triangles: LifespanLayer; rows: LifespanLayer }
    | undefined;
  private renderRequest = 0;
  private readonly pace: GpuPace;
  private lost = false;
  /** The next picture has buffers to upload. */
  private loaded = false;
  /** More was gained than it carries. */
  private behind = false;
  private compiled = false;
  private held: ReturnType<typeof setTimeout> | undefined;
  private readonly listening = new AbortController();
  private shown: ShownLayers = { witnesses: true, landmarks: true, edges: true, faces: true };

  /**
   * `onView` is told the units of the input that a pixel shows in the middle of the shape, `onTrouble` why there
   * is no picture, or that there is one again.
   */
  constructor(
    private readonly container: HTMLElement,
    private readonly onView: (unitsPerPixel: number) => void,
    private readonly onTrouble: (trouble: ShapeTrouble | undefined) => void,
  ) {
    this.renderer = new WebGLRenderer({ antialias: true, alpha: true });
    this.materials = createMaterials(container);
    this.pace = new GpuPace(this.renderer.getContext());
    const changed = (lost: boolean): void => {
      this.lost = lost;
      this.pace.dispose();
      onTrouble(lost ? 'lost' : undefined);
      this.requestRender();
    };
    const { signal } = this.listening;
    this.renderer.domElement.addEventListener('webglcontextlost', () => changed(true), { signal });
    this.renderer.domElement.addEventListener('webglcontextrestored', () => changed(false), { signal });
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.renderer.domElement.setAttribute('aria-hidden', 'true');
    container.append(this.renderer.domElement);
    this.controls = new OrbitControls(this.camera, this.renderer.domElement);
    this.controls.addEventListener('change', () => this.requestRender());
    this.controls.minDistance = 0.4;
    this.controls.maxDistance = 30;
    this.resizing = new ResizeObserver(() => this.resize());
    this.resizing.observe(container);
    this.resize();
    void this.compile();
  }

  /** The shaders compile beside the page: a first picture that waits for them would hold it up. */
  private async compile(): Promise<void> {
    const { edge, face, surface, witness, landmark } = this.materials;
    const geometry = new BufferGeometry();
    const all = new Group();
    for (const material of [edge, face, surface]) all.add(new Mesh(geometry, material));
    for (const material of [witness, landmark]) all.add(new Points(geometry, material));
    for (const object of all.children) object.frustumCulled = false;
    await this.renderer.compileAsync(all, this.camera);
    if (this.listening.signal.aborted) return;
    // Draws nothing, but asks the card about programs and textures now, while it has nothing else to do: later each
    // question would wait until all is drawn that was asked for before.
    const texture = frameTexture(new Float32Array(4 * FRAME_WIDTH));
    this.renderer.initTexture(texture);
    this.renderer.render(all, this.camera);
    texture.dispose();
    geometry.dispose();
    this.compiled = true;
    this.requestRender();
  }

  /** Shows another record from its first step on, from a fresh view point. */
  setRecord(record: RunRecord): void {
    this.clear();
    const { axes, positions, beyond } = record.frame;
    const crowded = textureRows(positions) > this.renderer.capabilities.maxTextureSize;
    if (!this.lost) this.onTrouble(crowded ? 'crowded' : undefined);
    this.record = this.frame = undefined;
    this.requestRender();
    if (crowded) return;
    this.record = record;
    this.frame = record.frame;
    const { shared } = this.materials;
    this.textures = [frameTexture(positions)];
    if (beyond.length > 0) this.textures.push(frameTexture(beyond));
    shared.uPositions.value = this.textures[0] ?? null;
    shared.uBeyond.value = this.textures[1] ?? null;
    shared.uHasBeyond.value = beyond.length > 0;
    this.project(rowsOf(axes, FIRST_AXES, 0));
    shared.uHaze.value = record.frame.axes <= 2 ? 0 : 1;
    const geometry = new BufferGeometry();
    geometry.setDrawRange(0, record.frame.count);
    this.witnesses = new Points(geometry, this.materials.witness);
    this.witnesses.frustumCulled = false;
    this.layers = {
      points: new LifespanLayer(record.points, 'point', this.materials.landmark),
      edges: new LifespanLayer(record.edges, 'edge', this.materials.edge),
      triangles: new LifespanLayer(record.triangles, 'triangle', this.materials.face),
      rows: new LifespanLayer(record.rows, 'triangle', this.materials.surface),
    };
    const { points, edges, triangles, rows } = this.layers;
    // What is solid first, so that smooth sides and faint points blend with it.
    [rows, triangles, points, edges].forEach((layer, order) => {
      layer.group.renderOrder = order;
      this.scene.add(layer.group);
    });
    this.witnesses.renderOrder = 4;
    this.scene.add(this.witnesses);
    this.held = setTimeout(() => this.release(), HOLD_MS);
    this.fit();
  }

  private release(): void {
    clearTimeout(this.held);
    this.held = undefined;
    this.requestRender();
  }

  /** Takes over what the record has gained, as much as one picture can carry and the rest with the pictures after it. */
  sync(): void {
    if (!this.layers) return;
    // A slow card has not drawn yet what it was given before.
    this.behind = this.loaded;
    if (this.loaded) return;
    let left = BYTES_A_PICTURE;
    for (const layer of Object.values(this.layers)) left -= layer.sync(Math.max(0, left));
    this.loaded = left < BYTES_A_PICTURE;
    this.behind = left <= 0;
    this.showBusy();
    if (!this.loaded) return;
    // What is new lives at the step that is shown, too: a playhead that stands still asks for nothing.
    const { uStep, uRecent } = this.materials.shared;
    this.showStep(uStep.value, uRecent.value);
    this.requestRender();
  }

  private showBusy(): void {
    this.container.ariaBusy = String(this.loaded || this.behind);
  }

  /** Sets three uniforms and counts, uploads no geometry. What was born after `recent` glows, what died after it fades. */
  showStep(step: number, recent = step): void {
    if (!this.layers || !this.record || !this.frame || step < 1) return;
    const { family, track, epsilon } = this.record.summary(step);
    const { points, edges, triangles, rows } = this.layers;
    const onSurface = family === 'surface';
    this.materials.setFamily(family);
    this.materials.shared.uStep.value = step;
    this.materials.shared.uRecent.value = recent;
    this.materials.shared.uTrack.value = onSurface ? 0 : track;
    this.materials.landmarkDiameter.value = epsilon * this.frame.scale * LANDMARK_SHARE;
    const { landmarks, edges: sides, faces, witnesses } = this.shown;
    if (this.witnesses) this.witnesses.visible = witnesses;
    this.materials.shared.uShown.value.set(faces ? 1 : 0, sides ? 1 : 0);
    const since = Math.floor(recent);
    const draw = (layer: LifespanLayer, drawn: boolean, of = track): void =>
      drawn ? layer.show(step, of, since) : layer.hide();
    draw(points, landmarks, 0);
    // Edges of the surface are drawn with its triangles.
    draw(rows, onSurface && (faces || sides), 0);
    draw(edges, !onSurface && sides);
    draw(triangles, !onSurface && faces);
    this.release();
  }

  /** The same step a moment later. */
  glowSince(recent: number): void {
    if (this.materials.shared.uRecent.value === recent) return;
    this.materials.shared.uRecent.value = recent;
    this.requestRender();
  }

  setLayers(shown: ShownLayers): void {
    this.shown = shown;
    this.showStep(this.materials.shared.uStep.value);
  }

  /** By plateau: each family has its hue; by age: from the first landmark to the newest. */
  colorByAge(byAge: boolean): void {
    this.materials.shared.uByAge.value = byAge ? 1 : 0;
    this.requestRender();
  }

  /** What of the axes of the frame points right, up and towards the eye: rows as rowsOf() gives them. */
  project(rows: Float32Array): void {
    this.materials.project(rows);
    this.requestRender();
  }

  cutAt(section: Section | undefined): void {
    const cut = this.materials.shared.uCut.value.copy(NO_CUT);
    if (section) cut.set(0, 0, 0, section.place).setComponent(section.axis, 1);
    this.requestRender();
  }

  /** Looks at the whole cloud: in the plane from above, in space from a little above the side. */
  fit(): void {
    const { planar } = this;
    this.camera.up.set(0, planar ? 1 : 0, planar ? 0 : 1);
    this.controls.enableRotate = !planar;
    this.lookFrom(planar ? new Vector3(0, 0, 1) : new Vector3(0.45, -0.75, 0.62).normalize());
  }

  /** Whether the wheel brings the shape nearer; otherwise it scrolls what the shape is part of. */
  set wheelZooms(zooms: boolean) {
    this.controls.enableZoom = zooms;
  }

  /** The whole cloud from where the visitor has turned it. */
  frameAll(): void {
    this.lookFrom(this.camera.position.clone().sub(this.controls.target).normalize());
  }

  /** Where the eye is and what it looks at, in units of the frame. */
  get pose(): readonly number[] {
    return [...this.camera.position.toArray(), ...this.controls.target.toArray()];
  }

  set pose([x = 0, y = 0, z = 1, ...target]: readonly number[]) {
    this.camera.position.set(x, y, z);
    this.controls.target.set(target[0] ?? 0, target[1] ?? 0, target[2] ?? 0);
    this.controls.update();
    this.requestRender();
  }

  /** Turns the shape by parts of a full turn; in the plane, moves it by parts of what is seen. */
  turn(across: number, upright: number): void {
    const { target } = this.controls;
    const offset = this.camera.position.clone().sub(target);
    if (this.planar) {
      target.add(new Vector3(-across, -upright, 0).multiplyScalar(offset.length()));
    } else {
      orbit(offset, this.camera.up, across, upright);
    }
    this.camera.position.copy(target).add(offset);
    this.controls.update();
  }

  /** Nearer by a factor above 1. */
  zoom(factor: number): void {
    const { target } = this.controls;
    this.camera.position.sub(target).divideScalar(factor).add(target);
    this.controls.update();
  }

  /** Where points of the cloud are in the picture that was drawn last. */
  get projector(): Projector | undefined {
    return this.frame && projectorOf(this.frame, this.materials.shared, this.camera, this.container);
  }

  /** Reads the colors of the page again. */
  applyTheme(): void {
    this.materials.applyTheme();
    this.requestRender();
  }

  requestRender(): void {
    if (this.lost || !this.compiled || this.held !== undefined) return;
    this.renderRequest ||= requestAnimationFrame(() => {
      this.renderRequest = 0;
      this.pace.whenFree(() => this.render());
    });
  }

  private render(): void {
    const distance = this.camera.position.distanceTo(this.controls.target);
    this.materials.shared.uDistance.value = distance;
    this.renderer.render(this.scene, this.camera);
    this.pace.submitted();
    this.loaded = false;
    if (this.behind) this.sync();
    this.showBusy();
    const seen = 2 * distance * Math.tan((FIELD_OF_VIEW / 2) * (Math.PI / 180));
    if (this.frame) this.onView(seen / this.container.clientHeight / this.frame.scale);
  }

  /** The picture, to be copied at once: what the card has drawn is gone when it has been shown. */
  picture(): HTMLCanvasElement | undefined {
    if (this.lost || !this.compiled || !this.record) return undefined;
    this.renderer.render(this.scene, this.camera);
    return this.renderer.domElement;
  }

  /** Gives back the graphics card too: browsers allow few contexts on a page. */
  dispose(): void {
    this.listening.abort();
    cancelAnimationFrame(this.renderRequest);
    this.pace.dispose();
    this.resizing.disconnect();
    this.clear();
    this.controls.dispose();
    this.materials.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
    this.renderer.domElement.remove();
  }

  private get planar(): boolean {
    return (this.frame?.axes ?? 3) <= 2;
  }

  private lookFrom(direction: Vector3): void {
    this.controls.target.set(0, 0, 0);
    const distance = this.frame
      ? fittingDistance(this.frame, this.camera, direction, FIELD_OF_VIEW, FILL)
      : 1;
    this.camera.position.copy(direction.clone().multiplyScalar(distance));
    this.controls.update();
    this.requestRender();
  }

  private clear(): void {
    clearTimeout(this.held);
    this.held = undefined;
    if (this.layers) for (const layer of Object.values(this.layers)) layer.dispose();
    this.witnesses?.geometry.dispose();
    for (const texture of this.textures) texture.dispose();
    this.textures = [];
    this.materials.shared.uStep.value = 0;
    this.scene.clear();
    this.layers = undefined;
    this.witnesses = undefined;
  }

  private resize(): void {
    const { clientWidth, clientHeight } = this.container;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.renderer.setSize(clientWidth, clientHeight);
    this.camera.aspect = clientWidth / clientHeight;
    this.camera.updateProjectionMatrix();
    this.renderer.getDrawingBufferSize(this.materials.shared.uViewport.value);
    this.materials.setPixelRatio(this.renderer.getPixelRatio());
    this.requestRender();
  }
}
