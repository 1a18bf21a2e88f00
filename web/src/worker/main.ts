import createModule from 'plateau-module';
import wasmAddress from 'plateau-module/wasm';
import type { WorkerRequest } from './protocol.ts';
import { servedBy } from './serve.ts';

const handle = servedBy(createModule({ locateFile: () => wasmAddress }));
self.onmessage = (event: MessageEvent<WorkerRequest>) => handle(event.data);
