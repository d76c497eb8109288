// The panel below the run bar: the derivation, the time line or the log.
import { DerivationPanel } from "../derivation/DerivationPanel";
import { useView } from "../client";
import { TimelinePanel } from "../timeline/TimelinePanel";
import { LogPanel } from "./LogPanel";

export function Drawer() {
  const drawer = useView((v) => v.drawer);
  if (drawer === "closed") return null;
  return <div className="drawer">{drawer === "derivation" ? <DerivationPanel /> : drawer === "timeline" ? <TimelinePanel /> : <LogPanel />}</div>;
}
