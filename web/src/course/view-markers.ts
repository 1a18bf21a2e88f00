import { counted } from '../model/numbers.ts';
import { bettiInWords, bettiList, shapeInWords } from '../model/words.ts';
import { coreOfPage } from './page-core.ts';
import { viewOf, type ShownView } from './figures.ts';
import { numberIn, numbersIn, same, type Mark, type Marker } from './marking.ts';

const NOT_OPEN = 'The figure shows nothing yet: scroll it into view and wait a moment.';

/** What a view shows, when it is something. */
function open(figure: string): Required<ShownView> | undefined {
  const { element, step } = viewOf(figure);
  return step && element.currentStep > 0 ? { element, step } : undefined;
}

const closed = (): Promise<Mark> => Promise.resolve({ right: false, reason: NOT_OPEN });

function atStep({ step }: Required<ShownView>): string {
  const { step: at, family, betti } = step ?? { step: 0, family: 'delaunay', betti: [] };
  return `At step ${at} it shows ${bettiInWords(betti)}: ${shapeInWords(family, betti)}`;
}

async function closedSurface(_: string, figure: string): Promise<Mark> {
  const view = open(figure);
  if (!view) return closed();
  const right = view.step?.family === 'surface' && same(view.step.betti, [1, 2, 1]);
  return Promise.resolve({ right, reason: `${atStep(view)}.` });
}

async function curveScale(_: string, figure: string): Promise<Mark> {
  const view = open(figure);
  if (!view) return closed();
  return Promise.resolve({ right: same(view.step?.betti ?? [], [1, 1, 0]), reason: `${atStep(view)}.` });
}

/** The plain complex of the same sample at the same step, whichever complex the figure shows. */
async function holes(answer: string, figure: string): Promise<Mark> {
  const view = open(figure);
  if (!view?.step) return closed();
  const { element, step } = view;
  const points = { shape: element.shape, size: element.size ?? 1, seed: element.seed ?? 1 };
  const [, loops = 0] = await coreOfPage().bettiAt(
    points,
    { family: 'delaunay', nu: [1, 2, 3, 4] },
    step.step,
  );
  const kind = loops < 2 ? 'fewer' : loops === 2 ? 'two' : 'more';
  return {
    right: answer === kind,
    reason: `At step ${step.step} the plain complex has ${counted(loops, 'loop')}.`,
  };
}

/** The longest plateau that the figure has found so far. */
function longest(figure: string) {
  return viewOf(figure).element.plateaus[0];
}

async function genus(answer: string, figure: string): Promise<Mark> {
  const plateau = longest(figure);
  if (!plateau) return closed();
  const [, loops = 0] = plateau.betti;
  return Promise.resolve({
    right: numberIn(answer) === loops / 2,
    reason: `Its Betti numbers are ${bettiList(plateau.betti)}: ${counted(loops, 'loop')}, so ${counted(loops / 2, 'handle')}.`,
  });
}

const LONG = 0.5;

async function longPlateaus(answer: string, figure: string): Promise<Mark> {
  const { plateaus } = viewOf(figure).element;
  if (plateaus.length === 0) return closed();
  const long = plateaus.filter(({ length }) => length > LONG);
  const names = long.map(({ betti, length }) => `${bettiList(betti)} of length ${length.toFixed(2)}`);
  return Promise.resolve({
    right: numberIn(answer) === long.length,
    reason: `There ${long.length === 1 ? 'is' : 'are'} ${long.length}: ${names.join('; ')}.`,
  });
}

async function cliffordBetti(answer: string, figure: string): Promise<Mark> {
  const plateau = longest(figure);
  if (!plateau) return closed();
  const alike =
    same(plateau.betti.slice(0, 3), [1, 2, 1]) && plateau.betti.slice(3).every((count) => count === 0);
  return Promise.resolve({
    right: answer === (alike ? 'yes' : 'no'),
    reason: `Its longest plateau has ${bettiInWords(plateau.betti)}; the torus in space has 1, 2, 1.`,
  });
}

async function threeSphere(answer: string, figure: string): Promise<Mark> {
  const plateau = longest(figure);
  if (!plateau) return closed();
  return Promise.resolve({
    right: same(numbersIn(answer), plateau.betti),
    reason: `The longest plateau has ${bettiList(plateau.betti)}: ${bettiInWords(plateau.betti)}.`,
  });
}

/** By the names that the pages have for their tasks. */
export const VIEW_MARKERS: Readonly<Record<string, Marker>> = {
  'closed-surface': closedSurface,
  holes,
  genus,
  'curve-scale': curveScale,
  'long-plateaus': longPlateaus,
  'clifford-betti': cliffordBetti,
  'three-sphere': threeSphere,
};
