const THIN_SPACE = '\u202f';

/** 12345 as "12,345". */
export function grouped(count: number): string {
  return String(count).replace(/\B(?=(\d{3})+(?!\d))/g, ',');
}

/** 12345 as "12 345": in lists, which have commas of their own. */
export function spaced(count: number): string {
  return String(count).replace(/\B(?=(\d{3})+(?!\d))/g, THIN_SPACE);
}

/** Three significant digits, plain where a plain number is readable. */
export function readable(value: number): string {
  if (value === 0) return '0';
  const size = Math.abs(value);
  if (size >= 1e6 || size < 1e-4) {
    const [mantissa = '', exponent = '0'] = value.toExponential(2).split('e');
    const digits = [...String(Number(exponent))].map((digit) => SUPERSCRIPT[digit] ?? digit).join('');
    return `${String(Number(mantissa))}${THIN_SPACE}×${THIN_SPACE}10${digits}`;
  }
  const rounded = Number(value.toPrecision(3));
  const decimals = Math.max(0, 2 - Math.floor(Math.log10(Math.abs(rounded))));
  return Math.abs(rounded) >= 1000 ? grouped(rounded) : rounded.toFixed(decimals);
}

const SUPERSCRIPT: Readonly<Record<string, string>> = {
  '-': '⁻',
  '0': '⁰',
  '1': '¹',
  '2': '²',
  '3': '³',
  '4': '⁴',
  '5': '⁵',
  '6': '⁶',
  '7': '⁷',
  '8': '⁸',
  '9': '⁹',
};

/** "1 loop", "2 loops". */
export function counted(count: number, one: string, many = `${one}s`): string {
  return `${grouped(count)} ${count === 1 ? one : many}`;
}
