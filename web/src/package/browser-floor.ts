import { PlateauError } from '../client/plateau-error.ts';

/** The oldest browsers with all that is needed. */
export const BROWSER_FLOOR = 'Chrome and Edge 111, Firefox 114, Safari 16.4';

/** The smallest module with a `try`: the core is compiled with exceptions of WebAssembly. */
// prettier-ignore
const WITH_EXCEPTIONS = Uint8Array.of(
  0, 0x61, 0x73, 0x6d, 1, 0, 0, 0, 1, 4, 1, 0x60, 0, 0, 3, 2, 1, 0, 10, 8, 1, 6, 0, 6, 0x40, 0x19, 0x0b, 0x0b,
);

/** Workers that are modules; asked without starting one. */
function takesModuleWorkers(): boolean {
  let asked = false;
  const options = {
    get type(): 'module' {
      asked = true;
      return 'module';
    },
  };
  try {
    // No address: the options are read, then it fails.
    new Worker('http://', options);
  } catch {
    // As meant.
  }
  return asked;
}

const CORE: readonly (readonly [string, () => boolean])[] = [
  ['WebAssembly', () => typeof WebAssembly === 'object'],
  ['exceptions in WebAssembly', () => WebAssembly.validate(WITH_EXCEPTIONS)],
  ['workers', () => typeof Worker === 'function'],
  ['workers that are modules', takesModuleWorkers],
];

const PAGE: typeof CORE = [
  ...CORE,
  ['mixed colors', () => CSS.supports('color: color-mix(in srgb, red, blue)')],
];

const ELEMENT: typeof CORE = [
  ...PAGE,
  ['constructed style sheets', () => 'replaceSync' in CSSStyleSheet.prototype],
  ['container queries', () => CSS.supports('container-type: inline-size')],
];

const NEEDED = { core: CORE, page: PAGE, element: ELEMENT } as const;

/** A sentence that names the first thing that the browser lacks, for computing or also for showing; none: nothing. */
export function browserFault(what: keyof typeof NEEDED): PlateauError | undefined {
  const missing = NEEDED[what].find(([, present]) => !present());
  if (!missing) return undefined;
  return new PlateauError(
    'unsupported-browser',
    `This browser lacks ${missing[0]}. Plateau needs ${BROWSER_FLOOR}, or a newer one.`,
  );
}

/** Fails where the browser lacks something. */
export function demandBrowser(what: keyof typeof NEEDED): void {
  const fault = browserFault(what);
  if (fault) throw fault;
}
