// The panel below the run bar: the derivation or the log.
import { DerivationPanel } from "../derivation/DerivationPanel";
import { useView } from "../client";
import { LogPanel } from "./LogPanel";

export function Drawer() {
  const drawer = useView((v) => v.drawer);
  if (drawer === "closed") return null;
  return <div className="drawer">{drawer === "derivation" ? <DerivationPanel /> : <LogPanel />}</div>;
}
