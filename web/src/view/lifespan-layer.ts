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
 * appended, and deaths that come later, are uploaded as ranges; a step only sets how many instances are drawn.
 */
export class LifespanLayer {
  readonly group = new Group();
  private readonly drawn: DrawnChunk[] = [];

  constructor(
    private readonly store: LifespanStore,
    private readonly form: ElementForm,
    private readonly material: RawShaderMaterial,
  ) {}

  /** Uploads what the store has gained. */
  sync(): void {
    for (let i = this.drawn.length; i < this.store.chunks.length; ++i) {
      const chunk = this.store.chunks[i];
      if (chunk) this.drawn.push(this.added(chunk));
    }
    for (const { chunk, buffer } of this.drawn) {
      const dirty = chunk.takeDirty();
      if (!dirty) continue;
      buffer.addUpdateRange(dirty.from * chunk.stride, (dirty.to - dirty.from) * chunk.stride);
      buffer.needsUpdate = true;
    }
  }

  /** Draws what may live at the step or died after `recent`; the shader leaves out the dead among it. */
  show(step: number, track: number, recent: number): void {
    for (const { chunk, geometry, object } of this.drawn) {
      const born = chunk.bornBy(step);
      object.visible = born > 0 && (this.form === 'point' || chunk.outlives(track, recent));
      if (geometry instanceof InstancedBufferGeometry) geometry.instanceCount = born;
      else geometry.setDrawRange(0, born);
    }
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
    object.visible = false;
    this.group.add(object);
    // The first upload takes the whole buffer.
    chunk.takeDirty();
    return { chunk, buffer, geometry, object };
  }
}
