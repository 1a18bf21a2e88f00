import type { WorkerLike } from '../client/worker-link.ts';
import type { LoadModule } from '../worker/protocol.ts';
import PackagedWorker from '../worker/packaged.ts?worker&inline';

/** Beside the files of the package; a bundler that knows this form takes it along. */
const wasmAddress = (): URL => new URL(/* @vite-ignore */ './plateau.wasm', import.meta.url);

let compiling: Promise<WebAssembly.Module> | undefined;

async function compiledFrom(address: URL): Promise<WebAssembly.Module> {
  let answer: Response;
  try {
    answer = await fetch(address);
  } catch {
    throw new Error(
      `${address.href} cannot be read; its server, or the content-security policy of this page, does not allow it`,
    );
  }
  if (!answer.ok) throw new Error(`${address.href} answers ${answer.status}`);
  // Not every server knows the type that compiling on the way asks for.
  const streamed = answer.headers.get('Content-Type')?.startsWith('application/wasm');
  return streamed ? WebAssembly.compileStreaming(answer) : WebAssembly.compile(await answer.arrayBuffer());
}

/** The module, fetched and compiled once for all workers of the page; after a failure anew. */
function compiledModule(): Promise<WebAssembly.Module> {
  compiling ??= compiledFrom(wasmAddress()).catch((error: unknown) => {
    compiling = undefined;
    throw error;
  });
  return compiling;
}

/**
 * A worker for a page of any origin: its program is part of this one and starts from a blob, for a worker's script
 * must come from the page's own origin. What goes wrong with the module is told as the worker's error.
 */
export function startPackagedWorker(): WorkerLike {
  const worker = new PackagedWorker();
  compiledModule().then(
    (compiled) => worker.postMessage({ kind: 'loadModule', compiled } satisfies LoadModule),
    (error: unknown) => {
      const message = error instanceof Error ? error.message : String(error);
      worker.dispatchEvent(new ErrorEvent('error', { message, cancelable: true }));
    },
  );
  return worker;
}
