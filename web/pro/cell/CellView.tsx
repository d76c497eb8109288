// The cell in 3D, as the server's poses move it.
import { useEffect, useRef, useState } from "react";
import { api, cellPose } from "../client";
import { CellScene } from "./CellScene";

export function CellView() {
  const frame = useRef<HTMLDivElement>(null);
  const [failed, setFailed] = useState<string>();
  useEffect(() => {
    const host = frame.current;
    if (host === null) return;
    const scene = new CellScene(host);
    let current = true;
    const load = async () => {
      const description = await api.cell();
      const robots = await Promise.all(
        description.robots.map(async (robot) => ({ ...robot, text: await (await fetch(api.cellFile(robot.urdf))).text() })),
      );
      if (!current) return;
      scene.fill(description.bodies, robots);
      const pose = cellPose.get();
      if (pose !== undefined) scene.move(pose);
    };
    load().catch((error: unknown) => current && setFailed(error instanceof Error ? error.message : String(error)));
    const stop = cellPose.listen(() => {
      const pose = cellPose.get();
      if (pose !== undefined) scene.move(pose);
    });
    return () => {
      current = false;
      stop();
      scene.dispose();
    };
  }, []);
  return (
    <section className="cell" aria-label="Cell">
      <div className="cell-frame" ref={frame} />
      {failed !== undefined && <p className="cell-note">The cell cannot be shown: {failed}</p>}
      <CellClock />
    </section>
  );
}

function CellClock() {
  const text = useRef<HTMLParagraphElement>(null);
  useEffect(
    () =>
      cellPose.listen(() => {
        const pose = cellPose.get();
        if (text.current !== null && pose !== undefined) text.current.textContent = `cell time ${pose.time.toFixed(2)} s`;
      }),
    [],
  );
  return <p className="cell-clock" ref={text} />;
}
