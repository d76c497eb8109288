// Layouts of the demo's tasks that come with the pages, so that the first visit of a browser need not wait for ELK.
// tests/browser/shippedLayouts.test.ts demands that they are there, and makes shippedLayouts.json.
import { version } from "elkjs/package.json";
import type { KeptLayout } from "../../shared/drawing/keptLayouts";
import address from "./shippedLayouts.json?url";

/** By the keys of graphs (keyOfText); of another version of ELK, none is used. */
interface Shipped {
  readonly elk: string;
  readonly layouts: Readonly<Record<string, KeptLayout>>;
}

let loading: Promise<Shipped["layouts"]> | undefined;

async function load(): Promise<Shipped["layouts"]> {
  const answer = await fetch(address);
  if (!answer.ok) throw new Error(`${address}: ${answer.status}`);
  const { elk, layouts } = (await answer.json()) as Shipped;
  return elk === version ? layouts : {};
}

/** Has them on their way before one is asked for. */
export function fetchShipped(): void {
  void (loading ??= load()).catch(() => undefined);
}

/** The layout that was shipped under this key. Rejected: they are not to be had. */
export const shippedLayout = async (key: string): Promise<KeptLayout | undefined> => (await (loading ??= load()))[key];
