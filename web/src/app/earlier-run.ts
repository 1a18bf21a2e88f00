import { cardWords, type PlateauCard } from '../model/plateau-cards.ts';
import type { RunRecord } from '../model/record.ts';
import type { Opened, RunOptions } from '../worker/protocol.ts';
import { byId } from './dom.ts';
import type { RunFeed } from './run-feed.ts';
import type { SourceChoice } from './source.ts';

const MOST_LINES = 4;

/** A run as it was shown: where it came from, how it was asked for and what it saw. */
export interface ShownRun {
  readonly choice: SourceChoice;
  readonly options: RunOptions;
  readonly opened: Opened;
  readonly record: RunRecord;
  readonly feed: RunFeed;
  readonly cards: readonly PlateauCard[];
}

/** The same points, possibly drawn anew from the same shape: what two runs of them see can be compared. */
export function sameShape(a: SourceChoice, b: SourceChoice): boolean {
  if (a.kind === 'sample') return b.kind === 'sample' && a.shape === b.shape;
  return b.kind === 'file' && a.file === b.file && a.columns?.join() === b.columns?.join();
}

function pumpingOf({ pump, omegaBar, zeta2, sliver }: RunOptions): string {
  if (!pump) return 'no pumping';
  const parts = ['pumping', sliver === 'normalized' ? 'normalized' : ''];
  if (omegaBar !== undefined) parts.push(`ω̄ ${omegaBar}`);
  if (zeta2 !== undefined) parts.push(`ζ₂ ${zeta2}`);
  return parts.filter(Boolean).join(' ');
}

/** The very same points. */
export function samePoints(a: SourceChoice, b: SourceChoice): boolean {
  if (!sameShape(a, b)) return false;
  if (a.kind === 'file' || b.kind === 'file') return true;
  return a.size === b.size && (a.noise ?? 0) === (b.noise ?? 0);
}

/** Every setting in words, in the order of the form. */
function settingsOf({ choice, options, opened }: ShownRun): string[] {
  const sampled = choice.kind === 'sample' ? choice : undefined;
  return [
    opened.family === 'auto' ? 'automatic family' : `family ${opened.family}`,
    opened.family === 'dilated' ? '' : `ν ${opened.nu.join(', ')}`,
    opened.family === 'dilated' ? `dilation ${options.dilation ?? 0.2}` : '',
    pumpingOf(options),
    `Z/${opened.field}`,
    `first landmark ${options.first ?? 0}`,
    `ρ ${options.rho ?? 'off'}`,
    options.maxSteps === undefined ? 'all landmarks' : `stop at N ${options.maxSteps}`,
    `stop at ε ${options.untilEpsilon ?? 0}`,
    options.minLength === undefined ? 'no stop at plateaus' : `stop at length ${options.minLength}`,
    sampled ? `${sampled.size} points` : '',
    `noise ${sampled?.noise ?? 0}`,
  ];
}

/** What the earlier run had set otherwise. */
function differences(earlier: ShownRun, now: ShownRun): string[] {
  const set = settingsOf(now);
  return settingsOf(earlier).filter((setting, i) => setting !== '' && setting !== set[i]);
}

/** The plateaus before the last change of settings stay in sight, so that both can be compared. */
export class EarlierRun {
  private readonly box = byId('earlier', HTMLElement);
  private readonly title = byId('earlier-title', HTMLElement);
  private readonly lines = byId('earlier-lines', HTMLElement);

  /** Returns the cards to draw beside those of `now`: none if there is nothing to compare. */
  show(earlier: ShownRun | undefined, now: ShownRun | undefined): readonly PlateauCard[] {
    const differing =
      earlier && now && sameShape(earlier.choice, now.choice) ? differences(earlier, now) : [];
    this.box.hidden = differing.length === 0;
    if (!earlier || differing.length === 0) return [];
    this.title.textContent = `Before: ${differing.join(' · ')}`;
    const lines = earlier.cards.slice(0, MOST_LINES).map((card) => {
      const { shape, scale } = cardWords(card);
      return `${shape}, ${scale}`;
    });
    this.lines.replaceChildren(
      ...(lines.length > 0 ? lines : ['no plateau']).map((line) => {
        const item = document.createElement('li');
        item.textContent = line;
        return item;
      }),
    );
    return earlier.cards;
  }
}
