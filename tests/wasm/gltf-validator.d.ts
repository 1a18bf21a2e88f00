/** The part of it that the tests ask for. */
declare module 'gltf-validator' {
  export interface Report {
    readonly issues: {
      readonly numErrors: number;
      readonly numWarnings: number;
      readonly messages: readonly unknown[];
    };
  }
  export function validateBytes(bytes: Uint8Array): Promise<Report>;
}
