/** Elements in one chunk: large enough for few draw calls, small enough that a new one costs nothing. */
export const CHUNK_SIZE = 16_384;
const CHUNK_BITS = 14;
/** The death of what still lives, as in the protocol. */
export const NEVER = 0xffffffff;

/** Appends without copying what is there. Values are found by index across chunks. */
export class ChunkedColumn<T extends Uint8Array | Uint32Array | Float64Array> {
  private readonly chunks: T[] = [];
  length = 0;

  constructor(private readonly allocate: (length: number) => T) {}

  append(values: T): void {
    let taken = 0;
    while (taken < values.length) {
      const at = this.length & (CHUNK_SIZE - 1);
      let chunk = this.chunks[this.length >>> CHUNK_BITS];
      if (!chunk) {
        chunk = this.allocate(CHUNK_SIZE);
        this.chunks.push(chunk);
      }
      const count = Math.min(CHUNK_SIZE - at, values.length - taken);
      chunk.set(values.subarray(taken, taken + count), at);
      this.length += count;
      taken += count;
    }
  }

  /** The index must be below `length`. */
  at(index: number): number {
    const value = this.chunks[index >>> CHUNK_BITS]?.[index & (CHUNK_SIZE - 1)];
    if (value === undefined) throw new RangeError(`index ${index} of ${this.length}`);
    return value;
  }
}

/** A range of elements of a chunk that changed since it was last taken: [from, to). */
export interface DirtyRange {
  readonly from: number;
  readonly to: number;
}

/**
 * Up to CHUNK_SIZE elements with lifespans, as rows of 32-bit words that a graphics card can read as they are:
 * `vertices` words (input indices of the landmarks), the birth, and `deaths` words.
 */
export class LifespanChunk {
  readonly words: Uint32Array<ArrayBuffer>;
  count = 0;
  /** Still alive, by track, and the last death of the others: a chunk that is dead as a whole need not be drawn. */
  readonly alive: number[];
  readonly lastDeath: number[];
  private dirtyFrom = CHUNK_SIZE;
  private dirtyTo = 0;

  constructor(
    readonly stride: number,
    readonly deaths: number,
  ) {
    this.words = new Uint32Array(CHUNK_SIZE * stride);
    this.alive = new Array<number>(deaths).fill(0);
    this.lastDeath = new Array<number>(deaths).fill(0);
  }

  touch(index: number): void {
    this.dirtyFrom = Math.min(this.dirtyFrom, index);
    this.dirtyTo = Math.max(this.dirtyTo, index + 1);
  }

  /** For the one view that mirrors this chunk: what changed since the last call. */
  takeDirty(): DirtyRange | undefined {
    if (this.dirtyFrom >= this.dirtyTo) return undefined;
    const range = { from: this.dirtyFrom, to: this.dirtyTo };
    this.dirtyFrom = CHUNK_SIZE;
    this.dirtyTo = 0;
    return range;
  }

  /** Elements born by the step; births ascend. */
  bornBy(step: number): number {
    const birthAt = this.stride - this.deaths - 1;
    let low = 0;
    let high = this.count;
    while (low < high) {
      const middle = (low + high) >>> 1;
      if ((this.words[middle * this.stride + birthAt] ?? 0) <= step) low = middle + 1;
      else high = middle;
    }
    return low;
  }

  /** May an element of the track live at the step or later? */
  outlives(track: number, step: number): boolean {
    return (this.alive[track] ?? 0) > 0 || (this.lastDeath[track] ?? 0) > step;
  }
}

/** All elements of one kind that ever lived, in order of birth. */
export class LifespanStore {
  readonly chunks: LifespanChunk[] = [];
  length = 0;

  constructor(
    readonly vertices: number,
    readonly deaths: number,
  ) {}

  get stride(): number {
    return this.vertices + 1 + this.deaths;
  }

  /** `vertex(k)` and `death(track)` are asked for the element that is appended. */
  append(vertex: (k: number) => number, birth: number, death: (track: number) => number): void {
    const at = this.length & (CHUNK_SIZE - 1);
    if (at === 0) this.chunks.push(new LifespanChunk(this.stride, this.deaths));
    const chunk = this.chunkOf(this.length);
    const word = at * this.stride;
    for (let k = 0; k < this.vertices; ++k) chunk.words[word + k] = vertex(k);
    chunk.words[word + this.vertices] = birth;
    for (let track = 0; track < this.deaths; ++track) {
      const step = death(track);
      chunk.words[word + this.vertices + 1 + track] = step;
      if (step === NEVER) chunk.alive[track] = (chunk.alive[track] ?? 0) + 1;
      else chunk.lastDeath[track] = Math.max(chunk.lastDeath[track] ?? 0, step);
    }
    chunk.count = at + 1;
    chunk.touch(at);
    ++this.length;
  }

  setDeath(index: number, track: number, step: number): void {
    const chunk = this.chunkOf(index);
    const at = index & (CHUNK_SIZE - 1);
    chunk.words[at * this.stride + this.vertices + 1 + track] = step;
    chunk.alive[track] = (chunk.alive[track] ?? 0) - 1;
    chunk.lastDeath[track] = Math.max(chunk.lastDeath[track] ?? 0, step);
    chunk.touch(at);
  }

  private chunkOf(index: number): LifespanChunk {
    const chunk = this.chunks[index >>> CHUNK_BITS];
    if (!chunk) throw new RangeError(`element ${index} of ${this.length}`);
    return chunk;
  }
}
