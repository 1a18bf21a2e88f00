// Plateau without a network, after the first visit. The build puts `build` in front, the files of the page and a hash
// over their contents, and writes service-worker.js; the page registers it (src/app/offline.ts).
/* global build, caches, self */

const prefix = `plateau ${self.registration.scope} `;
const cacheName = prefix + build.version;

self.addEventListener('install', (event) => {
  const kept = caches.open(cacheName).then((cache) => cache.addAll(build.files));
  event.waitUntil(kept.then(() => self.skipWaiting()));
});

self.addEventListener('activate', (event) => {
  event.waitUntil(replaceOthers());
});

/** Deletes what other builds have kept for this address; copies of Plateau elsewhere on the server keep theirs. */
async function replaceOthers() {
  const names = await caches.keys();
  const old = names.filter((name) => name.startsWith(prefix) && name !== cacheName);
  await Promise.all(old.map((name) => caches.delete(name)));
  await self.clients.claim();
}

self.addEventListener('fetch', (event) => {
  const { request } = event;
  const { origin, pathname } = new URL(request.url);
  if (request.method !== 'GET' || origin !== self.location.origin) return;
  // What lies in assets has a hash of its content in its name and is never old; all else is asked for first.
  const hashed = pathname.startsWith(new URL('./assets/', self.registration.scope).pathname);
  event.respondWith(hashed ? keptFirst(request) : networkFirst(request));
});

/** A page by its address, a folder by its index.html; any other address shows the page that Plateau is. */
async function kept(request) {
  const cache = await caches.open(cacheName);
  const match = (asked) => cache.match(asked, { ignoreSearch: true });
  if (request.mode !== 'navigate') return match(request);
  const address = new URL(request.url);
  if (address.pathname.endsWith('/')) address.pathname += 'index.html';
  return (await match(address)) ?? match('./index.html');
}

async function keptFirst(request) {
  return (await kept(request)) ?? fetch(request);
}

async function networkFirst(request) {
  try {
    return await fetch(request);
  } catch (error) {
    const answer = await kept(request);
    if (answer) return answer;
    throw error;
  }
}
