import { ShapeView } from '../view/shape-view.ts';
import { byId } from './dom.ts';

/** The view of the shape; without WebGL, or while it is lost, a sentence stands in its place. */
export function shapeViewOrNone(onView: (unitsPerPixel: number) => void): ShapeView | undefined {
  const onLost = (lost: boolean): void => {
    byId('lost-shape', HTMLElement).hidden = !lost;
  };
  try {
    return new ShapeView(byId('shape', HTMLElement), onView, onLost);
  } catch {
    byId('no-shape', HTMLElement).hidden = false;
    return undefined;
  }
}
