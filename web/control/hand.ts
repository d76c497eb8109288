// How a page moves the robot by hand: its one motion, its taught poses, and what it may.
import type { HostedService } from "../generated/messages";
import type { Rights } from "../page/rights";
import { useSelected } from "../page/store";
import type { Api } from "../shared/api";
import type { Session } from "../shared/session/session";
import type { Told } from "../shared/slowly";
import { createMoving, type MovingOptions, type MovingState } from "./moving";
import { createPoses, type PosesState } from "./poses";

export interface HandOptions extends Pick<MovingOptions, "onRefused" | "onArrived"> {
  readonly api: Pick<Api, "callService">;
  readonly session: Told<Session>;
  readonly rights: Rights;
  /** Of the connection that holds the controls. */
  readonly address: () => Promise<string>;
  /** Which tells who has the controls. */
  readonly fetcher: typeof fetch;
  /** What was in the way. */
  readonly onProblem: (error: unknown) => void;
}

/** To be called once by a page. */
export function createHand({ api, session, rights, address, fetcher, onProblem, ...signals }: HandOptions) {
  const services = (): readonly HostedService[] => session.get().services;
  const moving = createMoving({ refusal: () => rights.refusalNow("move_by_hand"), services, ...signals });
  const poses = createPoses({ api, services });
  return {
    moving, poses, address, fetcher, onProblem,
    useRefusal: rights.useRefusal,
    useServices: (): readonly HostedService[] => useSelected(session, ({ services: now }) => now),
    useMoving: <T>(select: (now: MovingState) => T): T => useSelected(moving.store, select),
    usePoses: <T>(select: (now: PosesState) => T): T => useSelected(poses.store, select),
  };
}

export type Hand = ReturnType<typeof createHand>;
