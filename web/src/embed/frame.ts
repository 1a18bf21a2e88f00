// The page that an iframe shows: one element, with the attributes that the address names, after ? or #.
import { ATTRIBUTES } from './settings.ts';

const view = document.querySelector('plateau-view');

/** The fragment goes before the query: it can change without loading the page again. */
function follow(): void {
  const asked = new URLSearchParams(location.search);
  for (const [name, value] of new URLSearchParams(location.hash.slice(1))) asked.set(name, value);
  for (const name of [...ATTRIBUTES, 'aria-label']) {
    const value = asked.get(name) ?? (name === 'panels' ? 'full' : null);
    // What did not change is not asked for once more.
    if (value === view?.getAttribute(name)) continue;
    if (value === null) view?.removeAttribute(name);
    else view?.setAttribute(name, value);
  }
  document.title = `Plateau: ${asked.get('shape') ?? asked.get('src') ?? 'nothing to show yet'}`;
}

addEventListener('hashchange', follow);
follow();
