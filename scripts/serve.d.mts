import type { Server } from 'node:http';

export declare function serve(
  folder: string,
  options?: { port?: number },
): Promise<{ server: Server; address: string }>;
