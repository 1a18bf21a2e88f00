/** Elements in one chunk: large enough for few draw calls, small enough that a new one costs nothing. */
export const CHUNK_SIZE = 16_384;
const CHUNK_BITS = 14;
/** Elements whose changes are told as one range. */
const DIRTY_BITS = 8;
const DIRTY_BLOCKS = CHUNK_SIZE >>> DIRTY_BITS;
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
  /** What changed, block by block: late deaths lie far apart, and what lies between them need not go along. */
  private readonly dirtyFrom = new Uint16Array(DIRTY_BLOCKS).fill(CHUNK_SIZE);
  private readonly dirtyTo = new Uint16Array(DIRTY_BLOCKS);

  constructor(
    readonly stride: number,
    readonly deaths: number,
  ) {
    this.words = new Uint32Array(CHUNK_SIZE * stride);
    this.alive = new Array<number>(deaths).fill(0);
    this.lastDeath = new Array<number>(deaths).fill(0);
  }

  /** Writes `count` elements from place `at` on; they begin at element `from` of what is given. */
  write(
    at: number,
    count: number,
    from: number,
    vertices: Uint32Array,
    births: Uint32Array,
    deaths: readonly Uint32Array[],
  ): void {
    const { words, stride } = this;
    const width = stride - 1 - this.deaths;
    for (let i = 0; i < count; ++i) {
      const word = (at + i) * stride;
      for (let k = 0; k < width; ++k) words[word + k] = vertices[(from + i) * width + k] ?? 0;
      words[word + width] = births[from + i] ?? 0;
    }
    for (let track = 0; track < this.deaths; ++track) {
      const steps = deaths[track];
      let alive = 0;
      let last = this.lastDeath[track] ?? 0;
      for (let i = 0; i < count; ++i) {
        const step = steps?.[from + i] ?? 0;
        words[(at + i) * stride + width + 1 + track] = step;
        if (step === NEVER) ++alive;
        else if (step > last) last = step;
      }
      this.alive[track] = (this.alive[track] ?? 0) + alive;
      this.lastDeath[track] = last;
    }
    this.count = at + count;
    this.touch(at, at + count);
  }

  setDeath(at: number, track: number, step: number): void {
    this.words[at * this.stride + this.stride - this.deaths + track] = step;
    this.alive[track] = (this.alive[track] ?? 0) - 1;
    if (step > (this.lastDeath[track] ?? 0)) this.lastDeath[track] = step;
    this.touch(at, at + 1);
  }

  /** For the one view that mirrors this chunk: what changed since the last call, in ascending ranges. */
  takeDirty(): DirtyRange[] {
    const ranges: DirtyRange[] = [];
    for (let block = 0; block < DIRTY_BLOCKS; ++block) {
      const [from = 0, to = 0] = [this.dirtyFrom[block], this.dirtyTo[block]];
      if (from >= to) continue;
      const before = ranges.at(-1);
      if (before?.to === from) ranges[ranges.length - 1] = { from: before.from, to };
      else ranges.push({ from, to });
    }
    this.dirtyFrom.fill(CHUNK_SIZE);
    this.dirtyTo.fill(0);
    return ranges;
  }

  private touch(from: number, to: number): void {
    for (let at = from; at < to;) {
      const block = at >>> DIRTY_BITS;
      const end = Math.min(to, (block + 1) << DIRTY_BITS);
      if (at < (this.dirtyFrom[block] ?? 0)) this.dirtyFrom[block] = at;
      if (end > (this.dirtyTo[block] ?? 0)) this.dirtyTo[block] = end;
      at = end;
    }
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

  /** One element for each birth: its `vertices` input indices, and its death in each track. Births ascend. */
  append(vertices: Uint32Array, births: Uint32Array, deaths: readonly Uint32Array[]): void {
    for (let taken = 0; taken < births.length;) {
      const at = this.length & (CHUNK_SIZE - 1);
      if (at === 0) this.chunks.push(new LifespanChunk(this.stride, this.deaths));
      const count = Math.min(CHUNK_SIZE - at, births.length - taken);
      this.chunkOf(this.length).write(at, count, taken, vertices, births, deaths);
      this.length += count;
      taken += count;
    }
  }

  setDeath(index: number, track: number, step: number): void {
    this.chunkOf(index).setDeath(index & (CHUNK_SIZE - 1), track, step);
  }

  private chunkOf(index: number): LifespanChunk {
    const chunk = this.chunks[index >>> CHUNK_BITS];
    if (!chunk) throw new RangeError(`element ${index} of ${this.length}`);
    return chunk;
  }
}
