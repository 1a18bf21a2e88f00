import { Quaternion, Spherical, Vector3 } from 'three';

/** Turns the offset of an eye from what it looks at by parts of a full turn, never over the poles. */
export function orbit(offset: Vector3, up: Vector3, across: number, upright: number): void {
  const toUp = new Quaternion().setFromUnitVectors(up, new Vector3(0, 1, 0));
  const place = new Spherical().setFromVector3(offset.applyQuaternion(toUp));
  place.theta -= 2 * Math.PI * across;
  place.phi += 2 * Math.PI * upright;
  offset.setFromSpherical(place.makeSafe()).applyQuaternion(toUp.invert());
}
