/** The element with the id, of the expected kind; its absence is a fault of the page's own HTML. */
export function byId<T extends Element>(id: string, kind: abstract new () => T): T {
  const element = document.getElementById(id);
  if (!(element instanceof kind)) throw new Error(`#${id} is not a ${kind.name}`);
  return element;
}

/** Shows the text, or hides the element where there is none. */
export function setNotice(element: HTMLElement, text: string): void {
  element.textContent = text;
  element.hidden = text === '';
}

/** The lines of the diagram that there are. */
export function showLegend(bettiCount: number, within: ParentNode = document): void {
  within.querySelectorAll<HTMLElement>('.legend > span').forEach((entry, k) => {
    entry.hidden = k >= bettiCount;
  });
}
