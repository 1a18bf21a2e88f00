/** Keeps the page for later without a network, where the browser can; from a file, or without https, it cannot. */
export function workOffline(): void {
  if (!('serviceWorker' in navigator) || !location.protocol.startsWith('http')) return;
  const register = (): void => {
    navigator.serviceWorker.register('./service-worker.js').catch(() => undefined);
  };
  // What is shown first comes first.
  if (document.readyState === 'complete') register();
  else addEventListener('load', register, { once: true });
}
