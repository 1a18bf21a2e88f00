import { DataTexture, FloatType, NearestFilter, RGBAFormat, Vector3, type PerspectiveCamera } from 'three';
import { FRAME_WIDTH } from '../worker/frame.ts';
import type { CloudFrame } from '../worker/protocol.ts';

export function textureRows(positions: Float32Array): number {
  return positions.length / (4 * FRAME_WIDTH);
}

/** Four numbers a point, in whole rows of points, as a texture. */
export function frameTexture(positions: Float32Array): DataTexture {
  const texture = new DataTexture(positions, FRAME_WIDTH, textureRows(positions), RGBAFormat, FloatType);
  texture.minFilter = texture.magFilter = NearestFilter;
  texture.needsUpdate = true;
  return texture;
}

type Triple = readonly [number, number, number];

/** From how far along `direction` all points are seen under at most the given slopes across and upright. */
function distanceFor(
  { outline }: CloudFrame,
  direction: Triple,
  across: Triple,
  upright: Triple,
  widest: number,
  tallest: number,
): number {
  let distance = 0.5;
  for (let i = 0; i < outline.length; i += 3) {
    const x = outline[i] ?? 0;
    const y = outline[i + 1] ?? 0;
    const z = outline[i + 2] ?? 0;
    const nearer = x * direction[0] + y * direction[1] + z * direction[2];
    const aside = Math.abs(x * across[0] + y * across[1] + z * across[2]) / widest;
    const above = Math.abs(x * upright[0] + y * upright[1] + z * upright[2]) / tallest;
    const needed = nearer + (aside > above ? aside : above);
    if (needed > distance) distance = needed;
  }
  return distance;
}

/**
 * From how far, along the direction, all points fill the part `fill` of what the camera sees; `fieldOfView` upright, in
 * degrees.
 */
export function fittingDistance(
  frame: CloudFrame,
  camera: PerspectiveCamera,
  direction: Vector3,
  fieldOfView: number,
  fill: number,
): number {
  const across = new Vector3().crossVectors(camera.up, direction).normalize();
  const upright = new Vector3().crossVectors(direction, across);
  const tallest = Math.tan((fieldOfView / 2) * (Math.PI / 180)) * fill;
  const widest = tallest * camera.aspect;
  return distanceFor(frame, direction.toArray(), across.toArray(), upright.toArray(), widest, tallest);
}
