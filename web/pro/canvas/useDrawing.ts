// The drawing of what the view shows, laid out anew when the model, the focus, what is collapsed or the detail changes.
import { useEffect, useMemo, useRef, useState } from "react";
import { aspectFor } from "../../shared/drawing/aspect";
import type { Drawing } from "../../shared/drawing/drawing";
import { readable } from "../../shared/drawing/fit";
import { layoutModel } from "../../shared/drawing/layout";
import { layoutCache } from "../../shared/drawing/layoutCache";
import { mayBeReadable } from "../../shared/drawing/moreDetail";
import { details, type Detail, type Size } from "../../shared/drawing/measure";
import type { Places } from "../../shared/drawing/places";
import type { State } from "../../shared/model/model";
import { stateAt, type ModelTree } from "../../shared/model/modelTree";
import type { Shown } from "../../shared/session/view";
import { problem, useView } from "../client";
import { useCellPlace } from "../layout/panels";
import { layoutInWorkers } from "./layoutEngine";

export interface Laid {
  readonly drawing: Drawing;
  /** The model that it was made of: paths and addresses of the drawing are of it, and after an edit not of the next one. */
  readonly tree: ModelTree;
  readonly detail: Detail;
  /** The part of the view that it shows. */
  readonly shows: Shown;
  /** The user chose the detail, so the first view must be readable. */
  readonly asked: boolean;
  /** A new key makes the canvas fit the drawing: it changes with the subject, the focus and the detail, not with an edit. */
  readonly key: string;
}

/** Progress of the next drawing: composites laid out, and their total. */
export interface Progress {
  readonly done: number;
  readonly of: number;
}

export interface CanvasDrawing {
  readonly laid: Laid | undefined;
  /** None: the drawing is up to date. */
  readonly progress: Progress | undefined;
  /** The latest drawing did not succeed. */
  readonly failed: boolean;
  /** Another drawing, or one with more detail, may follow. */
  readonly busy: boolean;
}

const memory = layoutCache();

/** The canvas' size when the focus was chosen: it decides the first arrangement, and later changes do not rearrange the drawing, unless the
 *  cell takes a half of the room, or gives it back. */
function useFrame(canvas: Size | undefined, focus: string | undefined): Size | undefined {
  const halved = useCellPlace() === "half";
  const [frame, setFrame] = useState<{ readonly focus: string | undefined; readonly halved: boolean; readonly size: Size }>();
  const isNew = frame === undefined || frame.focus !== focus || (frame.halved !== halved && frame.size.width !== canvas?.width);
  if (canvas !== undefined && isNew) setFrame({ focus, halved, size: canvas });
  return frame?.focus === focus ? frame?.size : undefined;
}

/** What is to be drawn. */
interface Request {
  readonly subject: string;
  readonly tree: ModelTree;
  readonly places: Places;
  readonly path: string;
  readonly state: State;
  readonly frame: Size;
  readonly shown: Shown;
}

/** What became of a request so far. */
interface Of<T> {
  readonly request: Request;
  readonly value: T;
}

function requestOf(subject: string, tree: ModelTree | undefined, places: Places, frame: Size | undefined, shown: Shown): Request | undefined {
  if (tree === undefined || frame === undefined) return undefined;
  // What the model does not have any more is not entered.
  const path = shown.focus !== undefined && tree.has(shown.focus) ? shown.focus : tree.keys().next().value;
  const state = path === undefined ? undefined : stateAt(tree, path);
  return path === undefined || state === undefined ? undefined : { subject, tree, places, path, state, frame, shown };
}

const valueFor = <T>(request: Request | undefined, latest: Of<T> | undefined): T | undefined => (latest?.request === request ? latest?.value : undefined);

function laidOf({ subject, tree, state, path, shown }: Request, detail: Detail, drawing: Drawing): Laid {
  const key = `${subject} ${state.id ?? path} ${shown.detail} ${detail} ${shown.collapsed.size}`;
  return { drawing, tree, detail, shows: shown, asked: shown.detail !== "auto", key };
}

/** What to draw after `before`: an edit leaves the detail as it was. */
function detailsFor({ subject, shown }: Request, before: Of<Laid> | undefined): readonly Detail[] {
  if (shown.detail !== "auto") return [shown.detail];
  const now = before?.request;
  const isEdit = now?.subject === subject && now.shown.focus === shown.focus && now.shown.collapsed === shown.collapsed && now.shown.detail === shown.detail;
  return isEdit && before !== undefined ? [before.value.detail] : details;
}

/** Draws with the first of these details and calls `take`; then with more, as long as it can be read. */
async function drawAll(request: Request, wanted: readonly Detail[], signal: AbortSignal, take: (laid: Laid) => void, onProgress: (progress: Progress) => void): Promise<void> {
  const { path, state, frame, shown, places, tree } = request;
  const engine = layoutInWorkers(signal);
  const common = { state, path, places, collapsed: shown.collapsed, aspect: aspectFor(frame), signal };
  const isStale = () => signal.aborted;
  const [first, ...more] = wanted;
  if (first === undefined) return;
  let drawing = await layoutModel(engine, { ...common, detail: first, onProgress: (done, of) => !isStale() && onProgress({ done, of }) }, memory);
  if (isStale()) return;
  take(laidOf(request, first, drawing));
  let now = first;
  for (const detail of more) {
    if (!mayBeReadable(drawing, tree, now, detail, frame)) return;
    drawing = await layoutModel(engine, { ...common, detail }, memory);
    if (isStale() || !readable(drawing, frame)) return;
    take(laidOf(request, detail, drawing));
    now = detail;
  }
}

/** `subject`: whose model it is; while it is the same, the drawing before an edit stays until the next one is there. */
export function useDrawing(subject: string, tree: ModelTree | undefined, places: Places, canvas: Size | undefined): CanvasDrawing {
  const focus = useView((view) => view.focus);
  const collapsed = useView((view) => view.collapsed);
  const detail = useView((view) => view.detail);
  const frame = useFrame(canvas, focus);
  const request = useMemo(() => requestOf(subject, tree, places, frame, { focus, collapsed, detail }), [subject, tree, places, frame, focus, collapsed, detail]);
  const [laid, setLaid] = useState<Of<Laid>>();
  const lastRef = useRef<Of<Laid>>(undefined);
  const [progress, setProgress] = useState<Of<Progress | undefined>>();
  const [end, setEnd] = useState<Of<"drawn" | "failed">>();

  useEffect(() => {
    if (request === undefined) return;
    // A drawing that is no longer wanted would delay the next one.
    const another = new AbortController();
    const { signal } = another;
    let latest: Of<Laid> | undefined;
    const take = (value: Laid) => {
      latest = { request, value };
      setLaid(latest);
      setProgress(undefined);
    };
    drawAll(request, detailsFor(request, lastRef.current), signal, take, (value) => setProgress({ request, value })).then(
      () => {
        if (signal.aborted) return;
        lastRef.current = latest;
        setEnd({ request, value: "drawn" });
      },
      (error: unknown) => {
        if (signal.aborted) return;
        setProgress(undefined);
        setEnd({ request, value: "failed" });
        problem(error);
      },
    );
    return () => another.abort();
  }, [request]);

  const ended = valueFor(request, end);
  return {
    laid: laid !== undefined && laid.request.subject === request?.subject ? laid.value : undefined,
    progress: valueFor(request, progress),
    failed: ended === "failed",
    busy: request !== undefined && ended === undefined,
  };
}
