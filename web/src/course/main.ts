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

/** In a frame of another site browsers refuse, with a complaint of their own; and none has a clipboard without https. */
async function copied(text: string): Promise<boolean> {
  if (window.parent !== window) return false;
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    return false;
  }
}

/** Under each figure: the address of this page with the figure as it is; to be copied by hand where a button may not. */
function offerLinks(): void {
  for (const element of document.querySelectorAll('plane-sketch, plateau-view')) {
    const button = make('button', { type: 'button', class: 'button' }, 'Link to this state');
    const said = make('span', { role: 'status' });
    const field = make('input', {
      type: 'text',
      readonly: '',
      hidden: '',
      'aria-label': 'Link to this state',
    });
    button.addEventListener('click', () => {
      const address = linkTo(element);
      history.replaceState(null, '', address);
      void copied(address).then((done) => {
        said.textContent = done ? 'Copied.' : 'Copy it from here:';
        field.hidden = done;
        field.value = address;
        if (!done) field.select();
      });
    });
    element.closest('figure')?.append(make('p', { class: 'figure-link' }, button, said, field));
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
