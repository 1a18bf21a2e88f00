import { ShapeView, type ShapeTrouble } from '../view/shape-view.ts';
import { byId, setNotice } from './dom.ts';

export const NO_WEBGL =
  'The shape needs WebGL 2, which this browser does not offer. The diagram and the plateaus work without it.';
const NO_PICTURE: Readonly<Record<ShapeTrouble, string>> = {
  lost: 'The browser has taken the graphics card away. The shape comes back when it returns it; the diagram goes on.',
  crowded:
    'These are more points than this graphics card has room for. The diagram and the plateaus work without it.',
};

/** The view of the shape of the page; without WebGL, while it is lost, or where there are too many points for it, a sentence stands in its place. */
export function shapeViewOrNone(onView: (unitsPerPixel: number) => void): ShapeView | undefined {
  const onTrouble = (trouble: ShapeTrouble | undefined): void => {
    byId('lost-shape', HTMLElement).hidden = trouble !== 'lost';
    byId('crowded-shape', HTMLElement).hidden = trouble !== 'crowded';
  };
  try {
    return new ShapeView(byId('shape', HTMLElement), onView, onTrouble);
  } catch {
    byId('no-shape', HTMLElement).hidden = false;
    return undefined;
  }
}

/** The same in any box, with one place for all sentences. */
export function shapeViewIn(
  box: HTMLElement,
  note: HTMLElement,
  onView: (unitsPerPixel: number) => void = () => undefined,
): ShapeView | undefined {
  const onTrouble = (trouble: ShapeTrouble | undefined): void =>
    setNotice(note, trouble ? NO_PICTURE[trouble] : '');
  try {
    return new ShapeView(box, onView, onTrouble);
  } catch {
    setNotice(note, NO_WEBGL);
    return undefined;
  }
}
