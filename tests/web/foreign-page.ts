import { createServer, type Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import type { Page } from '@playwright/test';

/** A server of another origin, with nothing allowed but what the README says the element needs. */
export class ForeignServer {
  private readonly bodies = new Map<string, string>();
  private readonly server: Server;

  /** Directives that are left out, to see what happens then. */
  without: readonly string[] = [];

  private constructor(private readonly plateau: string) {
    this.server = createServer((request, response) => {
      const body = this.bodies.get(request.url?.replace(/[?#].*$/, '') ?? '');
      response
        .writeHead(body === undefined ? 404 : 200, {
          'Content-Type': request.url?.endsWith('.xyz') ? 'text/plain' : 'text/html; charset=utf-8',
          'Content-Security-Policy': this.policy,
        })
        .end(body ?? 'not found');
    });
  }

  /** `plateau`: the origin that the element comes from. */
  static async start(plateau: string): Promise<ForeignServer> {
    const foreign = new ForeignServer(plateau);
    await new Promise<void>((done) => foreign.server.listen(0, '127.0.0.1', done));
    return foreign;
  }

  async stop(): Promise<void> {
    this.server.closeAllConnections();
    await new Promise((done) => this.server.close(done));
  }

  get policy(): string {
    return [
      "default-src 'none'",
      `script-src ${this.plateau} 'wasm-unsafe-eval'`,
      'worker-src blob:',
      `connect-src 'self' ${this.plateau}`,
      `frame-src ${this.plateau}`,
    ]
      .filter((directive) => !this.without.some((name) => directive.startsWith(name)))
      .join('; ');
  }

  get origin(): string {
    const { port } = this.server.address() as AddressInfo;
    // Another host than the page's: another origin and another site.
    return `http://localhost:${port}`;
  }

  put(path: string, body: string): string {
    this.bodies.set(path, body);
    return `${this.origin}${path}`;
  }

  /** A page with the program of the element and this body. */
  page(path: string, body: string): string {
    return this.put(
      path,
      `<!doctype html><html lang="en"><title>Foreign</title>
       <script type="module" src="${this.plateau}/embed/plateau-view.js"></script><body>${body}</body></html>`,
    );
  }
}

/** An event of an element as a test sees it. */
export interface SeenEvent {
  readonly type: string;
  readonly id: string;
  readonly detail: Record<string, unknown>;
}

/** From now on every event of every element of the page is remembered, from its very beginning. */
export async function rememberEvents(page: Page): Promise<() => Promise<SeenEvent[]>> {
  await page.addInitScript(() => {
    const seen: unknown[] = [];
    Object.assign(window, { seen });
    for (const type of ['ready', 'step', 'plateau', 'error']) {
      // On the way down: `error` does not bubble.
      const remember = (event: Event): void => {
        if (!(event instanceof CustomEvent) || !(event.target instanceof Element)) return;
        seen.push({ type, id: event.target.id, detail: event.detail as unknown });
      };
      document.addEventListener(type, remember, true);
    }
  });
  return () => page.evaluate(() => (window as unknown as { seen: SeenEvent[] }).seen);
}
