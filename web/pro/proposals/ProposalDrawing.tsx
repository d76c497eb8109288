// What a proposal would change, in the drawing of its document.
import { useEffect, useId, useMemo, useState } from "react";
import { aspectFor } from "../../shared/drawing/aspect";
import { layoutModel } from "../../shared/drawing/layout";
import { figuresOf, figureSvg, type Figure, type Figures } from "../../shared/proposals/figure";
import type { Outline } from "../../shared/proposals/outline";
import type { DrawnModel } from "../../shared/versions/ghosts";
import { layoutInWorkers } from "../canvas/layoutEngine";
import { SvgFigure } from "../canvas/SvgFigure";

/** Of a figure that is as wide as the panel. */
const kAspect = aspectFor({ width: 2, height: 1 });

async function laidOut({ tree, state, collapsed, places }: Figure, signal: AbortSignal): Promise<DrawnModel> {
  return { tree, drawing: await layoutModel(layoutInWorkers(signal), { state, path: state.name, collapsed, places, detail: "ports", aspect: kAspect, signal }) };
}

interface Drawn {
  readonly of: Figures;
  /** Nothing: it could not be drawn. The list says what would change. */
  readonly models: { readonly now: DrawnModel; readonly was: DrawnModel | undefined } | undefined;
}

function useDrawn(figures: Figures | undefined): Drawn | undefined {
  const [drawn, setDrawn] = useState<Drawn>();
  useEffect(() => {
    if (figures === undefined) return;
    const end = new AbortController();
    const { signal } = end;
    const take = (models: Drawn["models"]) => !signal.aborted && setDrawn({ of: figures, models });
    Promise.all([laidOut(figures.now, signal), figures.was && laidOut(figures.was, signal)]).then(([now, was]) => take({ now, was }), () => take(undefined));
    return () => end.abort();
  }, [figures]);
  return drawn?.of === figures ? drawn : undefined;
}

interface Props {
  readonly outline: Outline;
  readonly title: string;
}

export function ProposalDrawing({ outline, title }: Props) {
  const prefix = useId().replaceAll(":", "");
  const figures = useMemo(() => figuresOf(outline), [outline]);
  const drawn = useDrawn(figures);
  const svg = useMemo(() => drawn?.models && figureSvg(outline, drawn.models, { prefix, title }), [outline, drawn, prefix, title]);
  if (figures === undefined || (drawn !== undefined && svg === undefined)) return null;
  return <figure className="proposal-drawing">{svg === undefined ? <p className="quiet">Drawing…</p> : <SvgFigure of={svg} />}</figure>;
}
