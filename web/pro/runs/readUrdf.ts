// The joints of a URDF, as far as they place links.
import { ofRollPitchYaw, type Vector } from "../../shared/mcap/rotation";
import type { Joint, Robot } from "../../shared/mcap/robot";

const kKinds: ReadonlyMap<string, Joint["kind"]> = new Map([["fixed", "fixed"], ["revolute", "turns"], ["continuous", "turns"], ["prismatic", "slides"]]);

/** The three numbers of an attribute; without it, `otherwise`. */
function vectorOf(element: Element | null, name: string, otherwise: Vector): Vector {
  const text = element?.getAttribute(name);
  if (text === null || text === undefined) return otherwise;
  const [x = NaN, y = NaN, z = NaN] = text.trim().split(/\s+/).map(Number);
  if (!Number.isFinite(x + y + z)) throw new Error(`the URDF has ${name}="${text}", which is no vector`);
  return [x, y, z];
}

function jointOf(element: Element): Joint {
  const child = (tag: string) => element.querySelector(`:scope > ${tag}`);
  const link = (tag: string) => child(tag)?.getAttribute("link") ?? "";
  const [name, type] = [element.getAttribute("name") ?? "", element.getAttribute("type") ?? ""];
  const kind = kKinds.get(type);
  if (kind === undefined) throw new Error(`the URDF has a joint ${name} of the type ${type}`);
  const origin = child("origin");
  const pose = { position: vectorOf(origin, "xyz", [0, 0, 0]), orientation: ofRollPitchYaw(vectorOf(origin, "rpy", [0, 0, 0])) };
  return { name, kind, parent: link("parent"), child: link("child"), origin: pose, axis: vectorOf(child("axis"), "xyz", [1, 0, 0]) };
}

/** Throws for a text that is no URDF, and for joints of other kinds. */
export function readUrdf(text: string): Pick<Robot, "root" | "joints"> {
  const urdf = new DOMParser().parseFromString(text, "application/xml");
  const joints = [...urdf.querySelectorAll("robot > joint")].map(jointOf);
  const placed = new Set(joints.map(({ child }) => child));
  const root = [...urdf.querySelectorAll("robot > link")].map((link) => link.getAttribute("name") ?? "").find((name) => !placed.has(name));
  if (root === undefined) throw new Error("the URDF has no root link");
  return { root, joints };
}
