import { progressInWords, scanInWords, StepRate } from '../model/forecast.ts';
import type { RunRecord } from '../model/record.ts';
import { byId, setNotice } from './dom.ts';

/** Words that change with every delta would flicker. */
const WORDS_EVERY_MS = 400;

/** Where the notes stand: the words on the progress, and those on a scan with the button that runs it to its end. */
export interface NotesParts {
  readonly computing: HTMLElement;
  readonly scan: HTMLElement;
  readonly words: HTMLElement;
  readonly toEnd: HTMLButtonElement;
}

function pageNotes(): NotesParts {
  return {
    computing: byId('computing', HTMLElement),
    scan: byId('scan', HTMLElement),
    words: byId('scan-words', HTMLElement),
    toEnd: byId('run-to-end', HTMLButtonElement),
  };
}

/** What the computation is doing: how far it is, what memory and time it takes, and where it will end by itself. */
export class RunNotes {
  private rate = new StepRate();
  private record: RunRecord | undefined;
  private readMs = 0;
  private wordsDue = 0;

  constructor(
    onRunToEnd: () => void,
    private readonly parts = pageNotes(),
  ) {
    parts.toEnd.addEventListener('click', onRunToEnd);
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
    const { record, parts } = this;
    if (!record) return;
    const now = performance.now();
    const computing = !record.ended;
    this.rate.see(now, record.stepCount);
    if (computing && now < this.wordsDue) return;
    this.wordsDue = now + WORDS_EVERY_MS;
    setNotice(parts.computing, computing ? progressInWords(record, this.rate.perSecond) : '');
    const words = scanInWords(record, this.readMs);
    if (parts.words.textContent !== words) parts.words.textContent = words;
    parts.scan.hidden = words === '';
    parts.toEnd.hidden = record.noise === 0;
  }
}
