import { make } from '../embed/dom.ts';
import { changesOf } from './figures.ts';
import { undecided, type Mark, type Marker } from './marking.ts';

/** The core mostly answers sooner; then nothing is said in between. */
const PATIENCE_MS = 250;
const SPOKEN: Readonly<Record<Mark['verdict'], string>> = { right: 'Right. ', wrong: 'Not yet. ', open: '' };

/** The answer that is chosen or typed; undefined where there is something to fill in and nothing is. */
function answerOf(form: HTMLFormElement): string | undefined {
  if (!form.querySelector('[name="answer"]')) return '';
  const answer = new FormData(form).get('answer');
  return typeof answer === 'string' && answer.trim() !== '' ? answer.trim() : undefined;
}

/** Questions get a button; what it says is the core's, of the figure at that moment. */
export function offerTasks(markers: Readonly<Record<string, Marker>>): void {
  for (const form of document.querySelectorAll<HTMLFormElement>('form.task')) {
    const { task = '', figure = '' } = form.dataset;
    const mark = markers[task];
    if (!mark) throw new Error(`There is no task ${task}.`);
    offerTask(form, figure, mark);
  }
}

function offerTask(form: HTMLFormElement, figure: string, mark: Marker): void {
  const check = make('button', { type: 'submit', class: 'button primary' }, 'Check');
  const verdict = make('p', { class: 'verdict', role: 'status' });
  form.querySelector('details')?.before(check);
  form.append(verdict);
  form.noValidate = true;
  let checks = 0;

  const say = (kind: Mark['verdict'], sentence: string): void => {
    delete form.dataset['stale'];
    form.dataset['verdict'] = kind;
    verdict.textContent = `${SPOKEN[kind]}${sentence}`;
  };
  /** What was said is of another answer, or of the figure as it was: it stays to be read, and steps back. */
  const age = (): void => {
    if (verdict.textContent !== '') form.dataset['stale'] = '';
  };
  form.addEventListener('input', ({ target }) => {
    // What is done in a figure within the form is told by the figure.
    if (target instanceof HTMLInputElement && target.name === 'answer') age();
  });
  changesOf(figure, age);
  form.addEventListener('submit', (event) => {
    event.preventDefault();
    const answer = answerOf(form);
    if (answer === undefined) {
      say('open', 'Answer first, then check.');
      return;
    }
    const turn = ++checks;
    const waiting = setTimeout(() => say('open', 'Computing…'), PATIENCE_MS);
    const outcome = mark(answer, figure).catch((error: unknown) =>
      undecided(error instanceof Error ? error.message : String(error)),
    );
    void outcome.then(({ verdict: kind, reason }) => {
      clearTimeout(waiting);
      if (turn === checks) say(kind, reason);
    });
  });
}
