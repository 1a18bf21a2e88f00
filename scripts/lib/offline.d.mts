export declare function pageFiles(folder: string): string[];
export declare function writeServiceWorker(folder: string): void;
