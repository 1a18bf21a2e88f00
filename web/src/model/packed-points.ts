/** Largest place on the grid along an axis. */
const LARGEST = 65_535;
/** What a link may grow to when it is unpacked: no more than a few dozen times its own length. */
const MOST_BYTES = 4_000_000;
const MALFORMED = 'The points in this link are damaged: it may have been cut off. Ask for it again.';

/** Points on a grid: coordinate k of a point is (origin[k] + place) · 2^exponent, exactly. */
export interface PackedPoints {
  readonly text: string;
  /** The step of the grid, in the units of the points. */
  readonly unit: number;
}

async function through(bytes: Uint8Array<ArrayBuffer>, stream: GenericTransformStream): Promise<Uint8Array> {
  const reader = (new Blob([bytes]).stream().pipeThrough(stream) as ReadableStream<Uint8Array>).getReader();
  const parts: Uint8Array[] = [];
  let length = 0;
  for (;;) {
    const { done, value } = await reader.read();
    if (done) break;
    length += value.length;
    if (length > MOST_BYTES) throw new Error(MALFORMED);
    parts.push(value);
  }
  const whole = new Uint8Array(length);
  let at = 0;
  for (const part of parts) {
    whole.set(part, at);
    at += part.length;
  }
  return whole;
}

function base64(bytes: Uint8Array): string {
  let text = '';
  for (const byte of bytes) text += String.fromCharCode(byte);
  return btoa(text).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
}

function bytesOf(text: string): Uint8Array<ArrayBuffer> {
  return Uint8Array.from(atob(text.replaceAll('-', '+').replaceAll('_', '/')), (sign) => sign.charCodeAt(0));
}

/** Rounds the points to 16 bits an axis and packs them into text for a link; nothing where their spread is no number. */
export async function packed(
  coordinates: Float64Array,
  dimension: number,
): Promise<PackedPoints | undefined> {
  const count = coordinates.length / dimension;
  const low = new Array<number>(dimension).fill(Infinity);
  let extent = 0;
  const high = new Array<number>(dimension).fill(-Infinity);
  coordinates.forEach((value, i) => {
    const axis = i % dimension;
    low[axis] = Math.min(low[axis] ?? Infinity, value);
    high[axis] = Math.max(high[axis] ?? -Infinity, value);
  });
  for (let axis = 0; axis < dimension; ++axis)
    extent = Math.max(extent, (high[axis] ?? 0) - (low[axis] ?? 0));
  const farthest = Math.max(...low.map(Math.abs), ...high.map(Math.abs));
  // One step of the grid less than fits, as both ends are rounded; and none finer than the numbers themselves.
  const exponent =
    extent > 0 ? Math.ceil(Math.max(Math.log2(extent / (LARGEST - 1)), Math.log2(farthest) - 52)) : 0;
  const unit = 2 ** exponent;
  if (!(unit > 0)) return undefined;
  const origin = low.map((value) => Math.round(value / unit));
  // Low bytes and high bytes of an axis stand together: the high ones compress.
  const bytes = new Uint8Array(2 * coordinates.length);
  coordinates.forEach((value, i) => {
    const [axis, point] = [i % dimension, Math.floor(i / dimension)];
    const place = Math.round(value / unit) - (origin[axis] ?? 0);
    bytes[2 * axis * count + point] = place & 0xff;
    bytes[(2 * axis + 1) * count + point] = place >> 8;
  });
  const data = base64(await through(bytes, new CompressionStream('deflate-raw')));
  return { text: [dimension, exponent, ...origin, data].join('.'), unit };
}

/** The points of a link as a table, a line a point, with all digits. Throws a sentence where they make no sense. */
export async function unpacked(
  text: string,
): Promise<{ readonly table: string; readonly dimension: number }> {
  const fields = text.split('.');
  const [dimension = 0, exponent = NaN] = fields.slice(0, 2).map(Number);
  const origin = fields.slice(2, 2 + dimension).map(Number);
  const data = fields[2 + dimension];
  const whole = [dimension, exponent, ...origin].every(Number.isSafeInteger);
  if (!whole || dimension < 1 || fields.length !== dimension + 3 || data === undefined)
    throw new Error(MALFORMED);
  let bytes: Uint8Array;
  try {
    bytes = await through(bytesOf(data), new DecompressionStream('deflate-raw'));
  } catch (cause) {
    throw new Error(MALFORMED, { cause });
  }
  const count = bytes.length / (2 * dimension);
  if (!Number.isInteger(count) || count < 1) throw new Error(MALFORMED);
  const unit = 2 ** exponent;
  const rows = Array.from({ length: count }, (_, point) =>
    origin
      .map((first, axis) => {
        const place =
          (bytes[2 * axis * count + point] ?? 0) + 256 * (bytes[(2 * axis + 1) * count + point] ?? 0);
        return (first + place) * unit;
      })
      .join(','),
  );
  return { table: `${rows.join('\n')}\n`, dimension };
}
