/** Pasted text has no name; without an ending its content tells the format. */
const PASTED = 'Pasted points';

const NOT_TEXT: readonly string[] = ['range', 'file', 'checkbox', 'radio', 'button', 'submit', 'color'];

/** Does the element take what is pasted itself? */
function takesText(target: EventTarget | null): boolean {
  if (target instanceof HTMLInputElement) return !NOT_TEXT.includes(target.type);
  return target instanceof HTMLTextAreaElement || (target instanceof HTMLElement && target.isContentEditable);
}

/** Files and text pasted anywhere but into a field for text; text is a file that is on no disk. */
export function acceptPastes(onFile: (file: File, onDisk: boolean) => void): void {
  document.addEventListener('paste', (event) => {
    if (event.defaultPrevented || takesText(event.target)) return;
    const text = event.clipboardData?.getData('text/plain') ?? '';
    const copied = event.clipboardData?.files[0];
    const file = copied ?? (text.trim() === '' ? undefined : new File([text], PASTED));
    if (!file) return;
    event.preventDefault();
    onFile(file, copied !== undefined);
  });
}
