// The one motion by hand of a page, and how it is set.
import type { HostedService } from "../generated/messages";
import { goingTo, jogging, kGuiding, createHeldMotion, type HeldCall } from "../shared/control/heldMotion";
import { kFirstShare, jogOf, movableOf, type JogFrame, type JogPart, type Sign } from "../shared/control/jog";
import { CallError } from "../shared/control/link";
import { createStore } from "../page/store";
import { controls, every } from "./page";
import { texts } from "./texts";

export interface MovingState {
  /** Of the fastest motion, 0..1: slow at first. */
  readonly share: number;
  readonly frame: JogFrame;
  /** Why the last motion was not made. */
  readonly refused: string | undefined;
}

export interface MovingOptions {
  /** Why nothing is moved by hand now. */
  readonly refusal: () => string | undefined;
  readonly services: () => readonly HostedService[];
  /** A motion was refused, or has ended by itself. */
  readonly onRefused?: () => void;
  /** The arm has arrived where it was to go, and the button is still held. */
  readonly onArrived?: () => void;
}

export function createMoving({ refusal, services, onRefused, onArrived }: MovingOptions) {
  const store = createStore<MovingState, Partial<MovingState>>({ share: kFirstShare, frame: "o", refused: undefined }, (now, change) => ({ ...now, ...change }));
  /** The robot of the motion that goes on. */
  let robot: string | undefined;
  const refuse = (refused: string): void => {
    store.dispatch({ refused });
    onRefused?.();
  };
  const motion = createHeldMotion({
    call: (operation, kwargs) => (robot === undefined ? Promise.reject(new CallError("missing", texts.hold.noRobot)) : controls.call(robot, operation, kwargs)),
    every,
    onRefused: refuse,
    ...(onArrived !== undefined && { onDone: onArrived }),
  });
  /** A button is held; it must be let go. */
  function begin(call: HeldCall): void {
    const refused = refusal();
    store.dispatch({ refused: undefined });
    if (refused !== undefined) {
      refuse(refused);
      return;
    }
    motion.end();
    robot = movableOf(services()).robot;
    motion.start(call);
  }
  return {
    store,
    set: (change: Partial<Pick<MovingState, "share" | "frame">>): void => store.dispatch(change),
    jog: (part: JogPart, sign: Sign): void => begin(jogging(jogOf(part, sign, store.get().share, store.get().frame))),
    /** The arm gives way to a hand. */
    guide: (): void => begin(kGuiding),
    /** To joints [rad]. */
    goTo: (joints: readonly number[]): void => begin(goingTo(joints, store.get().share)),
    end: (): void => motion.end(),
    /** What goes on ends, and a person is told why nothing moves. */
    refuse(why: string): void {
      motion.end();
      refuse(why);
    },
  };
}

export type Moving = ReturnType<typeof createMoving>;
