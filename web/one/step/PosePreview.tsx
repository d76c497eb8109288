// The cell in 3D with the arm as it stands in a taught pose; what is real does not move.
import { useEffect, useRef, useState } from "react";
import { CellScene } from "../../cell/CellScene";
import { hasGpu } from "../../cell/hasGpu";
import { listenToTheme } from "../../pro/theme/theme";
import { createHand } from "../../shared/cell/hand";
import { messageOf } from "../../shared/messageOf";
import { access, api } from "../client";
import { texts } from "../texts";

/** Nothing is pulled here. */
const kNoHand = createHand({ name: "preview", send: () => Promise.reject(new Error("picture")), wait: () => Promise.resolve(), onRefused: () => undefined });

async function fill(scene: CellScene, joints: readonly number[]): Promise<void> {
  const { bodies, robots } = await api.cell();
  const models = await Promise.all(robots.map(async (robot) => ({ ...robot, text: await (await access.fetch(api.cellFile(robot.urdf))).text() })));
  scene.fill(bodies, models);
  const [robot] = models;
  const names = robot === undefined ? [] : armJoints(robot.text);
  const places = Object.fromEntries(bodies.filter(({ fixed }) => !fixed).map((body) => [body.name, body.pose]));
  scene.move({ time: 0, joints: Object.fromEntries(joints.flatMap((angle, i) => (names[i] === undefined ? [] : [[names[i], angle]]))), bodies: places });
}

/** The turning joints of an arm, from its base on, as its URDF lists them. */
function armJoints(urdf: string): readonly string[] {
  const document = new DOMParser().parseFromString(urdf, "application/xml");
  return [...document.querySelectorAll("joint[type=revolute], joint[type=continuous]")].flatMap((joint) => joint.getAttribute("name") ?? []);
}

/** Lets what waits for its turn in the page have it: making a scene takes long. */
const otherTasks = (): Promise<void> => new Promise((resolve) => setTimeout(resolve));

interface Props {
  readonly name: string;
  /** [rad] */
  readonly joints: readonly number[];
}

export function PosePreview({ name, joints }: Props) {
  const frame = useRef<HTMLDivElement>(null);
  const [problem, setProblem] = useState<string>();
  useEffect(() => {
    let isOver = false;
    let close = (): void => undefined;
    const show = async () => {
      await otherTasks();
      const isPlain = !hasGpu();
      await otherTasks();
      if (isOver || frame.current === null) return;
      const scene = new CellScene(frame.current, kNoHand, isPlain);
      scene.grabbing.isPast = true;
      const ended = listenToTheme(() => scene.paint());
      close = () => {
        ended();
        scene.dispose();
      };
      await fill(scene, joints);
    };
    show().catch((error: unknown) => isOver || setProblem(messageOf(error)));
    return () => {
      isOver = true;
      close();
    };
  }, [joints]);
  return (
    <figure className="preview">
      <div ref={frame} className="preview-frame" />
      <figcaption>{problem === undefined ? texts.pose.shown(name) : texts.pose.notShown(problem)}</figcaption>
    </figure>
  );
}
