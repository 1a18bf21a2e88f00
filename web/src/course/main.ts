import '../app/theme.css';
import '../app/base.css';
import '../app/controls.css';
import './course.css';
import './course-figures.css';
import { make } from '../embed/dom.ts';
import { computeWith, PlaneSketchElement } from '../sketch/plane-sketch-element.ts';
import { watchViews } from './figures.ts';
import { followLink, linkTo, rememberPresets } from './links.ts';
import { coreOfPage } from './page-core.ts';
import { PLANE_MARKERS } from './plane-markers.ts';
import { offerTasks } from './tasks.ts';
import { VIEW_MARKERS } from './view-markers.ts';

/** Some browsers refuse in frames, and none has a clipboard without https: the address bar has it all the same. */
async function copied(text: string): Promise<boolean> {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    return false;
  }
}

/** Under each figure: the address of this page with the figure as it is. */
function offerLinks(): void {
  for (const element of document.querySelectorAll('plane-sketch, plateau-view')) {
    const button = make('button', { type: 'button', class: 'button' }, 'Link to this state');
    const said = make('span', { role: 'status' });
    button.addEventListener('click', () => {
      const address = linkTo(element);
      history.replaceState(null, '', address);
      void copied(address).then((done) => {
        said.textContent = done ? 'Copied; it is also in the address bar.' : 'It is in the address bar now.';
      });
    });
    element.closest('figure')?.append(make('p', { class: 'figure-link' }, button, said));
  }
}

/** Buttons that set attributes of a figure. */
function offerChoices(): void {
  for (const button of document.querySelectorAll<HTMLButtonElement>('button[data-set]')) {
    const { set = '', ...attributes } = button.dataset;
    button.addEventListener('click', () => {
      const figure = document.getElementById(set);
      for (const [name, value] of Object.entries(attributes)) figure?.setAttribute(name, value ?? '');
    });
  }
}

watchViews();
rememberPresets();
computeWith(coreOfPage());
customElements.define('plane-sketch', PlaneSketchElement);
// Not before: what the page has is what a sketch can be reset to.
followLink();
addEventListener('hashchange', followLink);
if (document.querySelector('plateau-view'))
  void import('./views.ts').then(({ defineViews }) => defineViews());
offerLinks();
offerChoices();
offerTasks({ ...PLANE_MARKERS, ...VIEW_MARKERS });
