// The code in the fragment of the address, by which this phone is paired: exchanged once, and not left in the address.
import { codeOf, notPairedText } from "../shared/display/pairing";
import { createStore, useSelected } from "../page/store";
import { pair } from "./client";

export type PairingState =
  | { readonly kind: "none" }
  | { readonly kind: "pairing" }
  | { readonly kind: "paired"; readonly account: string; readonly role: string; readonly expires: number }
  | { readonly kind: "failed"; readonly why: string };

const store = createStore<PairingState, PairingState>({ kind: "none" }, (_, next) => next);
export const usePairing = (): PairingState => useSelected(store, (now) => now);
export const dismissPairing = (): void => store.dispatch({ kind: "none" });

/** To be called once: a code that is scanned while the page is open changes its address alone. */
export const followCodes = (): void => addEventListener("hashchange", () => void pairByAddress());

/** To be called before the page connects. */
export async function pairByAddress(): Promise<void> {
  const code = codeOf(location.hash);
  if (code === undefined) return;
  // Who looks at the history of this browser later finds no code.
  history.replaceState(null, "", location.pathname + location.search);
  store.dispatch({ kind: "pairing" });
  try {
    const { account, role, expires } = await pair(code);
    store.dispatch({ kind: "paired", account: account.name, role, expires });
  } catch (error) {
    store.dispatch({ kind: "failed", why: notPairedText(error) });
  }
}
