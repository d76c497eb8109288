// The layouts that need no engine: those that this browser keeps from one visit to the next (IndexedDB), and those of the demo.
import { clear, createStore, get, keys, set, type UseStore } from "idb-keyval";
import { version } from "elkjs/package.json";
import type { KeptLayout, LayoutStore } from "../../shared/drawing/keptLayouts";
import { fetchShipped, shippedLayout } from "./shippedLayouts";

/** With more, all are forgotten when the page opens: those that are in use come again. */
const kMost = 2000;

let opened: Promise<UseStore> | undefined;

async function open(): Promise<UseStore> {
  const store = createStore("race-layouts", "layouts");
  const count = (await keys(store)).length;
  // The first visit of this browser: its layouts are those that come with the pages, if any.
  if (count === 0) fetchShipped();
  if (count > kMost) await clear(store);
  return store;
}

// A browser that keeps nothing (a private window) rejects it, each time.
const inStore = async <T>(request: (store: UseStore) => Promise<T>): Promise<T> => request(await (opened ??= open()));

/** Another version of ELK may lay out otherwise. */
const named = (key: string): string => `${version} ${key}`;

/** Has the store ready, and what it lacks on its way, when the first model arrives. */
export function prepareLayouts(): void {
  void (opened ??= open()).catch(() => undefined);
}

export const layoutStore: LayoutStore = {
  get: async (key) => (await inStore((store) => get<KeptLayout>(named(key), store)).catch(() => undefined)) ?? shippedLayout(key),
  set: (key, kept) => inStore((store) => set(named(key), kept, store)),
};
