// The taught poses, as a page knows them: in the database of the cell. Reading and keeping them needs no controls.
import type { HostedService } from "../generated/messages";
import { createStore } from "../page/store";
import type { Api } from "../shared/api";
import { movableOf } from "../shared/control/jog";
import type { JsonValue } from "../shared/json";
import { messageOf } from "../shared/messageOf";
import { keyOfPose, kPosePrefix, poseNames, readPose, type TaughtPose } from "../shared/pendant/poses";

export interface PosesState {
  readonly poses: readonly TaughtPose[];
  readonly isLoaded: boolean;
  /** Why they could not be read. */
  readonly problem: string | undefined;
}

export interface PosesOptions {
  readonly api: Pick<Api, "callService">;
  readonly services: () => readonly HostedService[];
}

const kDatabase = "db";

export function createPoses({ api, services }: PosesOptions) {
  const store = createStore<PosesState, Partial<PosesState>>({ poses: [], isLoaded: false, problem: undefined }, (now, change) => ({ ...now, ...change }));
  const call = (operation: string, kwargs: Readonly<Record<string, JsonValue>>): Promise<JsonValue> => api.callService(kDatabase, operation, kwargs);

  async function read(): Promise<readonly TaughtPose[]> {
    const poses: TaughtPose[] = [];
    for (const name of poseNames(await call("list", { prefix: kPosePrefix }))) {
      const pose = readPose(name, await call("get", { key: keyOfPose(name) }).catch(() => null));
      if (pose !== undefined) poses.push(pose);
    }
    return poses;
  }
  const load = (): Promise<void> =>
    read().then(
      (poses) => store.dispatch({ poses, isLoaded: true, problem: undefined }),
      (error: unknown) => store.dispatch({ isLoaded: true, problem: messageOf(error) }),
    );

  /** Says what was in the way. */
  async function change(act: () => Promise<unknown>): Promise<string | undefined> {
    try {
      await act();
    } catch (error) {
      return messageOf(error);
    }
    await load();
    return undefined;
  }

  return {
    store,
    /** Reads them anew; what is in the way is in the store. */
    load: (): void => void load(),
    /** Where the arm is now, under this name; an old pose of that name is replaced. Says what was in the way. */
    save: (name: string): Promise<string | undefined> =>
      change(async () => {
        const { robot } = movableOf(services());
        if (robot === undefined) throw new Error("no robot is there");
        const { pose, q } = (await api.callService(robot, "state", {})) as { readonly pose: JsonValue; readonly q: JsonValue };
        await call("add", { key: keyOfPose(name), value: { pose, q } });
      }),
    remove: (name: string): Promise<string | undefined> => change(() => call("remove", { key: keyOfPose(name) })),
  };
}

export type Poses = ReturnType<typeof createPoses>;
