import base from '../app/base.css?inline';
import controls from '../app/controls.css?inline';
import sketch from './plane-sketch.css?inline';

let sheet: CSSStyleSheet | undefined;

/** One sheet for all sketches: constructed, so that no policy for styles stands against it. */
export function sketchStyle(): CSSStyleSheet {
  if (!sheet) {
    sheet = new CSSStyleSheet();
    sheet.replaceSync([base, controls, sketch].join('\n'));
  }
  return sheet;
}
