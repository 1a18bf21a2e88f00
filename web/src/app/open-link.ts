import { linkedIn, type Linked } from '../model/link.ts';
import { unpacked } from '../model/packed-points.ts';
import type { Page } from './page.ts';
import type { SourceChoice } from './source.ts';

async function choiceOf({ source }: Linked): Promise<SourceChoice> {
  if (source.kind === 'sample') return source;
  const { table, dimension } = await unpacked(source.points);
  const file = new File([table], `${source.name}.csv`);
  // More than three columns are a question, which the link has answered.
  const columns = Array.from({ length: dimension }, (_, axis) => axis + 1);
  return dimension > 3 ? { kind: 'file', file, columns } : { kind: 'file', file };
}

/** Opens what the address links to, if it is a link; what is shown stays if that fails. */
export async function openLink(page: Page): Promise<boolean> {
  try {
    const linked = linkedIn(location.hash);
    if (!linked) return false;
    const { options, step, reached, view } = linked;
    await page.open(await choiceOf(linked), options, step > 0 ? 'return' : 'answer', false, {
      step,
      reached,
      view,
    });
  } catch (error) {
    page.showEmpty();
    page.showError(error);
  }
  return true;
}
