// How fast the robot goes on its way, as a share of what its tasks ask for (`speed_override` of services/robot). No channel tells it: it is asked for
// when the stream says that something may have changed it, one question at a time, with a pause after each.
import type { HostedService } from "../../generated/messages";
import { isObject, type JsonValue } from "../json";
import type { StreamUpdate } from "../messages/stream";
import { overridable } from "./jog";

/** After each answer [ms]. */
export const kPause = 500;
const kOperation = "speed_override";

export interface SpeedState {
  /** As in svc.<key>; nothing: there is none whose speed can be set. */
  readonly robot: string | undefined;
  /** 0..1; nothing: it is not known. */
  readonly share: number | undefined;
}
export const kNoSpeed: SpeedState = { robot: undefined, share: undefined };

export interface SpeedOptions {
  /** The operation `state` of a robot. */
  readonly ask: (robot: string) => Promise<JsonValue>;
  readonly services: () => readonly HostedService[];
  /** Why it is not asked for. */
  readonly refusal: () => string | undefined;
  readonly after: (time: number, act: () => void) => void;
  readonly onChange: (state: SpeedState) => void;
}

function shareIn(state: JsonValue): number | undefined {
  const share = isObject(state) ? state[kOperation] : undefined;
  return typeof share === "number" ? share : undefined;
}

export function createSpeedWatch({ ask, services, refusal, after, onChange }: SpeedOptions) {
  let state = kNoSpeed;
  let phase: "idle" | "busy" | "changed" = "idle";
  /** What was heard last of the cell and of each run. */
  const heard = new Map<string, string>();

  const set = (next: SpeedState): void => {
    if (next.robot === state.robot && next.share === state.share) return;
    state = next;
    onChange(next);
  };

  function rest(): void {
    const isChanged = phase === "changed";
    phase = "idle";
    if (isChanged) void askNow();
  }

  async function askNow(): Promise<void> {
    if (phase !== "idle") {
      phase = "changed";
      return;
    }
    phase = "busy";
    const robot = overridable(services());
    if (robot !== state.robot) set({ robot, share: undefined });
    const share = robot === undefined || refusal() !== undefined ? undefined : await ask(robot).then(shareIn, () => undefined);
    if (share !== undefined) set({ robot, share });
    after(kPause, rest);
  }

  const isNews = (of: string, now: string): boolean => {
    const before = heard.get(of);
    heard.set(of, now);
    return before !== now;
  };

  function sets(robot: string | undefined, last: string | undefined): boolean {
    const transitions = services().find(({ key }) => key === robot)?.rsm.transitions ?? [];
    return transitions.some(({ id, operation }) => id === last && operation === kOperation);
  }

  function mayChange(update: StreamUpdate): boolean {
    switch (update.type) {
      case "services":
        return true;
      case "services_changed":
        return overridable(services()) !== state.robot || update.services.some(({ key, last }) => key === state.robot && sets(key, last));
      case "control":
        return isNews("cell", `${update.control.mode} ${update.control.stopped === null ? "" : "stopped"}`);
      case "core":
        return isNews(`core/${update.core.id}`, update.core.status);
      case "core_removed":
        heard.delete(`core/${update.id}`);
        return false;
      default:
        return false;
    }
  }

  return {
    /** To be told of each update, when `services` has it. */
    receive: (update: StreamUpdate): void => void (mayChange(update) && askNow()),
    /** The server is not there: it is not known any more. */
    forget: (): void => set({ ...state, share: undefined }),
    /** This page has set it. */
    told: (share: number): void => set({ ...state, share }),
  };
}

/** What is said of a robot that is slower than its tasks ask for; nothing: it is not, or that is not known. */
export function speedSign(share: number | undefined): { readonly title: string; readonly means: string; readonly stands: boolean } | undefined {
  if (share === undefined || share >= 1) return undefined;
  if (share <= 0) return { title: "Speed: 0 %", means: "The robot stands still, and a task that moves it waits.", stands: true };
  return { title: `Speed: ${Math.min(99, Math.max(1, Math.round(share * 100)))} %`, means: "The robot goes slower than its tasks say.", stands: false };
}
