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

/** The value of a CSS variable of the page. */
export function cssValue(name: string): string {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}

/** As written, without the conversion to linear light: the shaders mix on-screen values. */
function color(name: string): Color {
  const [, red = '80', green = '80', blue = '80'] = /^#(..)(..)(..)$/.exec(cssValue(name)) ?? [];
  return new Color().setRGB(parseInt(red, 16) / 255, parseInt(green, 16) / 255, parseInt(blue, 16) / 255);
}

function byFamily(name: string): Record<ShownFamily, Color> {
  const delaunay = color(`${name}-delaunay`);
  const witness = color(`${name}-witness`);
  return { delaunay, witness, surface: delaunay, dilated: witness };
}

export function sceneTheme(): SceneTheme {
  return {
    background: color('--stage'),
    surface: color('--surface'),
    surfaceBack: color('--surface-back'),
    surfaceLine: color('--surface-line'),
    face: byFamily('--face'),
    edge: byFamily('--edge'),
    landmark: color('--landmark'),
    accent: color('--accent-landmark'),
    witness: color('--witness'),
    witnessAlpha: Number(cssValue('--witness-alpha')) || 0.4,
  };
}
