// The cell in 3D, moved by the poses of the server. The user pulls links and parts, removes parts and puts them back.
import { useEffect, useEffectEvent, useRef, useState } from "react";
import { absentParts, pulledLink } from "../../shared/cell/touch";
import { createHand } from "../../shared/cell/hand";
import { createLongPress, type LongPress } from "../../shared/cell/longPress";
import { Legend, showLegend, useLegend } from "../canvas/legend/Legend";
import { api, useView } from "../client";
import { useRefusal } from "../login/rights";
import { Leases } from "../panels/Leases";
import { listenToTheme } from "../theme/theme";
import { CellScene } from "../../cell/CellScene";
import { CellTool } from "./CellTool";
import { PartList } from "./PartList";
import { useResetAsked } from "./reset";
import { ResetButton, ResetCell } from "./ResetCell";
import { readPose, shownPose, usePastCell } from "./shownPose";
import { useCamera, useCloud } from "./useCloud";
import { useControl } from "./useControl";
import { useWorld } from "./useWorld";
import { messageOf } from "../../shared/messageOf";

interface Menu {
  readonly part: string;
  readonly x: number;
  readonly y: number;
}

/** Distance of the menu above the finger, which would cover it [px]. */
const kAboveFinger = 60;

function after(milliseconds: number, act: () => void): () => void {
  const timer = setTimeout(act, milliseconds);
  return () => clearTimeout(timer);
}


