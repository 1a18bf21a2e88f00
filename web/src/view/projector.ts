import { Matrix4, Vector4, type PerspectiveCamera } from 'three';
import type { CloudFrame } from '../worker/protocol.ts';
import type { SharedUniforms } from './scene-materials.ts';

/** Where a point of the input is in the picture, in CSS pixels from its left and top, and how far from the eye. */
export type Projector = (index: number) => readonly [x: number, y: number, depth: number] | undefined;

/** What is nearer to the eye is not drawn. */
const NEAR = 0.02;

/** As the shaders do it; what is behind the eye or cut away is nowhere. */
export function projectorOf(
  { positions, beyond }: CloudFrame,
  { uAxes, uAxesBeyond, uCut }: SharedUniforms,
  camera: PerspectiveCamera,
  { clientWidth, clientHeight }: HTMLElement,
): Projector {
  const view = new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
  const place = new Vector4();
  const more = new Vector4();
  return (index) => {
    place.fromArray(positions, 4 * index).applyMatrix4(uAxes.value);
    if (beyond.length > 0) place.add(more.fromArray(beyond, 4 * index).applyMatrix4(uAxesBeyond.value));
    const { x, y, z } = uCut.value;
    if (place.x * x + place.y * y + place.z * z > uCut.value.w) return undefined;
    place.setW(1).applyMatrix4(view);
    if (place.w < NEAR) return undefined;
    return [
      ((place.x / place.w + 1) / 2) * clientWidth,
      ((1 - place.y / place.w) / 2) * clientHeight,
      place.w,
    ];
  };
}
