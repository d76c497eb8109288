// A state as a figure in the page, drawn as the canvas draws it.
import { useEffect, useId, useMemo, useState } from "react";
import { aspectFor } from "../../shared/drawing/aspect";
import type { Drawing } from "../../shared/drawing/drawing";
import { layoutModel } from "../../shared/drawing/layout";
import type { Detail } from "../../shared/drawing/measure";
import { drawingSvg } from "../../shared/drawing/svg";
import type { State } from "../../shared/model/model";
import { layoutInWorkers } from "./layoutEngine";
import { SvgFigure } from "./SvgFigure";

/** Of a figure: one of those that layouts are kept for. */
const kAspect = aspectFor({ width: 2, height: 1 });

/** What is drawn. */
export interface Pictured {
  readonly state: State;
  readonly collapsed: ReadonlySet<string>;
  readonly detail: Detail;
}

interface Props {
  /** Drawn anew when it is another object. */
  readonly of: Pictured;
  readonly title: string;
}

export function StateFigure({ of, title }: Props) {
  const [drawing, setDrawing] = useState<Drawing>();
  const prefix = useId().replaceAll(":", "");
  useEffect(() => {
    const end = new AbortController();
    const { signal } = end;
    layoutModel(layoutInWorkers(signal), { ...of, path: of.state.name, aspect: kAspect, signal }).then(
      (next) => !signal.aborted && setDrawing(next),
      () => undefined,
    );
    return () => end.abort();
  }, [of]);
  return useMemo(() => (drawing === undefined ? <p className="quiet">Drawing…</p> : <SvgFigure of={drawingSvg(drawing, { prefix, title })} />), [drawing, prefix, title]);
}
