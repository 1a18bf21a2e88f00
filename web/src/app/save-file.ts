/** Offers bytes or text as a download. */
export function saveFile(name: string, type: string, content: BlobPart): void {
  const address = URL.createObjectURL(new Blob([content], { type }));
  const link = document.createElement('a');
  link.href = address;
  link.download = name;
  link.click();
  // The browser has taken the address by then; Safari needs a moment.
  setTimeout(() => URL.revokeObjectURL(address), 10_000);
}
