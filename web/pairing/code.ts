// The code by which the server lets a phone in: asked for again when what it is for has changed.
import { useEffect, useState } from "react";
import type { PairingCreate } from "../generated/messages";
import { isRefusal, type Api } from "../shared/api";
import { messageOf } from "../shared/messageOf";
import { texts } from "./texts";

export type CodeState =
  /** The address is all. */
  | { readonly kind: "none" }
  | { readonly kind: "asked" }
  /** `origins`: where networks reach the server. */
  | { readonly kind: "there"; readonly code: string; readonly origins: readonly string[]; readonly until: number }
  | { readonly kind: "over" }
  | { readonly kind: "failed"; readonly why: string };

/** What is in the way, and what to do. */
const whyOf = (error: unknown): string => (isRefusal(error) && error.status === kTooMany ? texts.code.tooMany : texts.code.failed(messageOf(error)));
const kTooMany = 429;

/** After the last key [ms], so that not each letter of a name is a code of its own. */
const kSettle = 500;

/** `pairing`: what the phone may; nothing: it gets no code. `attempt`: another one asks for another code. */
export function useCode(api: Api, pairing: PairingCreate | undefined, attempt: number): CodeState {
  const [state, setState] = useState<CodeState>({ kind: "none" });
  const wanted = pairing === undefined ? undefined : JSON.stringify(pairing);
  useEffect(() => {
    if (wanted === undefined) {
      setState({ kind: "none" });
      return undefined;
    }
    let isOver = false;
    let end: ReturnType<typeof setTimeout> | undefined;
    setState({ kind: "asked" });
    const ask = () =>
      api.createPairing(JSON.parse(wanted) as PairingCreate).then(
        ({ code, expires_s, addresses }) => {
          if (isOver) return;
          setState({ kind: "there", code, origins: addresses.map(({ url }) => url), until: Date.now() + expires_s * 1000 });
          end = setTimeout(() => setState({ kind: "over" }), expires_s * 1000);
        },
        (error: unknown) => isOver || setState({ kind: "failed", why: whyOf(error) }),
      );
    end = setTimeout(() => void ask(), kSettle);
    return () => {
      isOver = true;
      clearTimeout(end);
    };
  }, [api, wanted, attempt]);
  return state;
}
