// The visible part of the drawing: fits a new drawing and, unless the user has moved it, a resized canvas and a drawing that has grown out
// of it; moves to the target of a jump; tells styles when it is zoomed out.
import { useEffect, useEffectEvent, useRef, type RefObject } from "react";
import { fit, fitReadable, shows } from "../../shared/drawing/fit";
import { hitIndex } from "../../shared/drawing/hit";
import { kFar } from "../../shared/drawing/levels";
import type { Size } from "../../shared/drawing/measure";
import { fitBox } from "../../shared/drawing/movement";
import { pathOf } from "../../shared/session/view";
import { useView } from "../client";
import { shownCanvas, useShownCanvas } from "./canvasView";
import { isPreview } from "./placingPreview";
import type { Laid } from "./useDrawing";

interface Props {
  readonly laid: Laid;
  readonly size: Size;
  /** The user has moved or zoomed the drawing, so it is not fitted again. */
  readonly movedRef: RefObject<boolean>;
}

export function Viewport({ laid, size, movedRef }: Props) {
  const element = useShownCanvas()?.element;
  const canvas = useShownCanvas();
  const reveal = useView((v) => v.reveal);
  const selection = useView((v) => v.selection);
  const seenRef = useRef(reveal);

  /** Where it goes then is decided by Following.tsx. */
  const follows = useView((v) => v.follow && v.page === "task");

  const show = useEffectEvent((duration: number) => {
    if (follows) return;
    const view = laid.asked ? fitReadable : fit;
    shownCanvas()?.show(view(laid.drawing, size), duration);
  });

  useEffect(() => {
    if (element === undefined) return;
    movedRef.current = false;
    show(250);
  }, [laid.key, element, movedRef]);

  useEffect(() => {
    if (!movedRef.current) show(0);
  }, [size, movedRef]);

  const { drawing } = laid;
  const isDragged = isPreview(laid);
  const followGrowth = useEffectEvent(() => {
    const now = shownCanvas()?.target();
    if (now !== undefined && !shows(now, drawing, size)) show(250);
  });
  useEffect(() => {
    if (!movedRef.current && !isDragged) followGrowth();
  }, [drawing, isDragged, movedRef]);

  useEffect(() => {
    if (reveal === seenRef.current || selection === undefined) return;
    const node = hitIndex(laid.drawing).node(pathOf(selection));
    if (node === undefined) return;
    seenRef.current = reveal;
    movedRef.current = true;
    shownCanvas()?.show(fitBox(node, size), 350);
  }, [reveal, selection, laid, size, movedRef]);

  useEffect(() => {
    if (canvas === undefined) return;
    const section = canvas.element.closest<HTMLElement>(".canvas");
    const mark = () => {
      const distance = canvas.viewport().zoom < kFar ? "far" : "near";
      if (section !== null && section.dataset["zoom"] !== distance) section.dataset["zoom"] = distance;
    };
    mark();
    return canvas.listen(mark);
  }, [canvas]);
  return null;
}
