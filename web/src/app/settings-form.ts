import type { Opened, RunOptions } from '../worker/protocol.ts';
import { byId } from './dom.ts';
import { isFamily, parseList } from './source.ts';

/** Family, ν and first landmark; a change asks for a new run. */
export class SettingsForm {
  private readonly family = byId('family', HTMLSelectElement);
  private readonly nu = byId('nu', HTMLInputElement);
  private readonly first = byId('first', HTMLInputElement);

  constructor(onChange: () => void) {
    const form = byId('settings', HTMLFormElement);
    form.addEventListener('submit', (event) => event.preventDefault());
    form.addEventListener('change', (event) => {
      // Each family has a ν of its own.
      if (event.target === this.family) this.nu.value = '';
      onChange();
    });
  }

  /** Throws a sentence where an entry makes no sense. */
  options(): RunOptions {
    const nu = parseList(this.nu.value, 0, 'ν');
    const first = this.first.value.trim() === '' ? 0 : this.first.valueAsNumber;
    if (!Number.isInteger(first) || first < 0)
      throw new Error('The first landmark takes a whole number from 0 on.');
    return {
      ...(isFamily(this.family.value) ? { family: this.family.value } : {}),
      ...(nu.length > 0 ? { nu } : {}),
      ...(first > 0 ? { first } : {}),
    };
  }

  /** Back to what another cloud begins with. */
  reset(options: RunOptions): void {
    this.family.value = options.family ?? '';
    this.nu.value = options.nu?.join(', ') ?? '';
    this.first.value = String(options.first ?? 0);
  }

  /** Says what the run took where nothing was asked. */
  showTaken(opened: Opened): void {
    this.nu.placeholder = opened.nu.join(', ');
    this.first.max = String(opened.coordinates.length / opened.dimension - 1);
  }
}
