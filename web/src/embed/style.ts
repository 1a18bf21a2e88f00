import base from '../app/base.css?inline';
import cards from '../app/cards.css?inline';
import controls from '../app/controls.css?inline';
import palette from '../app/theme.css?raw';
import diagram from '../view/diagram.css?inline';
import sizes from './plateau-view-sizes.css?inline';
import element from './plateau-view.css?inline';
import { hostTheme } from './host-theme.ts';

let sheet: CSSStyleSheet | undefined;

/** One sheet for all elements: constructed, so that no policy for styles stands against it. */
export function elementStyle(): CSSStyleSheet {
  if (!sheet) {
    sheet = new CSSStyleSheet();
    sheet.replaceSync([hostTheme(palette), base, controls, diagram, cards, element, sizes].join('\n'));
  }
  return sheet;
}
