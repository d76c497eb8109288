// The service worker of the display page: keeps its shell (the page, its scripts, styles and fonts), so that a phone that is out of reach of
// the server says so instead of nothing. It never touches what is below /api/: nothing that a person reads or does comes from a cache.

/** The part of a ServiceWorkerGlobalScope that is used. */
interface Scope {
  readonly skipWaiting: () => Promise<void>;
  readonly clients: { readonly claim: () => Promise<void> };
  readonly location: Location;
  readonly registration: { readonly scope: string };
  addEventListener(type: "install" | "activate", listener: (event: { readonly waitUntil: (until: Promise<unknown>) => void }) => void): void;
  addEventListener(type: "fetch", listener: (event: { readonly request: Request; readonly respondWith: (response: Promise<Response>) => void }) => void): void;
}
const scope = self as unknown as Scope;

const kCache = "race-display";
/** A server that is silent for so long is out of reach [ms]. */
const kPatience = 3000;
/** What the page names; further assets (fonts) are kept when they are first read. */
const kNamed = /(?:src|href)="([^"]*\/assets\/[^"]+)"/g;

const shellOf = (): string => scope.registration.scope;

/** Keeps the page as it is now, also its rules, which name the port of STOP; what it names before, and what an earlier one named goes afterwards. */
async function keep(page: Response): Promise<void> {
  if (!page.ok) throw new Error(`status ${page.status}`);
  const cache = await caches.open(kCache);
  const text = await page.clone().text();
  const isSame = text === (await (await cache.match(shellOf()))?.text());
  const named = [...text.matchAll(kNamed)].map(([, address]) => new URL(address ?? "", shellOf()).href);
  if (!isSame) await cache.addAll(named);
  await cache.put(shellOf(), page.clone());
  if (isSame) return;
  const kept = new Set([shellOf(), ...named]);
  for (const { url } of await cache.keys()) if (!kept.has(url)) await cache.delete(url);
}

/** From the server; the kept one if there is no server. */
async function openPage(): Promise<Response> {
  try {
    const page = await fetch(shellOf(), { signal: AbortSignal.timeout(kPatience), cache: "no-cache" });
    await keep(page).catch(() => undefined); // no room, or a refusal: what the server says is shown
    return page;
  } catch (error) {
    const kept = await (await caches.open(kCache)).match(shellOf());
    if (kept !== undefined) return kept;
    throw error;
  }
}

/** The name of an asset has a digest of its content: what is kept is right. */
async function openAsset(request: Request): Promise<Response> {
  const cache = await caches.open(kCache);
  const kept = await cache.match(request.url);
  if (kept !== undefined) return kept;
  const asset = await fetch(request);
  if (asset.ok) await cache.put(request.url, asset.clone()).catch(() => undefined);
  return asset;
}

scope.addEventListener("install", (event) => event.waitUntil(fetch(shellOf()).then(keep).then(scope.skipWaiting.bind(scope))));
scope.addEventListener("activate", (event) => event.waitUntil(scope.clients.claim()));
scope.addEventListener("fetch", (event) => {
  const { request } = event;
  const address = new URL(request.url);
  if (request.method !== "GET" || address.origin !== scope.location.origin) return;
  if (request.mode === "navigate") event.respondWith(openPage());
  else if (address.pathname.startsWith("/assets/")) event.respondWith(openAsset(request));
});
