// The one scene in which poses are looked at: made and filled when it is first asked for, and kept, as both take long.
import { CellScene } from "../../cell/CellScene";
import { hasGpu } from "../../cell/hasGpu";
import type { Body } from "../../generated/messages";
import { listenToTheme } from "../../pro/theme/theme";
import { createHand } from "../../shared/cell/hand";
import { access, api } from "../client";

/** Nothing is pulled here. */
const kNoHand = createHand({ name: "preview", send: () => Promise.reject(new Error("picture")), wait: () => Promise.resolve(), onRefused: () => undefined });

/** Lets what waits for its turn in the page have it: making a scene takes long. */
const otherTasks = (): Promise<void> => new Promise((resolve) => setTimeout(resolve));

interface Kept {
  /** Has the scene, and is moved to where it is looked at. */
  readonly host: HTMLElement;
  readonly scene: CellScene;
  /** What of the cell it is filled with. */
  contents: string;
  /** Of the arm, from its base on. */
  joints: readonly string[];
}

async function make(): Promise<Kept> {
  await otherTasks();
  const isPlain = !hasGpu();
  await otherTasks();
  const host = document.createElement("div");
  host.className = "preview-host";
  const scene = new CellScene(host, kNoHand, isPlain);
  scene.grabbing.isPast = true;
  listenToTheme(() => scene.paint());
  return { host, scene, contents: "", joints: [] };
}

let making: Promise<Kept> | undefined;
function kept(): Promise<Kept> {
  making ??= make().catch((error: unknown) => {
    making = undefined;
    throw error;
  });
  return making;
}

/** The turning joints of an arm, from its base on, as its URDF lists them. */
function armJoints(urdf: string): readonly string[] {
  const document = new DOMParser().parseFromString(urdf, "application/xml");
  return [...document.querySelectorAll("joint[type=revolute], joint[type=continuous]")].flatMap((joint) => joint.getAttribute("name") ?? []);
}

/** All of a body but where it stands now, if it can be moved. */
const partOf = ({ pose, ...body }: Body) => (body.fixed ? { ...body, pose } : body);

/** Filled anew only if the cell has become another one. */
async function fill(into: Kept): Promise<readonly Body[]> {
  const { bodies, robots } = await api.cell();
  const contents = JSON.stringify([bodies.map(partOf), robots]);
  if (contents === into.contents) return bodies;
  const models = await Promise.all(robots.map(async (robot) => ({ ...robot, text: await (await access.fetch(api.cellFile(robot.urdf))).text() })));
  into.scene.fill(bodies, models);
  const [robot] = models;
  into.joints = robot === undefined ? [] : armJoints(robot.text);
  into.contents = contents;
  return bodies;
}

/** Shows the arm in `frame` with these joints [rad], as long as that `isWanted`. */
export async function showArm(frame: HTMLElement, joints: readonly number[], isWanted: () => boolean): Promise<void> {
  const scene = await kept();
  if (!isWanted()) return;
  frame.append(scene.host);
  const bodies = await fill(scene);
  if (!isWanted()) return;
  const places = Object.fromEntries(bodies.filter(({ fixed }) => !fixed).map((body) => [body.name, body.pose]));
  scene.scene.move({ time: 0, joints: Object.fromEntries(joints.flatMap((angle, i) => (scene.joints[i] === undefined ? [] : [[scene.joints[i], angle]]))), bodies: places });
}

/** Takes the scene out of `frame`, if it is there. */
export const hideArm = (frame: HTMLElement): void => frame.replaceChildren();
