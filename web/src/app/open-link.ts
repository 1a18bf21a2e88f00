import { linkedIn, type LinkedSource } from '../model/link.ts';
import { unpacked } from '../model/packed-points.ts';
import type { Comparison } from './comparison.ts';
import type { Page } from './page.ts';
import type { SourceChoice } from './source.ts';

async function choiceOf(source: LinkedSource): Promise<SourceChoice> {
  if (source.kind === 'sample') return source;
  const { table, dimension } = await unpacked(source.points);
  const file = new File([table], `${source.name}.csv`);
  // More than three columns are a question, which the link has answered.
  const columns = Array.from({ length: dimension }, (_, axis) => axis + 1);
  return { kind: 'file', file, onDisk: false, ...(dimension > 3 ? { columns } : {}) };
}

/** How many links were followed. */
let followed = 0;

/**
 * Opens what the address links to, if it is a link; what is shown stays if that fails. Points are unpacked first: a link
 * that is followed meanwhile goes before.
 */
export async function openLink(page: Page, comparison: Comparison): Promise<boolean> {
  const turn = ++followed;
  try {
    const linked = linkedIn(location.hash);
    if (!linked) return false;
    comparison.close();
    const { options, step, reached, view, beside } = linked;
    const choice = await choiceOf(linked.source);
    const second = beside && { ...beside, choice: beside.source ? await choiceOf(beside.source) : choice };
    if (turn !== followed) return true;
    // Where two are compared the playhead is that of both.
    const arrival = second ? 'wait' : step > 0 ? 'return' : 'answer';
    await page.open(choice, options, arrival, false, { step, reached, view });
    if (second && page.currentChoice === choice) await comparison.open(second, second);
  } catch (error) {
    if (turn !== followed) return true;
    page.showEmpty();
    page.showError(error);
  }
  return true;
}
