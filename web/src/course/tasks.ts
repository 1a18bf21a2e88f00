import { make } from '../embed/dom.ts';
import type { Marker } from './marking.ts';

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
    const check = make('button', { type: 'submit', class: 'button primary' }, 'Check');
    const verdict = make('p', { class: 'verdict', role: 'status' });
    form.querySelector('details')?.before(check);
    form.append(verdict);
    form.noValidate = true;

    const say = (kind: 'right' | 'wrong' | 'open', sentence: string): void => {
      form.dataset['verdict'] = kind;
      verdict.textContent = sentence;
    };
    form.addEventListener('submit', (event) => {
      event.preventDefault();
      const answer = answerOf(form);
      if (answer === undefined) {
        say('open', 'Answer first, then check.');
        return;
      }
      mark(answer, figure).then(
        ({ right, reason }) => say(right ? 'right' : 'wrong', `${right ? 'Right.' : 'Not yet.'} ${reason}`),
        (error: unknown) => say('open', error instanceof Error ? error.message : String(error)),
      );
    });
  }
}