export function CellView() {
  const frame = useRef<HTMLDivElement>(null);
  const shown = useRef<CellScene>(undefined);
  const { world, problem } = useWorld();
  const [refused, setRefused] = useState<string>();
  const [pulling, setPulling] = useState(false);
  const [menu, setMenu] = useState<Menu>();
  const [listed, setListed] = useState(false);
  const [absent, setAbsent] = useState<readonly string[]>([]);
  const [clouded, setClouded] = useState(false);
  const [pulled, setPulled] = useState<string>();
  const isPast = usePastCell();
  const refusal = useRefusal("act_at_cell");
  const cannotAct = isPast || refusal !== undefined;
  const asksReset = useResetAsked() && !isPast;
  const legend = useLegend();
  const isPage = useView((v) => v.page === "cell");
  const control = useControl(isPast);
  const camera = useCamera();
  const points = useCloud(clouded && !isPast ? camera : undefined, (cloud) => shown.current?.showCloud(cloud));
  useEffect(() => {
    const host = frame.current;
    if (host === null) return;
    const hand = createHand({
      name: `page-${Math.random().toString(36).slice(2, 10)}`,
      send: (command) => (setRefused(undefined), api.command(command)),
      wait: (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds)),
      onRefused: (error) => setRefused(messageOf(error)),
    });
    const scene = new CellScene(host, hand);
    shown.current = scene;
    const ended = listenToTheme(() => scene.paint());
    return () => {
      ended();
      scene.dispose();
    };
  }, []);
  useEffect(() => {
    const scene = shown.current;
    if (scene === undefined) return;
    scene.fill(world?.bodies ?? [], world?.robots ?? []);
    setMenu(undefined);
    setRefused(undefined);
    setAbsent([]);
    setPulled(undefined);
    if (world === undefined) return;
    const follow = () => {
      const pose = shownPose.get()?.pose;
      if (pose === undefined) return;
      scene.move(pose);
      setPulled(pulledLink(world.bodies, pose));
      const gone = absentParts(world.bodies, pose);
      setAbsent((before) => (before.join() === gone.join() ? before : gone));
    };
    follow();
    return shownPose.listen(follow);
  }, [world]);
  useEffect(() => {
    if (shown.current !== undefined) Object.assign(shown.current.grabbing, { always: pulling, isPast: cannotAct });
  }, [pulling, cannotAct]);
  useEffect(() => shown.current?.showCollision(control.link, control.text), [world, control.link, control.text]);
  useEffect(() => shown.current?.explain(isPast ? undefined : pulled, control.holds), [isPast, pulled, control.holds]);
  const act = (kind: "take" | "place", part: string) => {
    setMenu(undefined);
    setRefused(undefined);
    api.command({ act: kind, part }).catch((error: unknown) => setRefused(messageOf(error)));
  };
  /** Opens the menu of the part at a position of the window [px], if there is one. */
  const openMenu = (x: number, y: number, above = 0) => {
    const found = shown.current?.grabbing.find(x, y);
    const box = frame.current?.getBoundingClientRect();
    if (found?.part !== true || box === undefined) {
      setMenu(undefined);
      return;
    }
    shown.current?.grabbing.letGo();
    setMenu({ part: found.body, x: x - box.left, y: Math.max(0, y - box.top - above) });
  };
  const long = useRef(false);
  const onLongPress = useEffectEvent((x: number, y: number) => {
    long.current = true;
    openMenu(x, y, kAboveFinger);
  });
  const fingers = useRef<LongPress>(undefined);
  useEffect(() => {
    fingers.current = createLongPress({ after, onPress: (x, y) => onLongPress(x, y) });
  }, []);
  const touch = ({ pointerId, pointerType, clientX, clientY }: React.PointerEvent, kind: "down" | "move") => {
    if (pointerType !== "mouse") fingers.current?.[kind]({ id: pointerId, x: clientX, y: clientY });
  };
  const press = (event: React.PointerEvent) => {
    long.current = false;
    touch(event, "down");
  };
  const lift = (event: React.PointerEvent) => fingers.current?.up(event.pointerId);
  return (
    <section className="cell" aria-label="Cell" onPointerDown={() => setMenu(undefined)}>
      <div
        className="cell-frame"
        ref={frame}
        onContextMenu={(event) => {
          event.preventDefault();
          openMenu(event.clientX, event.clientY);
        }}
        onPointerDownCapture={press}
        onPointerMoveCapture={(event) => touch(event, "move")}
        onPointerUpCapture={lift}
        onPointerCancelCapture={lift}
        // Lifting the finger that opened the menu does not select an entry.
        onTouchEnd={(event) => long.current && event.preventDefault()}
      />
      {problem !== undefined && <p className="cell-note">The cell cannot be shown: {problem}</p>}
      <div className="cell-over">
        <div className="cell-tools">
          <CellTool name="Pull" icon="hand" hint={refusal ?? "pull links and parts with mouse or finger (or hold Shift)"} disabled={cannotAct} aria-pressed={pulling} onClick={() => setPulling(!pulling)} />
          <CellTool name="Parts" icon="parts" hint={refusal ?? "all parts, to take away or put back"} disabled={cannotAct} aria-expanded={listed && !cannotAct} aria-controls="cell-parts" onClick={() => setListed(!listed)} />
          <ResetButton disabled={isPast} />
          <CellTool name="Home" icon="home" hint="the view as at first (key Home)" onClick={() => shown.current?.home()} />
          {isPage && <CellTool name="Legend" icon="legend" hint="what lines, dots and balls mean" aria-pressed={legend} onClick={() => showLegend(!legend)} />}
          {camera !== undefined && (
            <CellTool name="Cloud" icon="cloud" hint={`draw what the ${camera} measures, as points`} disabled={isPast} aria-pressed={clouded} onClick={() => setClouded(!clouded)} />
          )}
          {(listed || isPast ? [] : absent).map((part) => (
            <button key={part} type="button" disabled={refusal !== undefined} title={refusal} onClick={() => act("place", part)}>
              Put back {part}
            </button>
          ))}
          {pulling && !listed && <p className="cell-hint">Drag the arm or a part; it gives way as the task allows. Right click a part, or press it long, to take it away.</p>}
          {points !== undefined && <p className="cell-hint">{points} points that the {camera} measures now</p>}
          {refused !== undefined && <p role="alert">{refused}</p>}
        </div>
        {isPage && !isPast && <Leases />}
        {asksReset && <ResetCell />}
        {listed && !asksReset && !cannotAct && world !== undefined && <PartList parts={world.bodies.filter((body) => !body.fixed)} absent={absent} act={act} />}
      </div>
      {menu !== undefined && (
        <div className="cell-menu" role="menu" style={{ left: `min(${menu.x}px, 100% - 180px)`, top: `min(${menu.y}px, 100% - 50px)` }} onPointerDown={(event) => event.stopPropagation()}>
          <button type="button" role="menuitem" disabled={refusal !== undefined} title={refusal} onClick={() => act("take", menu.part)}>
            Take away {menu.part}
          </button>
        </div>
      )}
      <CellClock />
      {isPage && <Legend about="cell" />}
    </section>
  );
}

function CellClock() {
  const text = useRef<HTMLParagraphElement>(null);
  const isPast = usePastCell();
  useEffect(() => {
    const write = () => {
      const shown = readPose.get();
      const time = shown === undefined ? "" : `cell time ${shown.pose.time.toFixed(2)} s`;
      if (text.current !== null) text.current.textContent = shown?.step === undefined ? time : `as it was in step ${shown.step}, ${time}`;
    };
    write();
    return readPose.listen(write);
  }, []);
  return <p className={`cell-clock${isPast ? " is-past" : ""}`} ref={text} />;
}
