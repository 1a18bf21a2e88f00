import createModule, { type PlateauModule } from 'plateau-module';
import type { LoadModule, WorkerRequest } from './protocol.ts';
import { servedBy } from './serve.ts';

/** An instance of a module that was compiled elsewhere, once for all workers. */
function instanceOf(compiled: WebAssembly.Module): Promise<PlateauModule> {
  return new Promise((resolve, reject) => {
    createModule({
      // Nothing is fetched from here: a worker without an address of its own does not know where it would lie.
      locateFile: (name) => name,
      instantiateWasm: (imports, receive) => {
        WebAssembly.instantiate(compiled, imports).then(receive, reject);
        return {};
      },
    }).then(resolve, reject);
  });
}

// The worker of the package: its program comes with the package's, and the compiled module with the first message.
let load: (compiled: WebAssembly.Module) => void;
const loading = new Promise<WebAssembly.Module>((resolve) => {
  load = resolve;
});
const handle = servedBy(loading.then(instanceOf));
self.onmessage = ({ data }: MessageEvent<LoadModule | WorkerRequest>) => {
  if (data.kind === 'loadModule') load(data.compiled);
  else handle(data);
};
