// Follows the run in its drawing while that is wanted: opens what became active, and moves there. Panning or zooming ends it (moved.ts).
import { useEffect, useEffectEvent, useRef } from "react";
import { becameActive, followView } from "../../shared/drawing/follow";
import { hitIndex } from "../../shared/drawing/hit";
import type { Size } from "../../shared/drawing/measure";
import { useView, view } from "../client";
import { shownCanvas, useShownCanvas } from "./canvasView";
import type { Laid } from "./useDrawing";
import { listenToLive, liveNow } from "./useLive";

/** It moves at most so often, as one can follow it [ms]. */
const kPause = 500;

interface Props {
  readonly laid: Laid;
  readonly size: Size;
}

export function Following({ laid, size }: Props) {
  const isOn = useView((v) => v.follow && v.page === "task");
  const element = useShownCanvas()?.element;
  const seenRef = useRef<ReadonlySet<string>>(new Set());
  const targetsRef = useRef<readonly string[]>([]);

  const aim = useEffectEvent(() => {
    const canvas = shownCanvas();
    const paths = targetsRef.current.filter((path) => laid.tree.has(path));
    if (canvas === undefined) return;
    const index = hitIndex(laid.drawing);
    const boxes = paths.map((path) => index.node(path)).filter((node) => node !== undefined);
    if (boxes.length < paths.length) view.dispatch({ type: "show_active", paths });
    const next = followView(boxes, canvas.target(), laid.drawing, size);
    if (next !== undefined) canvas.show(next, 300);
  });

  useEffect(() => {
    if (!isOn) return;
    let waiting: ReturnType<typeof setTimeout> | undefined;
    const take = () => {
      waiting = undefined;
      const { active } = liveNow();
      const next = becameActive(seenRef.current, active);
      seenRef.current = active;
      if (next.length === 0) return;
      targetsRef.current = next;
      aim();
    };
    seenRef.current = new Set();
    take();
    const end = listenToLive(() => {
      waiting ??= setTimeout(take, kPause);
    });
    return () => {
      clearTimeout(waiting);
      end();
    };
  }, [isOn]);

  useEffect(() => {
    if (isOn) aim();
  }, [isOn, laid, size, element]);
  return null;
}
