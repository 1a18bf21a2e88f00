import { ShapeView, type ShapeTrouble } from '../view/shape-view.ts';
import { byId } from './dom.ts';

/** The view of the shape; without WebGL, while it is lost, or where there are too many points for it, a sentence stands in its place. */
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
