// When the robot begins to brake, by its own states, each of which a run has in its journal.
import type { Fixture } from "./fixture";

/** Between two states [s]. */
const kPeriod = 0.01;
/** [rad/s2]; it speeds up and slows down by less than 1, and brakes with 8 (services/robot). */
const kBrakes = 4;
/** [rad/s] */
const kStands = 1e-3;

/** It hears each state of the robot, and moves nothing. */
const watching = {
  rcm: 1,
  name: "watching",
  root: { state: "Root", results: [{ name: "dq" }], actions: [{ when: "svc.robot.robot_state", do: "res.dq = svc.robot.robot_state.dq" }] },
};

interface Derived {
  readonly step: number;
  readonly input: { readonly kind: string; readonly data: { readonly dq: readonly number[] } };
}

export interface Braking {
  /** After `lost`, each [ms]. */
  readonly brakes: number;
  readonly stands: number;
}

export interface RobotWatch {
  /** Whether the first joint turns now. */
  readonly moves: () => Promise<boolean>;
  /** What the robot did about `lost` [ms since 1970]; it must stand now. */
  readonly braking: (lost: number) => Promise<Braking>;
}

/** Requires a server without accounts. */
export async function watchRobot({ send }: Pick<Fixture, "send">): Promise<RobotWatch> {
  await send("PUT", "/documents/watching", watching);
  const { id } = (await send("POST", "/cores", { document: "watching" })) as { readonly id: string };
  await send("POST", `/cores/${id}/start`);
  const { created } = (await send("GET", `/runs/${id}`)) as { readonly created: number };

  /** Of the first joint: [ms since 1970, rad/s], of the last `count` steps. */
  async function speeds(count: number): Promise<readonly (readonly [number, number])[]> {
    const { step: last } = (await send("GET", `/cores/${id}`)) as { readonly step: number };
    const first = Math.max(1, last - count + 1);
    const { steps } = (await send("GET", `/runs/${id}/timing?from=${first}&to=${last}`)) as { readonly steps: readonly { readonly step: number; readonly arrived?: number }[] };
    const times = new Map(steps.map(({ step, arrived }) => [step, arrived]));
    const found: (readonly [number, number])[] = [];
    for (let from = first; from <= last; from += 100) {
      const part = (await send("GET", `/cores/${id}/derivations?from=${from}&to=${Math.min(from + 99, last)}`)) as { readonly steps: readonly Derived[] };
      for (const { step, input } of part.steps) {
        const arrived = times.get(step);
        if (arrived !== undefined && input.kind === "event") found.push([created + arrived / 1000, Math.abs(input.data.dq[0] ?? 0)]);
      }
    }
    return found;
  }

  return {
    moves: async () => ((await speeds(2)).at(-1)?.[1] ?? 0) > kStands,
    braking: async (lost) => {
      const all = (await speeds(800)).filter(([at]) => at >= lost - 100);
      const brakes = all.find(([at, speed], i) => at >= lost - 1000 * kPeriod && speed - (all[i + 1]?.[1] ?? speed) > kBrakes * kPeriod);
      if (brakes === undefined) throw new Error(`it did not brake: ${JSON.stringify(all.filter((_, i) => i % 10 === 0))}`);
      const stands = all.find(([at, speed]) => at > brakes[0] && speed < kStands);
      if (stands === undefined) throw new Error("it does not stand");
      return { brakes: Math.max(0, brakes[0] - lost), stands: stands[0] - lost };
    },
  };
}
