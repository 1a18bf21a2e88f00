const SVG = 'http://www.w3.org/2000/svg';

/** An element with attributes and children, made without markup, which a strict policy may not let in. */
export function make<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Readonly<Record<string, string>> = {},
  ...children: readonly (Node | string)[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.append(...children);
  return element;
}

/** Solid outlines, each with the classes that say when it is shown. */
export function icon(outlines: Readonly<Record<string, string>>): SVGSVGElement {
  const svg = document.createElementNS(SVG, 'svg');
  svg.setAttribute('viewBox', '0 0 16 16');
  svg.setAttribute('aria-hidden', 'true');
  for (const [outline, classes] of Object.entries(outlines)) {
    const path = document.createElementNS(SVG, 'path');
    path.setAttribute('d', outline);
    path.setAttribute('class', classes);
    svg.append(path);
  }
  return svg;
}

/** A button whose name is read aloud, and seen where there is room. */
export function iconButton(
  classes: string,
  label: string,
  title: string,
  outlines: Readonly<Record<string, string>>,
): { button: HTMLButtonElement; label: HTMLSpanElement } {
  const name = make('span', { class: 'label' }, label);
  const button = make('button', { type: 'button', class: `button ${classes}`, title }, icon(outlines), name);
  return { button, label: name };
}
