import type { Opened, RunOptions } from '../worker/protocol.ts';
import { byId } from './dom.ts';
import { parseList, positive, wholeFrom } from './entries.ts';
import { MetricSettings } from './metric-settings.ts';
import { COLORS } from './samples.ts';
import { isFamily, type SourceChoice } from './source.ts';

/** What a form of settings asks for. */
export interface Asked {
  readonly options: RunOptions;
  /** The sample with its size and noise; a file stays as it is. */
  readonly choice: SourceChoice;
}

/** Settings of the run and of the sample; a change asks for a new run. */
export class SettingsForm {
  private readonly family = byId('family', HTMLSelectElement);
  private readonly metric = new MetricSettings();
  private readonly nu = byId('nu', HTMLInputElement);
  private readonly first = byId('first', HTMLInputElement);
  private readonly rho = byId('rho', HTMLInputElement);
  private readonly maxSteps = byId('max-steps', HTMLInputElement);
  private readonly until = byId('until', HTMLInputElement);
  private readonly size = byId('size', HTMLInputElement);
  private readonly noise = byId('noise', HTMLInputElement);

  constructor(onChange: () => void) {
    const form = byId('settings', HTMLFormElement);
    form.addEventListener('submit', (event) => event.preventDefault());
    form.addEventListener('change', (event) => {
      // Each family has a ν of its own.
      if (event.target === this.family) this.nu.value = '';
      if (this.metric.needsWitness && this.family.value !== 'witness') this.family.value = '';
      onChange();
    });
  }

  /** Throws a sentence where an entry makes no sense. */
  asked(choice: SourceChoice): Asked {
    const nu = parseList(this.nu.value, 0, 'ν');
    const first = wholeFrom(0, this.first, 'The first landmark');
    const maxSteps = wholeFrom(1, this.maxSteps, 'Stop at N');
    const untilEpsilon = positive(this.until, 'Stop at ε');
    const rho = positive(this.rho, 'ρ');
    const options: RunOptions = {
      ...(isFamily(this.family.value) ? { family: this.family.value } : {}),
      ...this.metric.asked(),
      ...(nu.length > 0 ? { nu } : {}),
      ...(first === undefined ? {} : { first }),
      ...(maxSteps === undefined ? {} : { maxSteps }),
      ...(untilEpsilon === undefined ? {} : { untilEpsilon }),
      ...(rho === undefined ? {} : { rho }),
    };
    if (choice.kind === 'file') return { options, choice };
    const size = wholeFrom(1, this.size, 'Points') ?? choice.size;
    const noise = positive(this.noise, 'Noise');
    return {
      options,
      choice: { kind: 'sample', shape: choice.shape, size, ...(noise === undefined ? {} : { noise }) },
    };
  }

  /** Shows what was asked for, and what the run took where nothing was. */
  show(choice: SourceChoice, options: RunOptions, opened: Opened): void {
    const text = (value: number | undefined): string => (value === undefined ? '' : String(value));
    this.family.value = options.family ?? '';
    this.metric.show(options, opened);
    this.nu.value = options.nu?.join(', ') ?? '';
    this.nu.placeholder = opened.nu.join(', ');
    this.first.value = String(options.first ?? 0);
    this.first.max = String(opened.points - 1);
    this.rho.value = text(options.rho);
    this.maxSteps.value = text(options.maxSteps);
    this.until.value = text(options.untilEpsilon);
    const sampled = choice.kind === 'sample';
    byId('size-row', HTMLElement).hidden = !sampled;
    byId('noise-row', HTMLElement).hidden = !sampled || choice.shape === COLORS;
    this.size.value = sampled ? String(choice.size) : '';
    this.noise.value = sampled ? text(choice.noise) : '';
  }
}
