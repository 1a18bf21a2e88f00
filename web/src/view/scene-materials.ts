import {
  Color,
  DoubleSide,
  GLSL3,
  Matrix4,
  RawShaderMaterial,
  Vector2,
  Vector4,
  type IUniform,
  type Texture,
} from 'three';
import { MOST_AXES } from '../model/dimensions.ts';
import type { ShownFamily } from '../worker/protocol.ts';
import {
  EDGE_FRAGMENT,
  EDGE_VERTEX,
  LANDMARK_FRAGMENT,
  LANDMARK_VERTEX,
  TRIANGLE_FRAGMENT,
  TRIANGLE_VERTEX,
  WITNESS_FRAGMENT,
  WITNESS_VERTEX,
} from './shaders.ts';
import { sceneTheme } from './theme.ts';

const EDGE_WIDTH = 1.5;
const WITNESS_SIZE = 2.2;
const LANDMARK_SIZES: readonly [number, number] = [3.2, 11];

/** Uniforms that all materials read from one place. */
export interface SharedUniforms {
  readonly uPositions: IUniform<Texture | null>;
  readonly uBeyond: IUniform<Texture | null>;
  readonly uHasBeyond: IUniform<boolean>;
  readonly uAxes: IUniform<Matrix4>;
  readonly uAxesBeyond: IUniform<Matrix4>;
  readonly uStep: IUniform<number>;
  readonly uRecent: IUniform<number>;
  readonly uTrack: IUniform<number>;
  readonly uViewport: IUniform<Vector2>;
  readonly uDistance: IUniform<number>;
  readonly uHaze: IUniform<number>;
  readonly uBackground: IUniform<Color>;
  readonly uAccent: IUniform<Color>;
  readonly uByAge: IUniform<number>;
  readonly uCut: IUniform<Vector4>;
  readonly uShown: IUniform<Vector2>;
}

function setAxes(matrix: Matrix4, rows: Float32Array, first: number): void {
  const row = (i: number): number[] => [...rows.subarray(i * MOST_AXES + first, i * MOST_AXES + first + 4)];
  matrix.fromArray([...row(0), ...row(1), ...row(2), 0, 0, 0, 0]).transpose();
}

/** No point of the scene lies beyond this plane. */
export const NO_CUT = new Vector4(0, 0, 0, 1);

export interface SceneMaterials {
  readonly shared: SharedUniforms;
  readonly edge: RawShaderMaterial;
  readonly face: RawShaderMaterial;
  readonly surface: RawShaderMaterial;
  readonly witness: RawShaderMaterial;
  readonly landmark: RawShaderMaterial;
  /** Diameter of a landmark in units of the scene. */
  readonly landmarkDiameter: IUniform<number>;
  /** What of the axes of the frame points right, up and towards the eye: rows as rowsOf() gives them. */
  project(rows: Float32Array): void;
  applyTheme(): void;
  /** Colors the complex by the family that is shown. */
  setFamily(family: ShownFamily): void;
  setPixelRatio(ratio: number): void;
  dispose(): void;
}

/** In the colors that hold at the element. */
export function createMaterials(styled: Element): SceneMaterials {
  const shared: SharedUniforms = {
    uPositions: { value: null },
    uBeyond: { value: null },
    uHasBeyond: { value: false },
    uAxes: { value: new Matrix4() },
    uAxesBeyond: { value: new Matrix4() },
    uStep: { value: 0 },
    uRecent: { value: 0 },
    uTrack: { value: 0 },
    uViewport: { value: new Vector2(1, 1) },
    uDistance: { value: 1 },
    uHaze: { value: 1 },
    uBackground: { value: new Color() },
    uAccent: { value: new Color() },
    uByAge: { value: 0 },
    uCut: { value: NO_CUT.clone() },
    uShown: { value: new Vector2(1, 1) },
  };
  const edgeColor = { value: new Color() };
  const edgeWidth = { value: EDGE_WIDTH };
  const line = { value: new Color() };
  const surfaceFront = { value: new Color() };
  const surfaceBack = { value: new Color() };
  const face = { value: new Color() };
  const witnessColor = { value: new Color() };
  const witnessAlpha = { value: 0.4 };
  const witnessSize = { value: WITNESS_SIZE };
  const landmarkColor = { value: new Color() };
  const landmarkDiameter = { value: 0 };
  const landmarkSizes = { value: new Vector2() };

  const material = (
    vertexShader: string,
    fragmentShader: string,
    own: Record<string, IUniform>,
  ): RawShaderMaterial =>
    new RawShaderMaterial({
      glslVersion: GLSL3,
      vertexShader,
      fragmentShader,
      uniforms: { ...shared, ...own },
      side: DoubleSide,
    });
  const edge = material(EDGE_VERTEX, EDGE_FRAGMENT, { uColor: edgeColor, uWidth: edgeWidth });
  edge.transparent = true;
  const surface = material(TRIANGLE_VERTEX, TRIANGLE_FRAGMENT, {
    uFront: surfaceFront,
    uBack: surfaceBack,
    uLine: line,
  });
  // Triangles of the complex have no outer side: both look alike.
  const faces = material(TRIANGLE_VERTEX, TRIANGLE_FRAGMENT, { uFront: face, uBack: face, uLine: edgeColor });
  const witness = material(WITNESS_VERTEX, WITNESS_FRAGMENT, {
    uColor: witnessColor,
    uAlpha: witnessAlpha,
    uSize: witnessSize,
  });
  witness.transparent = true;
  witness.depthWrite = false;
  const landmark = material(LANDMARK_VERTEX, LANDMARK_FRAGMENT, {
    uColor: landmarkColor,
    uDiameter: landmarkDiameter,
    uSizeRange: landmarkSizes,
  });
  // Dots of a few pixels are round only with smooth sides.
  landmark.transparent = true;
  const all = [edge, surface, faces, witness, landmark];

  let theme = sceneTheme(styled);
  let shown: ShownFamily = 'delaunay';
  const materials: SceneMaterials = {
    shared,
    edge,
    face: faces,
    surface,
    witness,
    landmark,
    landmarkDiameter,
    project(rows) {
      setAxes(shared.uAxes.value, rows, 0);
      setAxes(shared.uAxesBeyond.value, rows, 4);
    },
    applyTheme() {
      theme = sceneTheme(styled);
      materials.setFamily(shown);
      shared.uBackground.value.copy(theme.background);
      line.value.copy(theme.surfaceLine);
      surfaceFront.value.copy(theme.surface);
      surfaceBack.value.copy(theme.surfaceBack);
      witnessColor.value.copy(theme.witness);
      witnessAlpha.value = theme.witnessAlpha;
      landmarkColor.value.copy(theme.landmark);
      shared.uAccent.value.copy(theme.accent);
    },
    setFamily(family) {
      shown = family;
      edgeColor.value.copy(theme.edge[family]);
      face.value.copy(theme.face[family]);
    },
    setPixelRatio(ratio) {
      edgeWidth.value = EDGE_WIDTH * ratio;
      witnessSize.value = WITNESS_SIZE * ratio;
      landmarkSizes.value.set(LANDMARK_SIZES[0] * ratio, LANDMARK_SIZES[1] * ratio);
    },
    dispose() {
      for (const each of all) each.dispose();
    },
  };
  materials.applyTheme();
  return materials;
}
