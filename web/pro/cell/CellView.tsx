// The cell in 3D, as the server's poses move it; hands pull on it, parts are taken away and put back.
import { useEffect, useRef, useState } from "react";
import { absentParts } from "../../shared/cell/touch";
import { createHand } from "../../shared/cell/hand";
import { api, cellPose } from "../client";
import { CellScene } from "./CellScene";

interface Menu {
  readonly part: string;
  readonly x: number;
  readonly y: number;
}

const textOf = (error: unknown): string => (error instanceof Error ? error.message : String(error));

export function CellView() {
  const frame = useRef<HTMLDivElement>(null);
  const shown = useRef<CellScene>(undefined);
  const [failed, setFailed] = useState<string>();
  const [refused, setRefused] = useState<string>();
  const [pulling, setPulling] = useState(false);
  const [menu, setMenu] = useState<Menu>();
  const [absent, setAbsent] = useState<readonly string[]>([]);
  useEffect(() => {
    const host = frame.current;
    if (host === null) return;
    const hand = createHand({
      name: `page-${Math.random().toString(36).slice(2, 10)}`,
      act: (act) => (setRefused(undefined), api.act(act)),
      wait: (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds)),
      onRefused: (error) => setRefused(textOf(error)),
    });
    const scene = new CellScene(host, hand);
    shown.current = scene;
    let current = true;
    let stop = () => {};
    const load = async () => {
      const description = await api.cell();
      const robots = await Promise.all(
        description.robots.map(async (robot) => ({ ...robot, text: await (await fetch(api.cellFile(robot.urdf))).text() })),
      );
      if (!current) return;
      scene.fill(description.bodies, robots);
      const follow = () => {
        const pose = cellPose.get();
        if (pose === undefined) return;
        scene.move(pose);
        const gone = absentParts(description.bodies, pose);
        setAbsent((before) => (before.join() === gone.join() ? before : gone));
      };
      follow();
      stop = cellPose.listen(follow);
    };
    load().catch((error: unknown) => current && setFailed(textOf(error)));
    return () => {
      current = false;
      stop();
      scene.dispose();
    };
  }, []);
  useEffect(() => {
    if (shown.current !== undefined) shown.current.grabbing.always = pulling;
  }, [pulling]);
  const act = (kind: "take" | "place", part: string) => {
    setMenu(undefined);
    setRefused(undefined);
    api.act({ act: kind, part }).catch((error: unknown) => setRefused(textOf(error)));
  };
  const openMenu = (event: React.MouseEvent) => {
    event.preventDefault();
    const found = shown.current?.grabbing.find(event.clientX, event.clientY);
    const box = event.currentTarget.getBoundingClientRect();
    setMenu(found?.part === true ? { part: found.body, x: event.clientX - box.left, y: event.clientY - box.top } : undefined);
  };
  return (
    <section className="cell" aria-label="Cell" onPointerDown={() => setMenu(undefined)}>
      <div className="cell-frame" ref={frame} onContextMenu={openMenu} />
      {failed !== undefined && <p className="cell-note">The cell cannot be shown: {failed}</p>}
      <div className="cell-tools">
        <button type="button" aria-pressed={pulling} title="Pull links and parts with mouse or finger (or hold Shift)" onClick={() => setPulling(!pulling)}>
          Pull
        </button>
        {pulling && <p className="cell-hint">Drag the arm or a part; it gives way as the task allows. Right click a part to take it away.</p>}
        {absent.map((part) => (
          <button key={part} type="button" onClick={() => act("place", part)}>
            Put back {part}
          </button>
        ))}
        {refused !== undefined && <p role="alert">{refused}</p>}
      </div>
      {menu !== undefined && (
        <div className="cell-menu" role="menu" style={{ left: menu.x, top: menu.y }} onPointerDown={(event) => event.stopPropagation()}>
          <button type="button" role="menuitem" onClick={() => act("take", menu.part)}>
            Take away {menu.part}
          </button>
        </div>
      )}
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
