// The panel below the run bar: the derivation, the time line, the calls and events, the log, or the motion by hand.
import { CallLog } from "../calls/CallLog";
import { DerivationPanel } from "../derivation/DerivationPanel";
import type { Drawer as DrawerName } from "../../shared/session/view";
import { useView } from "../client";
import { Splitter } from "../layout/Splitter";
import { ManualPanel } from "../manual/ManualPanel";
import { TimelinePanel } from "../timeline/TimelinePanel";
import { LogPanel } from "./LogPanel";

const panels: Readonly<Record<Exclude<DrawerName, "closed">, () => React.ReactNode>> = { derivation: DerivationPanel, timeline: TimelinePanel, calls: CallLog, log: LogPanel, manual: ManualPanel };

export function Drawer() {
  const drawer = useView((v) => v.drawer);
  if (drawer === "closed") return null;
  const Panel = panels[drawer];
  return (
    <div className="drawer">
      <Splitter panel="drawer" at="top" />
      <Panel />
    </div>
  );
}
