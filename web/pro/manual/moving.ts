// The one motion by hand of this page, and how it is set.
import { controls, every } from "../../control/page";
import { kFirstShare, jogOf, movableOf, type JogFrame, type JogPart, type Sign } from "../../shared/control/jog";
import { createJogger } from "../../shared/control/jogger";
import { CallError } from "../../shared/control/link";
import { session } from "../client";
import { refusalNow } from "../login/rights";
import { createStore, useSelected } from "../store";

interface Moving {
  /** Of the fastest motion, 0..1: slow at first. */
  readonly share: number;
  readonly frame: JogFrame;
  /** Why the last motion was not made. */
  readonly refused: string | undefined;
}

const store = createStore<Moving, Partial<Moving>>({ share: kFirstShare, frame: "o", refused: undefined }, (now, change) => ({ ...now, ...change }));
export const useMoving = <T>(select: (now: Moving) => T): T => useSelected(store, select);
export const setMoving = (change: Partial<Moving>): void => store.dispatch(change);

/** The robot of the motion that goes on. */
let robot: string | undefined;

const jogger = createJogger({
  call: (operation, kwargs) => (robot === undefined ? Promise.reject(new CallError("missing", "no robot is there")) : controls.call(robot, operation, kwargs)),
  every,
  onRefused: (why) => store.dispatch({ refused: why }),
});

/** A button is held; it must be let go. */
export function beginMotion(part: JogPart, sign: Sign): void {
  const refused = refusalNow("move_by_hand");
  store.dispatch({ refused });
  if (refused !== undefined) return;
  const { share, frame } = store.get();
  robot = movableOf(session.get().services).robot;
  jogger.start(jogOf(part, sign, share, frame));
}

export const endMotion = (): void => jogger.end();
