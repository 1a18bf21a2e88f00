import type { WorkerEvent } from './protocol.ts';

/** The buffers of all typed arrays inside an event, to be transferred instead of copied. */
export function buffersOf(event: WorkerEvent): ArrayBuffer[] {
  const buffers: ArrayBuffer[] = [];
  const visit = (value: unknown): void => {
    if (ArrayBuffer.isView(value)) {
      if (value.buffer instanceof ArrayBuffer) buffers.push(value.buffer);
    } else if (typeof value === 'object' && value !== null) {
      Object.values(value).forEach(visit);
    }
  };
  visit(event);
  return buffers;
}
