import { counted } from '../model/numbers.ts';
import { bettiInWords, bettiList, shapeInWords } from '../model/words.ts';
import type { PlateauDetail, StepDetail } from '../embed/events.ts';
import type { PlateauViewElement } from '../embed/plateau-view-element.ts';
import { coreOfPage } from './page-core.ts';
import { viewOf } from './figures.ts';
import { marked, numberIn, numbersIn, same, undecided, type Mark, type Marker } from './marking.ts';

const NOT_OPEN = 'The figure shows nothing yet: scroll it into view and wait a moment.';
const NOT_DONE =
  'The figure is still computing: keep it in view until its diagram is whole, then check again.';

type AskStep = (answer: string, step: StepDetail, element: PlateauViewElement) => Promise<Mark> | Mark;
type AskPlateaus = (answer: string, plateaus: readonly PlateauDetail[], longest: PlateauDetail) => Mark;

/** Of the step that a view shows. */
function ofStep(ask: AskStep): Marker {
  return async (answer, figure) => {
    const { element, step } = viewOf(figure);
    return step && element.currentStep > 0 ? ask(answer, step, element) : undecided(NOT_OPEN);
  };
}

/** Why the plateaus of a view cannot be judged: which one is the longest is known at the end of its run. */
const unfinished = ({ stepCount, finished }: PlateauViewElement): Mark | undefined =>
  finished ? undefined : undecided(stepCount > 0 ? NOT_DONE : NOT_OPEN);

/** Of the plateaus of the whole run. */
function ofPlateaus(ask: AskPlateaus): Marker {
  return async (answer, figure) => {
    const { element } = viewOf(figure);
    const [longest] = element.plateaus;
    return Promise.resolve(
      unfinished(element) ??
        (longest ? ask(answer, element.plateaus, longest) : undecided('The figure has no plateau.')),
    );
  };
}

const atStep = ({ step, family, betti }: StepDetail): string =>
  `At step ${step} it shows ${bettiInWords(betti)}: ${shapeInWords(family, betti)}`;

const closedSurface: AskStep = (_, step) =>
  marked(step.family === 'surface' && same(step.betti, [1, 2, 1]), `${atStep(step)}.`);

const CURVE: readonly number[] = [1, 1, 0];

/** Any coarse ring has the numbers of a closed curve: it has to be in the plateau that lasts. */
const curveScale: AskStep = (_, step, element) => {
  if (!same(step.betti, CURVE)) return marked(false, `${atStep(step)}.`);
  const later = unfinished(element);
  if (later) return later;
  const best = element.plateaus.find(({ family, betti }) => family === 'delaunay' && same(betti, CURVE));
  if (!best) return undecided('The figure has no plateau of a closed curve.');
  const { firstStep, lastStep, length } = best;
  if (step.step >= firstStep && step.step <= lastStep)
    return marked(true, `${atStep(step)}, in a plateau of length ${length.toFixed(2)}.`);
  return marked(
    false,
    `${atStep(step)}. But it soon passes: the longest plateau with these numbers comes elsewhere.`,
  );
};

/** The plain complex of the same sample at the same step, whichever complex the figure shows. */
const holes: AskStep = async (answer, { step }, element) => {
  const points = { shape: element.shape, size: element.size ?? 1, seed: element.seed ?? 1 };
  const [, loops = 0] = await coreOfPage().bettiAt(points, { family: 'delaunay', nu: [1, 2, 3, 4] }, step);
  const kind = loops < 2 ? 'fewer' : loops === 2 ? 'two' : 'more';
  const around = kind === 'more' ? ' Most of them run around missing triangles.' : '';
  return marked(
    answer === kind,
    `At step ${step} the plain complex has ${counted(loops, 'loop')}; the torus has 2.${around}`,
  );
};

const genus: AskPlateaus = (answer, _, { betti }) => {
  const [, loops = 0] = betti;
  return marked(
    numberIn(answer) === loops / 2,
    `Its Betti numbers are ${bettiList(betti)}: ${counted(loops, 'loop')}, so ${counted(loops / 2, 'handle')}.`,
  );
};

const LONG = 0.5;

const longPlateaus: AskPlateaus = (answer, plateaus) => {
  const long = plateaus.filter(({ length }) => length > LONG);
  const names = long.map(({ betti, length }) => `${bettiList(betti)} of length ${length.toFixed(2)}`);
  return marked(
    numberIn(answer) === long.length,
    `There ${long.length === 1 ? 'is' : 'are'} ${long.length}: ${names.join('; ')}.`,
  );
};

const cliffordBetti: AskPlateaus = (answer, _, { betti }) => {
  const alike = same(betti.slice(0, 3), [1, 2, 1]) && betti.slice(3).every((count) => count === 0);
  return marked(
    answer === (alike ? 'yes' : 'no'),
    `Its longest plateau has ${bettiInWords(betti)}; the torus in space has 1, 2, 1.`,
  );
};

const threeSphere: AskPlateaus = (answer, _, { betti }) =>
  marked(
    same(numbersIn(answer), betti),
    `The longest plateau has ${bettiList(betti)}: ${bettiInWords(betti)}.`,
  );

/** By the names that the pages have for their tasks. */
export const VIEW_MARKERS: Readonly<Record<string, Marker>> = {
  'closed-surface': ofStep(closedSurface),
  holes: ofStep(holes),
  genus: ofPlateaus(genus),
  'curve-scale': ofStep(curveScale),
  'long-plateaus': ofPlateaus(longPlateaus),
  'clifford-betti': ofPlateaus(cliffordBetti),
  'three-sphere': ofPlateaus(threeSphere),
};
