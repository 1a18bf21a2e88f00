import names from 'xkcd-colors/assets/colors.json';
import { converter, differenceCiede2000 } from 'culori/fn';
import { modeLab65, modeLch65, modeRgb, useMode } from 'culori/fn';

/** Grays, browns and pastels fill the solid of all colors; above this chroma (CIE LCh, D65) its rim is left. */
const LEAST_CHROMA = 40;
/** Rows between two breaths: the page has other things to do meanwhile. */
const ROWS_AT_ONCE = 12;

useMode(modeRgb);
useMode(modeLab65);
useMode(modeLch65);

/** The first `size` of the 652 strong colors among those that the xkcd survey has names for, as #rrggbb. */
export function strongColors(size: number): readonly string[] {
  const lch = converter('lch65');
  return names
    .map(({ hex }) => hex)
    .filter((hex) => (lch(hex)?.c ?? 0) >= LEAST_CHROMA)
    .slice(0, size);
}

/**
 * How different the colors look, by CIEDE2000: a triangular table. These differences are no Euclidean distances, and
 * no metric either: here and there they fail the triangle inequality.
 */
export async function colorDistances(size: number): Promise<string> {
  const colors = strongColors(size);
  const difference = differenceCiede2000();
  const rows: string[] = [];
  for (const [i, color] of colors.entries()) {
    rows.push([...colors.slice(0, i).map((other) => difference(color, other).toFixed(4)), '0'].join(','));
    if (i % ROWS_AT_ONCE === 0) await new Promise((resolve) => setTimeout(resolve));
  }
  return `${rows.join('\n')}\n`;
}
