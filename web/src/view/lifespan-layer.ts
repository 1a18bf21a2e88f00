import {
  BufferAttribute,
  BufferGeometry,
  DynamicDrawUsage,
  Group,
  InstancedBufferGeometry,
  InstancedInterleavedBuffer,
  InterleavedBuffer,
  InterleavedBufferAttribute,
  Mesh,
  Points,
  type RawShaderMaterial,
} from 'three';
import type { LifespanChunk, LifespanStore } from '../model/chunks.ts';

/** What one element is drawn as: a strip between two points, a triangle, or a dot. */
export type ElementForm = 'edge' | 'triangle' | 'point';

interface DrawnChunk {
  readonly chunk: LifespanChunk;
  readonly buffer: InterleavedBuffer;
  readonly geometry: BufferGeometry;
  readonly object: Mesh | Points;
  /** Not yet on the graphics card: it is taken along with the next picture, drawn or not. */
  waiting: boolean;
}

function baseOf(form: 'edge' | 'triangle'): { corner: BufferAttribute; index: BufferAttribute } {
  return form === 'edge'
    ? {
        corner: new BufferAttribute(new Float32Array([0, -1, 0, 1, 1, 1, 1, -1]), 2),
        index: new BufferAttribute(new Uint16Array([0, 1, 2, 0, 2, 3]), 1),
      }
    : {
        corner: new BufferAttribute(new Float32Array([0, 1, 2]), 1),
        index: new BufferAttribute(new Uint16Array([0, 1, 2]), 1),
      };
}

/**
 * Mirrors a store on the graphics card, chunk by chunk: the words of the store are the vertex buffer. What is
 * appended, and deaths that come later, are uploaded as ranges with the next picture, also where they are not drawn;
 * a step only sets how many instances are drawn.
 */
export class LifespanLayer {
  readonly group = new Group();
  private readonly drawn: DrawnChunk[] = [];

  constructor(
    private readonly store: LifespanStore,
    private readonly form: ElementForm,
    private readonly material: RawShaderMaterial,
  ) {}

  /**
   * Readies what the store has gained for the next picture, up to about so many bytes; returns how many. What is left
   * waits for the next call.
   */
  sync(mostBytes: number): number {
    let bytes = 0;
    for (let i = this.drawn.length; i < this.store.chunks.length && bytes < mostBytes; ++i) {
      const chunk = this.store.chunks[i];
      if (!chunk) break;
      this.drawn.push(this.added(chunk));
      bytes += chunk.words.byteLength;
    }
    for (const one of this.drawn) {
      if (bytes >= mostBytes) break;
      const dirty = one.chunk.takeDirty();
      if (dirty.length === 0) continue;
      const { stride } = one.chunk;
      for (const { from, to } of dirty) {
        one.buffer.addUpdateRange(from * stride, (to - from) * stride);
        bytes += (to - from) * stride * Uint32Array.BYTES_PER_ELEMENT;
      }
      one.buffer.needsUpdate = true;
      this.wait(one);
    }
    return bytes;
  }

  /** Draws what may live at the step or died after `recent`; the shader leaves out the dead among it. */
  show(step: number, track: number, recent: number): void {
    for (const one of this.drawn) {
      const { chunk } = one;
      const born = chunk.bornBy(step);
      this.draw(one, this.form === 'point' || chunk.outlives(track, recent) ? born : 0);
    }
  }

  hide(): void {
    for (const one of this.drawn) this.draw(one, 0);
  }

  private draw({ geometry, object, waiting }: DrawnChunk, count: number): void {
    object.visible = waiting || count > 0;
    if (geometry instanceof InstancedBufferGeometry) geometry.instanceCount = count;
    else geometry.setDrawRange(0, count);
  }

  private wait(one: DrawnChunk): void {
    one.waiting = true;
    one.object.visible = true;
  }

  dispose(): void {
    for (const { geometry, object } of this.drawn) {
      geometry.dispose();
      object.removeFromParent();
    }
    this.drawn.length = 0;
  }

  private added(chunk: LifespanChunk): DrawnChunk {
    const instanced = this.form !== 'point';
    const buffer = instanced
      ? new InstancedInterleavedBuffer(chunk.words, chunk.stride)
      : new InterleavedBuffer(chunk.words, chunk.stride);
    buffer.setUsage(DynamicDrawUsage);
    const geometry = instanced ? new InstancedBufferGeometry() : new BufferGeometry();
    geometry.setAttribute('simplex', new InterleavedBufferAttribute(buffer, this.store.vertices + 1, 0));
    if (this.form !== 'point') {
      const { corner, index } = baseOf(this.form);
      geometry.setIndex(index);
      geometry.setAttribute('corner', corner);
      geometry.setAttribute(
        'death',
        new InterleavedBufferAttribute(buffer, this.store.deaths, this.store.vertices + 1),
      );
    }
    const object = instanced ? new Mesh(geometry, this.material) : new Points(geometry, this.material);
    object.frustumCulled = false;
    this.group.add(object);
    // The first upload takes the whole buffer.
    chunk.takeDirty();
    const one: DrawnChunk = { chunk, buffer, geometry, object, waiting: false };
    buffer.onUpload(() => {
      one.waiting = false;
    });
    this.draw(one, 0);
    this.wait(one);
    return one;
  }
}
