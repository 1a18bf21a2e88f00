import type { Opened, RunOptions } from '../worker/protocol.ts';
import { DilatedSettings } from './dilated-settings.ts';
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

/** Families other than witness follow what only points with few coordinates and Euclidean distances have. */
function mayTake(family: string, { dimension, metric }: Opened): boolean {
  const most: Readonly<Record<string, number>> = { surface: 3, delaunay: 3, dilated: 5 };
  const limit = most[family];
  if (limit === undefined) return true;
  return metric === 'euclidean' && dimension <= limit && dimension >= (family === 'surface' ? 3 : 2);
}

/** Settings of the run and of the sample; a change asks for a new run. */
export class SettingsForm {
  private readonly family = byId('family', HTMLSelectElement);
  private readonly metric = new MetricSettings();
  private readonly dilated = new DilatedSettings();
  private readonly nu = byId('nu', HTMLInputElement);
  private readonly first = byId('first', HTMLInputElement);
  private readonly rho = byId('rho', HTMLInputElement);
  private readonly rhoRow = byId('rho-row', HTMLElement);
  private readonly maxSteps = byId('max-steps', HTMLInputElement);
  private readonly until = byId('until', HTMLInputElement);
  private readonly minLength = byId('min-length', HTMLInputElement);
  private readonly size = byId('size', HTMLInputElement);
  private readonly noise = byId('noise', HTMLInputElement);

  /** Automatic means dilated where there are so many coordinates that no triangulation is followed. */
  private dimension = 0;

  /** `onChange` is told which setting was changed. */
  constructor(onChange: (place: Element) => void) {
    const form = byId('settings', HTMLFormElement);
    form.addEventListener('submit', (event) => event.preventDefault());
    form.addEventListener('change', (event) => {
      if (event.target === this.family) {
        // Each family has a ν of its own.
        this.nu.value = '';
        this.metric.forgetNumbers();
      }
      if (this.metric.needsWitness && this.family.value !== 'witness') this.family.value = '';
      const place = event.target instanceof Element ? event.target.closest('.setting') : null;
      onChange(place ?? form);
    });
  }

  private get isDilated(): boolean {
    const { value } = this.family;
    return !this.metric.needsWitness && (value === 'dilated' || (value === '' && this.dimension > 3));
  }

  /** Throws a sentence where an entry makes no sense. */
  asked(choice: SourceChoice): Asked {
    const nu = parseList(this.nu.value, 0, 'ν');
    const first = wholeFrom(0, this.first, 'The first landmark');
    const maxSteps = wholeFrom(1, this.maxSteps, 'Stop at N');
    const untilEpsilon = positive(this.until, 'Stop at ε');
    const minLength = positive(this.minLength, 'Stop at length');
    // It is about triangles of the surface.
    const rho = this.rhoRow.hidden ? undefined : positive(this.rho, 'ρ');
    const options: RunOptions = {
      ...(isFamily(this.family.value) ? { family: this.family.value } : {}),
      ...this.metric.asked(),
      ...(this.isDilated ? this.dilated.asked() : {}),
      ...(nu.length > 0 ? { nu } : {}),
      ...(first === undefined ? {} : { first }),
      ...(maxSteps === undefined ? {} : { maxSteps }),
      ...(untilEpsilon === undefined ? {} : { untilEpsilon }),
      ...(minLength === undefined ? {} : { minLength }),
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
    this.dimension = opened.dimension;
    for (const option of this.family.options) option.disabled = !mayTake(option.value, opened);
    this.family.value = options.family ?? '';
    this.metric.show(options, opened);
    this.dilated.show(options, opened);
    byId('nu-row', HTMLElement).hidden = opened.family === 'dilated';
    this.nu.value = options.nu?.join(', ') ?? '';
    this.nu.placeholder = opened.nu.join(', ');
    this.first.value = String(options.first ?? 0);
    this.first.max = String(opened.points - 1);
    this.rhoRow.hidden = opened.family === 'dilated';
    this.rho.value = text(options.rho);
    this.maxSteps.value = text(options.maxSteps);
    this.until.value = text(options.untilEpsilon);
    this.minLength.value = text(options.minLength);
    const sampled = choice.kind === 'sample';
    byId('size-row', HTMLElement).hidden = !sampled;
    byId('noise-row', HTMLElement).hidden = !sampled || choice.shape === COLORS;
    this.size.value = sampled ? String(choice.size) : '';
    this.noise.value = sampled ? text(choice.noise) : '';
  }
}
