/** What the entries for browsers and for Node.js have in common. */
export { PlateauError, type ErrorCode } from '../client/plateau-error.ts';
export type { ExportFormat, Family, Metric, RunOptions, ShownFamily } from '../worker/protocol.ts';
export type { BestWitness, Inspection, SurfacePlace, Verdict } from '../worker/inspection.ts';
export type { Cloud, FileCloud, PointCloud, ShapeCloud } from './cloud.ts';
export type { OpenOptions } from './open-cloud.ts';
export type { Plateau, Run, RunEnd, Step } from './run.ts';
