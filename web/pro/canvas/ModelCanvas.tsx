// The canvas: the laid out model with zoom, pan, breadcrumb and the state of the run.
import { ReactFlowProvider } from "@xyflow/react";
import { useEffect, useRef, type ReactNode } from "react";
import { kNoPlaces, type Places } from "../../shared/drawing/places";
import type { ModelTree } from "../../shared/model/modelTree";
import { BreakpointMarks } from "../debugger/BreakpointMarks";
import { Breadcrumb } from "./Breadcrumb";
import { CanvasTools } from "./CanvasTools";
import { noteDrawing } from "./firstDrawing";
import { Flow } from "./Flow";
import { Following } from "./Following";
import { LayoutProgress } from "./LayoutProgress";
import { Legend } from "./legend/Legend";
import { PaintedCanvas } from "./painted/PaintedCanvas";
import { usePreviewed } from "./placingPreview";
import { ReadHint } from "./ReadHint";
import { useDrawing } from "./useDrawing";
import { useSize } from "./useSize";
import { Viewport } from "./Viewport";
import { ZoomControls } from "./ZoomControls";

/** A drawing with more nodes is painted: with an element for each, the browser could not move it smoothly. */
const kPainted = 100;

interface Props {
  /** Whose model it is: a run or a document. */
  readonly subject: string;
  readonly tree: ModelTree | undefined;
  /** Where people have placed its states. */
  readonly places?: Places;
  /** What is said where there is no model. */
  readonly nothing: ReactNode;
  /** Further tools, in the row of the others. */
  readonly children?: ReactNode;
}

export function ModelCanvas({ subject, tree, places = kNoPlaces, nothing, children }: Props) {
  const frame = useRef<HTMLDivElement>(null);
  const movedRef = useRef(false);
  const size = useSize(frame);
  const { laid: latest, progress, failed, busy } = useDrawing(subject, tree, places, size);
  const laid = usePreviewed(latest);
  const complete = laid !== undefined && !busy;
  useEffect(() => {
    if (complete) noteDrawing();
  }, [complete]);
  return (
    <section className="canvas" aria-label="Model" aria-busy={busy} ref={frame}>
      {laid !== undefined && tree !== undefined && size !== undefined ? (
        <>
          <div className="canvas-bar">
            <Breadcrumb tree={tree} />
            <CanvasTools tree={tree} detail={laid.detail}>
              {children}
            </CanvasTools>
          </div>
          {laid.drawing.nodes.length > kPainted ? (
            <PaintedCanvas laid={laid} size={size} movedRef={movedRef} />
          ) : (
            <ReactFlowProvider>
              <Flow laid={laid} movedRef={movedRef} />
            </ReactFlowProvider>
          )}
          <ZoomControls laid={laid} size={size} movedRef={movedRef} />
          <ReadHint laid={laid} size={size} movedRef={movedRef} />
          <Viewport laid={laid} size={size} movedRef={movedRef} />
          <Following laid={laid} size={size} />
          <BreakpointMarks />
          <Legend about="drawing" />
          {progress !== undefined && <LayoutProgress progress={progress} laid={laid} />}
        </>
      ) : (
        <Empty>{tree === undefined ? nothing : failed ? "The model could not be drawn." : "Drawing the model…"}</Empty>
      )}
    </section>
  );
}

function Empty({ children }: { readonly children: ReactNode }) {
  return <div className="canvas-empty">{typeof children === "string" ? <p>{children}</p> : children}</div>;
}
