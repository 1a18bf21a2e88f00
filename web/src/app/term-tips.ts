import { byId } from './dom.ts';

const GAP = 8;

/** Neither beyond the window nor behind what stays in its place while the page scrolls. */
function inSight(element: Element): boolean {
  const { left, top, width, height } = element.getBoundingClientRect();
  return element.contains(document.elementFromPoint(left + width / 2, top + height / 2));
}

/** Terms explain themselves on hover and focus: an element with data-term shows the template of that name. */
export function explainTerms(root: HTMLElement): void {
  const tip = byId('tip', HTMLElement);
  let shownFor: HTMLElement | undefined;

  const termOf = (target: EventTarget | null): HTMLElement | undefined =>
    target instanceof Element ? (target.closest<HTMLElement>('[data-term]') ?? undefined) : undefined;

  const heldByFocus = (): boolean =>
    shownFor !== undefined &&
    (shownFor.matches(':focus-visible') || !!shownFor.querySelector(':focus-visible'));

  const hide = (): void => {
    if (!shownFor) return;
    tip.hidden = true;
    shownFor = undefined;
  };

  const show = (term: HTMLElement): void => {
    if (shownFor === term) return;
    const template = byId(`term-${term.dataset['term'] ?? ''}`, HTMLTemplateElement);
    shownFor = term;
    tip.replaceChildren(template.content.cloneNode(true));
    tip.hidden = false;
    placeBeside(term);
  };

  const placeBeside = (term: HTMLElement): void => {
    const place = term.getBoundingClientRect();
    const { width, height } = tip.getBoundingClientRect();
    const beside = (term.closest('.settings')?.getBoundingClientRect().left ?? 0) - width - 3 * GAP;
    if (beside >= GAP) {
      // The other settings stay in sight.
      tip.style.left = `${beside}px`;
      tip.style.top = `${Math.max(GAP, Math.min(place.top, window.innerHeight - height - GAP))}px`;
      return;
    }
    const left = Math.min(place.left, window.innerWidth - width - GAP);
    const above = place.top - height - GAP;
    tip.style.left = `${Math.max(GAP, left)}px`;
    tip.style.top = `${above >= GAP ? above : place.bottom + GAP}px`;
  };

  for (const term of root.querySelectorAll<HTMLElement>('[data-term]')) {
    const control = term.querySelector('input, select') ?? term;
    const described = control.getAttribute('aria-describedby');
    const name = `said-${term.dataset['term'] ?? ''}`;
    control.setAttribute('aria-describedby', described ? `${described} ${name}` : name);
  }
  // Screen readers are told the words of the tip as a description of the control.
  for (const template of root.querySelectorAll<HTMLTemplateElement>('template[id^="term-"]')) {
    const said = document.createElement('p');
    said.id = template.id.replace('term-', 'said-');
    said.hidden = true;
    said.textContent = template.content.textContent.replace(/\s+/g, ' ').trim();
    template.after(said);
  }

  root.addEventListener('pointerover', (event) => {
    const term = termOf(event.target);
    if (term) show(term);
    else if (!heldByFocus()) hide();
  });
  root.addEventListener('focusin', (event) => {
    const term = termOf(event.target);
    if (term && event.target instanceof Element && event.target.matches(':focus-visible')) show(term);
    else hide();
  });
  // A finger hovers nowhere; and what was hidden by Escape can be asked for again.
  root.addEventListener('click', (event) => {
    const term = event.target instanceof Element ? event.target.closest<HTMLElement>('button.term') : null;
    if (term) show(term);
  });
  root.addEventListener('focusout', hide);
  // What was asked for is to be looked at.
  root.addEventListener('change', hide);
  const follow = (): void => {
    // The focus itself may have scrolled its term into sight.
    if (shownFor && heldByFocus() && inSight(shownFor)) placeBeside(shownFor);
    else hide();
  };
  root.addEventListener('scroll', follow, { capture: true });
  document.addEventListener('keydown', (event) => {
    if (event.key === 'Escape') hide();
  });
}
