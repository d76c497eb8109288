// The taught poses, as this page knows them: in the database of the cell.
import type { JsonValue } from "../../shared/json";
import { messageOf } from "../../shared/messageOf";
import { movableOf } from "../../shared/control/jog";
import { keyOfPose, kPosePrefix, poseNames, readPose, type TaughtPose } from "../../shared/pendant/poses";
import { createStore, useSelected } from "../../page/store";
import { api, session } from "../client";

interface Poses {
  readonly poses: readonly TaughtPose[];
  readonly isLoaded: boolean;
  /** Why they could not be read. */
  readonly problem: string | undefined;
}

const store = createStore<Poses, Partial<Poses>>({ poses: [], isLoaded: false, problem: undefined }, (now, change) => ({ ...now, ...change }));
export const usePoses = <T>(select: (now: Poses) => T): T => useSelected(store, select);

const kDatabase = "db";

const call = (operation: string, kwargs: Readonly<Record<string, JsonValue>>): Promise<JsonValue> => api.callService(kDatabase, operation, kwargs);

async function read(): Promise<readonly TaughtPose[]> {
  const poses: TaughtPose[] = [];
  for (const name of poseNames(await call("list", { prefix: kPosePrefix }))) {
    const pose = readPose(name, await call("get", { key: keyOfPose(name) }).catch(() => null));
    if (pose !== undefined) poses.push(pose);
  }
  return poses;
}

export function loadPoses(): void {
  read().then(
    (poses) => store.dispatch({ poses, isLoaded: true, problem: undefined }),
    (error: unknown) => store.dispatch({ isLoaded: true, problem: messageOf(error) }),
  );
}

/** Says what was in the way. */
async function change(act: () => Promise<unknown>): Promise<string | undefined> {
  try {
    await act();
    loadPoses();
    return undefined;
  } catch (error) {
    return messageOf(error);
  }
}

/** Where the arm is now, under this name; an old pose of that name is replaced. */
export const savePose = (name: string): Promise<string | undefined> =>
  change(async () => {
    const { robot } = movableOf(session.get().services);
    if (robot === undefined) throw new Error("no robot is there");
    const state = await api.callService(robot, "state", {});
    const { pose, q } = state as { readonly pose: JsonValue; readonly q: JsonValue };
    await call("add", { key: keyOfPose(name), value: { pose, q } });
  });

export const removePose = (name: string): Promise<string | undefined> => change(() => call("remove", { key: keyOfPose(name) }));
