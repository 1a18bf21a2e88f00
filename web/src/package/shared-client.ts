import { PlateauClient } from '../client/plateau-client.ts';
import type { PlateauError } from '../client/plateau-error.ts';
import type { WorkerLike } from '../client/worker-link.ts';

/** A share in the client; whoever has it is told when the worker dies. */
export interface ClientShare {
  readonly client: PlateauClient;
  /** Gives the share back; the worker ends with the last. */
  release(): void;
}

/** One client, and so one worker, for everyone: it starts with the first share and ends with the last. */
export class SharedClient {
  private client: PlateauClient | undefined;
  /** Who holds a share, and whom it tells of a death. */
  private readonly holders = new Map<ClientShare, (error: PlateauError) => void>();

  constructor(private readonly spawn: () => WorkerLike) {}

  share(onDeath: (error: PlateauError) => void = () => undefined): ClientShare {
    this.client ??= new PlateauClient({ spawn: this.spawn, onDeath: (error) => this.tell(error) });
    const share: ClientShare = { client: this.client, release: () => this.release(share) };
    this.holders.set(share, onDeath);
    return share;
  }

  private tell(error: PlateauError): void {
    for (const told of [...this.holders.values()]) told(error);
  }

  private release(share: ClientShare): void {
    if (!this.holders.delete(share) || this.holders.size > 0) return;
    this.client?.dispose();
    this.client = undefined;
  }
}
