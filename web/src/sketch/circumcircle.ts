import type { Point } from './points.ts';

/** The circle through three points; undefined where they lie on a line, or are not three. For drawing alone. */
export function circumcircle(corners: readonly Point[]): (Point & { readonly radius: number }) | undefined {
  const [a, b, c] = corners;
  if (!a || !b || !c || corners.length > 3) return undefined;
  const [bx, by, cx, cy] = [b.x - a.x, b.y - a.y, c.x - a.x, c.y - a.y];
  const twiceArea = bx * cy - by * cx;
  if (twiceArea === 0) return undefined;
  const [b2, c2] = [bx * bx + by * by, cx * cx + cy * cy];
  const x = (cy * b2 - by * c2) / (2 * twiceArea);
  const y = (bx * c2 - cx * b2) / (2 * twiceArea);
  return { x: a.x + x, y: a.y + y, radius: Math.hypot(x, y) };
}
