// A stored run as an MCAP file, which Foxglove opens: all that the server has of it, in parts.
import type { CellPose, Run, RunPictures, Samples } from "../../generated/messages";
import type { Api } from "../api";
import { counted } from "../counted";
import { messageOf } from "../messageOf";
import { inOrder } from "./inOrder";
import type { McapMessage } from "./message";
import { pictureMessage, poseMessages } from "./poseMessages";
import { movingJoints, type Robot } from "./robot";
import { loadRunTimes, type RunTimes } from "./runTimes";
import { endMessage, serviceMessage, stepMessages } from "./stepMessages";
import { worldClock, type WorldClock } from "./worldClock";
import { writeMcap } from "./writeMcap";

/** A longer run is not exported [macro steps]. */
export const kMostSteps = 100_000;
/** The server derives so many macro steps at once. */
const kPart = 100;

export type Source = Pick<Api, "storedRun" | "timing" | "derivations" | "samples" | "pictures" | "picture">;

/** A robot of the cell, with the text of its URDF. */
export interface CellRobot {
  readonly robot: Robot;
  readonly file: string;
  readonly text: string;
}

export interface Exporting {
  /** Aborts between two requests; then it throws the reason. */
  readonly signal: AbortSignal;
  /** How much of it is done, from 0 to 1. */
  readonly told: (part: number) => void;
  /** The robots of the cell as it is now: the run has recorded their joints, not their links. */
  readonly loadRobots: () => Promise<readonly CellRobot[]>;
}

export interface Exported {
  readonly file: Blob;
  /** What is missing in it, for people. */
  readonly notes: readonly string[];
}

const kMillisecond = 1000;
const kSecond = 1e6;

/** What is exported of a run, and by which clocks. */
interface Parts {
  readonly api: Source;
  readonly run: Run;
  /** When it was made [us] since 1970. */
  readonly made: number;
  readonly times: RunTimes;
  readonly signal: AbortSignal;
  readonly done: () => void;
}

async function* messagesOfSteps({ api, run, made, times, signal, done }: Parts): AsyncGenerator<McapMessage, void, void> {
  for (let from = 1; from <= run.steps; from += kPart) {
    signal.throwIfAborted();
    for (const step of await api.derivations(run.id, from, Math.min(run.steps, from + kPart - 1), "runs")) {
      const arrived = times.arrived(step.step);
      yield* stepMessages(step, { began: made + times.began(step.step), timed: times.isTimed(step.step), arrived: arrived === undefined ? undefined : made + arrived });
      done();
    }
  }
  if (run.ended !== undefined) yield endMessage(run, made + times.next(run.steps));
}

/** The times at which things were recorded [us] since 1970, which never fall. */
function risingTimes(recorded: readonly { readonly step: number; readonly time: number }[], made: number, clock: WorldClock): readonly number[] {
  let last = 0;
  return recorded.map((one) => (last = Math.max(last, made + clock.at(one))));
}

function* messagesOfPoses(samples: readonly { readonly pose: CellPose }[], times: readonly number[], robots: readonly Robot[]): Generator<McapMessage, void, void> {
  for (const [i, { pose }] of samples.entries()) yield* poseMessages(pose, times[i] ?? 0, robots);
}

async function* messagesOfPictures({ api, run, signal, done }: Parts, pictures: RunPictures["pictures"], times: readonly number[]): AsyncGenerator<McapMessage, void, void> {
  for (const [i, { number }] of pictures.entries()) {
    signal.throwIfAborted();
    yield pictureMessage(await api.picture(run.id, number), times[i] ?? 0);
    done();
  }
}

/** The robots whose joints are those that were recorded, or why there are none. */
async function robotsOf(samples: Samples, loadRobots: Exporting["loadRobots"]): Promise<{ readonly robots: readonly CellRobot[]; readonly note?: string }> {
  const recorded = samples[0]?.pose.joints;
  if (recorded === undefined) return { robots: [] };
  try {
    const all = await loadRobots();
    const robots = all.filter(({ robot }) => movingJoints(robot).every((name) => Object.hasOwn(recorded, name)));
    return robots.length === all.length ? { robots } : { robots, note: "The cell has another robot now: there are no frames of links." };
  } catch (error) {
    return { robots: [], note: `There are no frames of links: ${messageOf(error)}` };
  }
}

function metadataOf(run: Run, times: RunTimes, doubt: number, notes: readonly string[]): Readonly<Record<string, string>> {
  return {
    run: run.id,
    document: run.document,
    revision: String(run.revision),
    status: run.status,
    ...(run.outcome !== undefined && { outcome: run.outcome }),
    arguments: JSON.stringify(run.arguments),
    ...(run.results !== undefined && { results: JSON.stringify(run.results) }),
    steps: String(run.steps),
    steps_without_time: String(times.untimed),
    chain: run.chain,
    clock: "ns since 1970 by the clock of the server at which the run was made, then by its steady clock",
    pose_time_doubt_s: Number.isFinite(doubt) ? String(doubt / kSecond) : "unknown",
    missing: notes.join(" "),
  };
}

/** Throws what the server refuses, and if the run is too long. */
export async function exportRun(api: Source, id: string, { signal, told, loadRobots }: Exporting): Promise<Exported> {
  const run = await api.storedRun(id);
  if (run.steps > kMostSteps) throw new Error(`A run of more than ${counted(kMostSteps, "macro step")} is not exported.`);
  const times = await loadRunTimes(api, run, signal);
  const [samples, pictures] = [await api.samples(id), await api.pictures(id)];
  const { robots, note } = await robotsOf(samples, loadRobots);
  const poses = samples.map(({ step, pose }) => ({ step, time: pose.time }));
  const clock = worldClock(poses.length > 0 ? poses : pictures, times);
  const notes = [
    ...(note === undefined ? [] : [note]),
    ...(times.untimed === 0 ? [] : [`When it began is not recorded of ${counted(times.untimed, "macro step")}: they have the time of the one before.`]),
    ...(poses.length === 0 ? ["No poses of the cell are recorded."] : []),
    ...(pictures.length === 0 ? ["No pictures of cameras are recorded."] : []),
  ];
  const made = run.created * kMillisecond;
  const all = run.steps + pictures.length;
  let count = 0;
  const parts: Parts = { api, run, made, times, signal, done: () => told(++count / all) };
  const messages = inOrder([
    times.services.map((change) => serviceMessage(change, made + change.time)),
    messagesOfSteps(parts),
    messagesOfPoses(samples, risingTimes(poses, made, clock), robots.map(({ robot }) => robot)),
    messagesOfPictures(parts, pictures, risingTimes(pictures, made, clock)),
  ]);
  const attachments = robots.map(({ file, text }) => ({ name: file, mediaType: "application/xml", text, time: made }));
  const file = await writeMcap(messages, { metadata: metadataOf(run, times, clock.doubt, notes), attachments });
  return { file, notes };
}
