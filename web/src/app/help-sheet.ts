import { byId } from './dom.ts';

const KEY = 'plateau-single-keys';

/** The help sheet, and whether keys of one letter do anything: remembered, for they disturb speech input. */
export class HelpSheet {
  private readonly dialog = byId('help', HTMLDialogElement);
  private readonly box = byId('single-keys', HTMLInputElement);

  constructor() {
    this.box.checked = remembered() !== 'off';
    this.box.addEventListener('change', () => remember(this.box.checked ? 'on' : 'off'));
  }

  get singleKeys(): boolean {
    return this.box.checked;
  }

  open(): void {
    this.dialog.showModal();
  }
}

function remembered(): string | null {
  try {
    return localStorage.getItem(KEY);
  } catch {
    // A browser that stores nothing: the keys are on.
    return null;
  }
}

function remember(value: string): void {
  try {
    localStorage.setItem(KEY, value);
  } catch {
    // It holds until the page is left.
  }
}

/** Buttons with data-close, and a click beside a sheet, close it. */
export function closeSheets(): void {
  for (const button of document.querySelectorAll<HTMLButtonElement>('[data-close]')) {
    const dialog = byId(button.dataset['close'] ?? '', HTMLDialogElement);
    button.addEventListener('click', () => dialog.close());
    dialog.addEventListener('click', (event) => {
      if (event.target === dialog) dialog.close();
    });
  }
}
