// The taught poses: read once for all that shows them, and anew when they may be others.
import { useEffect } from "react";
import type { PosesState } from "../control/poses";
import { refusalTo } from "../shared/login/doings";
import { isOver } from "../shared/run/controls";
import { watchedCore } from "../shared/session/session";
import { me, session } from "./client";
import { hand } from "./hand";

/** The connection, and the run that is over: it may have taught some. */
function stateNow(): string {
  const now = session.get();
  const core = watchedCore(now);
  return `${now.connection} ${core !== undefined && isOver(core) ? core.id : ""}`;
}

/** An observer is told of none. */
export function loadPoses(): void {
  if (session.get().connection === "open" && refusalTo(me(), "call_service") === undefined) hand.poses.load();
}

let isFollowed = false;
function follow(): void {
  if (isFollowed) return;
  isFollowed = true;
  let before = stateNow();
  session.listen(() => {
    const now = stateNow();
    if (now === before) return;
    before = now;
    loadPoses();
  });
  // Somebody may have taught one with a phone.
  addEventListener("focus", loadPoses);
  loadPoses();
}

export function useTaughtPoses(): PosesState {
  useEffect(follow, []);
  return hand.usePoses((now) => now);
}
