import type { Metric, Opened, RunOptions } from '../worker/protocol.ts';
import { byId } from './dom.ts';
import { numberList, positive, wholeFrom } from './entries.ts';

const METRICS: readonly string[] = [
  'euclidean',
  'l1',
  'linf',
  'angular',
  'projective',
  'periodic',
  'geodesic',
  'matrix',
] satisfies readonly Metric[];

function isMetric(text: string): text is Metric {
  return METRICS.includes(text);
}

type Chosen = Pick<RunOptions, 'metric' | 'knn' | 'box' | 'maxDimension' | 'field'>;

/** How far points are from each other, and over what their numbers are counted. */
export class MetricSettings {
  private readonly metric = byId('metric', HTMLSelectElement);
  private readonly knn = byId('knn', HTMLInputElement);
  private readonly box = byId('box', HTMLInputElement);
  private readonly lastBetti = byId('max-dimension', HTMLInputElement);
  private readonly field = byId('field', HTMLInputElement);

  /** Only family witness can do without Euclidean coordinates. */
  get needsWitness(): boolean {
    return this.metric.value !== 'euclidean';
  }

  /** The numbers that can be counted are those of the family. */
  forgetNumbers(): void {
    this.lastBetti.value = '';
  }

  /** Throws a sentence where an entry makes no sense. */
  asked(): Chosen {
    const { value } = this.metric;
    const metric = isMetric(value) && value !== 'euclidean' ? value : undefined;
    const knn = metric === 'geodesic' ? wholeFrom(1, this.knn, 'Neighbors') : undefined;
    const box = metric === 'periodic' ? numberList(this.box.value, 'The box') : [];
    const maxDimension = wholeFrom(1, this.lastBetti, 'The last Betti number');
    const field = positive(this.field, 'The field');
    return {
      ...(metric === undefined ? {} : { metric }),
      ...(knn === undefined ? {} : { knn }),
      ...(box.length > 0 ? { box } : {}),
      ...(maxDimension === undefined ? {} : { maxDimension }),
      ...(field === undefined ? {} : { field }),
    };
  }

  show(options: Chosen, opened: Opened): void {
    this.metric.value = opened.metric;
    // A matrix has no coordinates to measure otherwise, and coordinates are no matrix.
    for (const option of this.metric.options)
      option.disabled = (option.value === 'matrix') !== (opened.dimension === 0);
    this.knn.value = String(options.knn ?? '');
    this.box.value = options.box?.join(', ') ?? '';
    this.lastBetti.value = String(options.maxDimension ?? '');
    this.lastBetti.placeholder = String(opened.bettiCount - 1);
    this.field.value = String(options.field ?? '');
    const witness = opened.family === 'witness';
    const embedded = !witness && opened.family !== 'dilated';
    byId('knn-row', HTMLElement).hidden = opened.metric !== 'geodesic';
    byId('box-row', HTMLElement).hidden = opened.metric !== 'periodic';
    byId('max-dimension-row', HTMLElement).hidden = !witness;
    byId('field-row', HTMLElement).hidden = embedded;
  }
}
