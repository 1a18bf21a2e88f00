export declare const bunnyVolume: number;
export declare function bunnyPoints(n: number, seed?: number): number[][];
export declare function asText(points: readonly (readonly number[])[]): string;
