import { cssValue } from './theme.ts';

/** From where the shape is first seen, as in the stage: across, upright, and towards the eye. */
const VIEW = [
  [0.857, 0.514, 0],
  [-0.331, 0.552, 0.765],
  [0.394, -0.656, 0.644],
] as const;
const PLANE = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
] as const;

/** Draws points into a small canvas, the nearer ones darker; its size is that of its box on the page. */
export function previewOf(
  canvas: HTMLCanvasElement,
  coordinates: Float64Array | Float32Array,
  dimension: number,
): void {
  const context = canvas.getContext('2d');
  const { clientWidth: width, clientHeight: height } = canvas;
  if (!context || width === 0 || height === 0) return;
  const axes = dimension === 2 ? PLANE : VIEW;
  const count = coordinates.length / dimension;
  const placed = Array.from({ length: count }, (_, i) =>
    axes.map((axis) => {
      let sum = 0;
      for (let k = 0; k < dimension; ++k) sum += (axis[k] ?? 0) * (coordinates[i * dimension + k] ?? 0);
      return sum;
    }),
  ).sort((a, b) => (a[2] ?? 0) - (b[2] ?? 0));
  const bounds = axes.map((_, k) => {
    let [low, high] = [Infinity, -Infinity];
    for (const point of placed) {
      low = Math.min(low, point[k] ?? 0);
      high = Math.max(high, point[k] ?? 0);
    }
    return { middle: (low + high) / 2, extent: high - low || 1 };
  });
  const [across, upright, depth] = bounds;
  if (!across || !upright || !depth) return;
  const ratio = Math.min(window.devicePixelRatio, 2);
  canvas.width = width * ratio;
  canvas.height = height * ratio;
  context.scale(ratio, ratio);
  const zoom = 0.86 * Math.min(width / across.extent, height / upright.extent);
  context.fillStyle = cssValue(canvas, '--preview');
  for (const [x = 0, y = 0, z = 0] of placed) {
    const near = dimension === 2 ? 1 : 0.5 + (z - depth.middle) / depth.extent;
    context.globalAlpha = 0.22 + 0.7 * near;
    const size = 1.1 + 0.8 * near;
    context.fillRect(
      width / 2 + (x - across.middle) * zoom - size / 2,
      height / 2 - (y - upright.middle) * zoom - size / 2,
      size,
      size,
    );
  }
}
