// The taught poses, as a page knows them: in the database of the cell. Reading and keeping them needs no controls.
import type { HostedService } from "../generated/messages";
import { createStore } from "../page/store";
import type { Api } from "../shared/api";
import { movableOf } from "../shared/control/jog";
import type { JsonValue } from "../shared/json";
import { messageOf } from "../shared/messageOf";
import { keyOfPose, kMostPoses, kPosePrefix, poseNames, readPose, type TaughtPose } from "../shared/pendant/poses";
import { texts } from "./texts";

export interface PosesState {
  /** The first kMostPoses of those that the arm can go to. */
  readonly poses: readonly TaughtPose[];
  /** Of all that are there, also of what is none. */
  readonly names: readonly string[];
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
  const store = createStore<PosesState, Partial<PosesState>>({ poses: [], names: [], isLoaded: false, problem: undefined }, (now, change) => ({ ...now, ...change }));
  const call = (operation: string, kwargs: Readonly<Record<string, JsonValue>>): Promise<JsonValue> => api.callService(kDatabase, operation, kwargs);

  async function read(): Promise<Pick<PosesState, "poses" | "names">> {
    const poses: TaughtPose[] = [];
    const names = poseNames(await call("list", { prefix: kPosePrefix }));
    for (const name of names) {
      if (poses.length >= kMostPoses) break;
      const pose = readPose(name, await call("get", { key: keyOfPose(name) }).catch(() => null));
      if (pose !== undefined) poses.push(pose);
    }
    return { poses, names };
  }
  /** Counts what was begun to be read: what is older than the newest is not taken. */
  let newest = 0;
  function load(): Promise<void> {
    const number = ++newest;
    const take = (found: Partial<PosesState>): void => {
      if (number === newest) store.dispatch({ ...found, isLoaded: true });
    };
    return read().then(
      (found) => take({ ...found, problem: undefined }),
      (error: unknown) => take({ problem: messageOf(error) }),
    );
  }
  /** Under way for whoever asks meanwhile. */
  let reading: Promise<void> | undefined;

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
    /** Reads them anew, unless that is under way; what is in the way is in the store. */
    load: (): void => {
      reading ??= load().finally(() => (reading = undefined));
    },
    /** Where the arm is now, under this name; `replaces`: in place of the pose of that name. Says what was in the way. */
    save: (name: string, replaces = false): Promise<string | undefined> =>
      change(async () => {
        // Somebody may have saved one since this page has read them.
        if (!replaces && poseNames(await call("list", { prefix: keyOfPose(name) })).includes(name)) {
          await load();
          throw new Error(texts.poses.taken(name));
        }
        const { robot } = movableOf(services());
        if (robot === undefined) throw new Error(texts.hold.noRobot);
        const { pose, q } = (await api.callService(robot, "state", {})) as { readonly pose: JsonValue; readonly q: JsonValue };
        await call("add", { key: keyOfPose(name), value: { pose, q } });
      }),
    remove: (name: string): Promise<string | undefined> => change(() => call("remove", { key: keyOfPose(name) })),
  };
}

export type Poses = ReturnType<typeof createPoses>;
