import {
  amplitudeWarning,
  binInWords,
  pumpHistogram,
  pumpsInWords,
  type PumpHistogram,
} from '../model/pump-histogram.ts';
import { grouped } from '../model/numbers.ts';
import type { RunRecord } from '../model/record.ts';
import { drawPumps } from '../view/pump-chart.ts';
import { byId, setNotice } from './dom.ts';

/** What pumping did, for runs that do it: in words, as bars and as a table. */
export class PumpPanel {
  private readonly panel = byId('pumps', HTMLDetailsElement);
  private readonly words = byId('pump-words', HTMLElement);
  private readonly warning = byId('pump-warning', HTMLElement);
  private readonly chart = byId('pump-chart', SVGSVGElement);
  private readonly rows = byId('pump-rows', HTMLElement);
  private readonly thresholds = byId('pump-thresholds', HTMLElement);
  private shown: RunRecord | undefined;
  private shownCount = 0;

  show(record: RunRecord): void {
    this.panel.hidden = record.pumpCount === 0;
    if (record === this.shown && record.pumpCount === this.shownCount) return;
    this.shown = record;
    this.shownCount = record.pumpCount;
    const histogram = pumpHistogram(record);
    if (histogram) this.draw(histogram);
  }

  private draw(histogram: PumpHistogram): void {
    this.words.textContent = pumpsInWords(histogram);
    setNotice(this.warning, amplitudeWarning(histogram));
    drawPumps(this.chart, histogram);
    const { bins, thresholds } = histogram;
    this.thresholds.textContent = grouped(thresholds);
    this.rows.replaceChildren(
      ...bins.map(({ before, after }, i) => {
        const row = document.createElement('tr');
        const head = document.createElement('th');
        head.scope = 'row';
        head.textContent = binInWords(bins, i);
        row.append(head);
        for (const count of [before, after]) {
          const cell = document.createElement('td');
          cell.textContent = String(count);
          row.append(cell);
        }
        return row;
      }),
    );
  }
}
