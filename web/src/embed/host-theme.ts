function rules(pattern: RegExp, css: string, what: string): string {
  const found = pattern.exec(css)?.[1];
  if (found === undefined) throw new Error(`The palette has no ${what} colors.`);
  return found;
}

/** The palette of the page as that of an element: as the visitor's system asks, unless its `theme` says otherwise. */
export function hostTheme(palette: string): string {
  const light = rules(/^:root \{([^}]*)\}/m, palette, 'light');
  const dark = rules(/^@media \(prefers-color-scheme: dark\) \{\s*:root \{([^}]*)\}/m, palette, 'dark');
  return [
    `:host {${light}}`,
    `@media (prefers-color-scheme: dark) { :host(:not([theme='light'])) {${dark}} }`,
    `:host([theme='dark']) {${dark} color-scheme: dark; }`,
    `:host([theme='light']) { color-scheme: light; }`,
  ].join('\n');
}
