// The dialog by which a phone is paired, on this page.
import { PairDialog } from "../../pairing/PairDialog";
import { api, useLogin } from "../client";
import { useRefusal } from "../login/rights";
import { askPairing, usePairing } from "./pairing";

const close = () => askPairing(false);

export function PairPhone() {
  const isAsked = usePairing();
  const me = useLogin((access) => access.me);
  const refusal = useRefusal("pair");
  return isAsked ? <PairDialog api={api} me={me} refusal={refusal} onClose={close} /> : null;
}
