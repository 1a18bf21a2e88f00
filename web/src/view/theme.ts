import { Color } from 'three';
import type { ShownFamily } from '../worker/protocol.ts';

/** The colors of the scene, as the style sheet gives them for light and dark. */
export interface SceneTheme {
  readonly background: Color;
  readonly surface: Color;
  readonly surfaceBack: Color;
  readonly surfaceLine: Color;
  /** Edges and triangles of the complex, in the hue of its family. */
  readonly face: Readonly<Record<ShownFamily, Color>>;
  readonly edge: Readonly<Record<ShownFamily, Color>>;
  readonly landmark: Color;
  readonly accent: Color;
  readonly witness: Color;
  readonly witnessAlpha: number;
}

/** The value of a CSS variable of the element. */
export function cssValue(element: Element, name: string): string {
  return getComputedStyle(element).getPropertyValue(name).trim();
}

/** As written, without the conversion to linear light: the shaders mix on-screen values. */
function color(element: Element, name: string): Color {
  const written = cssValue(element, name);
  const [, red = '80', green = '80', blue = '80'] = /^#(..)(..)(..)$/.exec(written) ?? [];
  return new Color().setRGB(parseInt(red, 16) / 255, parseInt(green, 16) / 255, parseInt(blue, 16) / 255);
}

function byFamily(element: Element, name: string): Record<ShownFamily, Color> {
  const delaunay = color(element, `${name}-delaunay`);
  const witness = color(element, `${name}-witness`);
  return { delaunay, witness, surface: delaunay, dilated: witness };
}

/** The colors that hold at the element. */
export function sceneTheme(element: Element): SceneTheme {
  return {
    background: color(element, '--stage'),
    surface: color(element, '--surface'),
    surfaceBack: color(element, '--surface-back'),
    surfaceLine: color(element, '--surface-line'),
    face: byFamily(element, '--face'),
    edge: byFamily(element, '--edge'),
    landmark: color(element, '--landmark'),
    accent: color(element, '--accent-landmark'),
    witness: color(element, '--witness'),
    witnessAlpha: Number(cssValue(element, '--witness-alpha')) || 0.4,
  };
}
