import type { ShownFamily } from '../worker/protocol.ts';
import { counted, readable, spaced } from './numbers.ts';
import type { Torsion } from './record.ts';

/** "1 component, 2 loops, 1 void"; what is zero goes unsaid. */
export function bettiInWords(betti: readonly number[]): string {
  const [components = 0, loops = 0, voids = 0] = betti;
  const parts = [counted(components, 'component')];
  if (loops > 0) parts.push(counted(loops, 'loop'));
  if (voids > 0) parts.push(counted(voids, 'void'));
  betti.forEach((count, k) => {
    if (k > 2 && count > 0) parts.push(`${counted(count, 'hole')} of dimension ${k}`);
  });
  return parts.join(', ');
}

/** "1, 2, 1". */
export function bettiList(betti: readonly number[]): string {
  return betti.map(spaced).join(', ');
}

/** "β 1, 2, 1". */
export function bettiInNumbers(betti: readonly number[]): string {
  return `β ${bettiList(betti)}`;
}

function closedSurface(components: number, loops: number): string {
  if (components > 1) {
    const handles = loops / 2;
    if (handles === 0) return `${components} sphere-like closed surfaces`;
    return `${components} closed surfaces, ${counted(handles, 'handle')} in all`;
  }
  if (loops === 0) return 'sphere-like closed surface';
  if (loops === 2) return 'torus-like closed surface';
  if (loops === 4) return 'double-torus-like closed surface';
  return `closed surface with ${loops / 2} handles`;
}

/** Holes that surround more than a void, as only shapes beyond space have. */
function beyondSpace(betti: readonly number[], last: number): string {
  const [components = 0] = betti;
  if (components > 1) return `${components} pieces with holes up to dimension ${last}`;
  const others = betti.slice(1, last).some((count) => count > 0);
  return !others && betti[last] === 1
    ? `${last}-sphere-like shape`
    : `one piece with holes up to dimension ${last}`;
}

function complexIn(betti: readonly number[]): string {
  const [components = 0, loops = 0, voids = 0] = betti;
  const last = betti.reduce((highest, count, k) => (count > 0 ? k : highest), 0);
  if (last > 2) return beyondSpace(betti, last);
  if (voids > 0) {
    if (components === 1 && voids === 1 && loops === 0) return 'sphere-like hollow shape';
    if (components === 1 && voids === 1 && loops === 2) return 'torus-like hollow shape';
    return `hollow shape with ${counted(voids, 'void')}`;
  }
  if (components === 1) {
    if (loops === 0) return 'one piece without holes';
    return loops === 1 ? 'closed curve' : `one piece with ${loops} loops`;
  }
  if (loops === 0) return `${counted(components, 'separate piece')}`;
  return loops === components
    ? `${components} closed curves`
    : `${components} pieces with ${counted(loops, 'loop')}`;
}

/** "torsion: 1, 0, 0 over Z/3": the numbers over another field, which differ. */
export function torsionInNumbers({ field, betti }: Torsion): string {
  return `torsion: ${bettiList(betti)} over Z/${field}`;
}

/** The two that every course shows; the numbers over Z/2 and over Z/3, in either order. */
const WITH_TORSION: readonly (readonly [name: string, one: string, other: string])[] = [
  ['projective-plane-like shape', '1,1,1', '1'],
  ['Klein-bottle-like shape', '1,2,1', '1,1'],
];

function withTorsion(betti: readonly number[], other: readonly number[]): string | undefined {
  const numbers = [betti, other].map((each) => each.join().replace(/(,0)+$/, ''));
  return WITH_TORSION.find(([, one, another]) => numbers.includes(one) && numbers.includes(another))?.[0];
}

/** What a shape with these Betti numbers looks like, in a few plain words; "-like" because Betti numbers say no more. */
export function shapeInWords(
  family: ShownFamily,
  betti: readonly number[],
  torsion?: readonly number[],
): string {
  const [components = 0, loops = 0] = betti;
  const known = torsion && withTorsion(betti, torsion);
  if (known) return known;
  if (family === 'surface') return closedSurface(components, loops);
  // Dilated witnesses show bands as well as curves, and one loop is all that Betti numbers see of either.
  if (family === 'dilated' && /^1,1(,0)*$/.test(betti.join())) return 'circle-like shape';
  return complexIn(betti);
}

/** "ε 0.43 → 0.16". */
export function scaleInWords(epsilonFrom: number, epsilonTo: number): string {
  return `ε ${readable(epsilonFrom)} → ${readable(epsilonTo)}`;
}
