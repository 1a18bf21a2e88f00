import type { Opened, RunOptions } from '../worker/protocol.ts';
import { byId } from './dom.ts';
import { fromZero } from './entries.ts';

type Chosen = Pick<RunOptions, 'dilation' | 'pump' | 'omegaBar' | 'zeta2' | 'sliver'>;

/** What the core takes where nothing is given. */
const USUAL = { dilation: 0.2, omegaBar: 0.25, zeta2: 0.5881028419773636 } as const;
/** (3/8) sin(π/32); the other constants of the theory are the usual ones. */
const THEORY_DILATION = 0.036756427623585226;

/** Which choice of constants these options are. */
function presetOf(options: Chosen): 'usual' | 'theory' | 'own' {
  const { dilation, pump = false, omegaBar, zeta2, sliver = 'literal' } = { ...USUAL, ...options };
  if (!pump) return dilation === USUAL.dilation ? 'usual' : 'own';
  const isOfTheory = omegaBar === USUAL.omegaBar && zeta2 === USUAL.zeta2 && sliver === 'literal';
  return isOfTheory && dilation === THEORY_DILATION ? 'theory' : 'own';
}

/** The constants of family dilated, and its pumping. */
export class DilatedSettings {
  private readonly group = byId('dilated-settings', HTMLElement);
  private readonly constants = byId('constants', HTMLSelectElement);
  private readonly dilation = byId('dilation', HTMLInputElement);
  private readonly pump = byId('pump', HTMLInputElement);
  private readonly pumping = byId('pump-settings', HTMLElement);
  private readonly omegaBar = byId('omega-bar', HTMLInputElement);
  private readonly zeta2 = byId('zeta2', HTMLInputElement);
  private readonly sliver = byId('sliver', HTMLSelectElement);

  constructor() {
    // Before the form asks for a new run with them.
    this.constants.addEventListener('change', () => {
      const theory = this.constants.value === 'theory';
      this.dilation.value = theory ? String(THEORY_DILATION) : '';
      // The theory's proofs are about pumped landmarks.
      this.pump.checked = theory;
      this.omegaBar.value = this.zeta2.value = '';
      this.sliver.value = 'literal';
    });
  }

  /** Throws a sentence where an entry makes no sense. */
  asked(): Chosen {
    if (this.group.hidden) return {};
    const dilation = fromZero(this.dilation, 'The dilation');
    const chosen: Chosen = dilation === undefined ? {} : { dilation };
    if (!this.pump.checked) return chosen;
    const omegaBar = fromZero(this.omegaBar, 'ω̄');
    const zeta2 = fromZero(this.zeta2, 'ζ₂');
    return {
      ...chosen,
      pump: true,
      ...(omegaBar === undefined ? {} : { omegaBar }),
      ...(zeta2 === undefined ? {} : { zeta2 }),
      ...(this.sliver.value === 'normalized' ? { sliver: 'normalized' } : {}),
    };
  }

  show(options: Chosen, opened: Opened): void {
    const text = (value: number | undefined): string => (value === undefined ? '' : String(value));
    this.group.hidden = opened.family !== 'dilated';
    this.dilation.value = text(options.dilation);
    this.pump.checked = options.pump === true;
    this.pumping.hidden = !this.pump.checked;
    this.constants.value = presetOf(options);
    // While it is off they wait for it to be on again.
    if (!this.pump.checked) return;
    this.omegaBar.value = text(options.omegaBar);
    this.zeta2.value = text(options.zeta2);
    this.sliver.value = options.sliver ?? 'literal';
  }
}
