// The cell in 3D with the arm as it stands in a taught pose; what is real does not move.
import { useEffect, useRef, useState } from "react";
import { messageOf } from "../../shared/messageOf";
import { texts } from "../texts";
import { hideArm, showArm } from "./previewScene";

interface Props {
  readonly name: string;
  /** [rad] */
  readonly joints: readonly number[];
}

export function PosePreview({ name, joints }: Props) {
  const frame = useRef<HTMLDivElement>(null);
  const [problem, setProblem] = useState<string>();
  useEffect(() => {
    const shown = frame.current;
    if (shown === null) return undefined;
    let isOver = false;
    showArm(shown, joints, () => !isOver).catch((error: unknown) => isOver || setProblem(messageOf(error)));
    return () => {
      isOver = true;
      hideArm(shown);
    };
  }, [joints]);
  return (
    <figure className="preview">
      <div ref={frame} className="preview-frame" />
      <figcaption>{problem === undefined ? texts.pose.shown(name) : texts.pose.notShown(problem)}</figcaption>
    </figure>
  );
}
