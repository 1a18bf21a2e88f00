import { progressInWords, scanInWords, StepRate } from '../model/forecast.ts';
import type { RunRecord } from '../model/record.ts';
import { byId, setNotice } from './dom.ts';

/** Words that change with every delta would flicker. */
const WORDS_EVERY_MS = 400;

/** What the computation is doing: how far it is, what memory and time it takes, and where it will end by itself. */
export class RunNotes {
  private readonly computing = byId('computing', HTMLElement);
  private readonly scan = byId('scan', HTMLElement);
  private readonly words = byId('scan-words', HTMLElement);
  private readonly toEnd = byId('run-to-end', HTMLButtonElement);
  private rate = new StepRate();
  private record: RunRecord | undefined;
  private readMs = 0;
  private wordsDue = 0;

  constructor(onRunToEnd: () => void) {
    this.toEnd.addEventListener('click', onRunToEnd);
  }

  /** A new run; its source was read in so many milliseconds. */
  begin(record: RunRecord, readMs: number): void {
    this.record = record;
    this.readMs = readMs;
    this.rate = new StepRate();
    this.wordsDue = 0;
    this.show();
  }

  /** The run has grown, ended, or goes on. */
  show(): void {
    const { record } = this;
    if (!record) return;
    const now = performance.now();
    const computing = !record.ended;
    this.rate.see(now, record.stepCount);
    if (computing && now < this.wordsDue) return;
    this.wordsDue = now + WORDS_EVERY_MS;
    setNotice(this.computing, computing ? progressInWords(record, this.rate.perSecond) : '');
    const words = scanInWords(record, this.readMs);
    if (this.words.textContent !== words) this.words.textContent = words;
    this.scan.hidden = words === '';
    this.toEnd.hidden = record.noise === 0;
  }
}
