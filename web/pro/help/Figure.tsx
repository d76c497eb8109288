// A figure of the help: the example, drawn as the canvas draws; it can be stored as a document of one's own.
import { createElement, useEffect, useId, useMemo, useState, type ReactElement } from "react";
import { drawingSvg, type SvgElement } from "../../shared/drawing/svg";
import { layoutModel } from "../../shared/drawing/layout";
import { freeDocumentName } from "../../shared/documents/names";
import { namesOf } from "../../shared/documents/listed";
import type { Drawing } from "../../shared/drawing/drawing";
import type { Example } from "../../shared/help/examples";
import { exampleState } from "../../shared/help/exampleState";
import { layoutInWorkers } from "../canvas/layoutEngine";
import { createFrom } from "../documents/actions";
import { useAttempt } from "../documents/useAttempt";
import { useSession } from "../client";

interface Props {
  readonly example: Example;
  readonly caption: string;
}

/** React's names of the attributes that it writes in another way. */
const kReactNames: Readonly<Record<string, string>> = { class: "className", "marker-end": "markerEnd" };

function rendered({ tag, attributes, children }: SvgElement, key?: number): ReactElement {
  const props = Object.fromEntries(Object.entries(attributes).map(([name, value]) => [kReactNames[name] ?? name, value]));
  return createElement(tag, { ...props, key }, ...children.map((child, i) => (typeof child === "string" ? child : rendered(child, i))));
}

function draw(example: Example, signal: AbortSignal): Promise<Drawing> {
  const state = exampleState(example);
  return layoutModel(layoutInWorkers(signal), { state, path: state.name, collapsed: new Set(), detail: "full", aspect: 2, signal });
}

export function Figure({ example, caption }: Props) {
  const [drawing, setDrawing] = useState<Drawing>();
  const prefix = useId().replaceAll(":", "");
  const documents = useSession((s) => s.documents);
  const { attempt, reason, busy } = useAttempt();
  const offline = useSession((s) => s.connection !== "open");
  useEffect(() => {
    const end = new AbortController();
    draw(example, end.signal).then(
      (next) => !end.signal.aborted && setDrawing(next),
      () => undefined,
    );
    return () => end.abort();
  }, [example]);
  const svg = useMemo(() => (drawing === undefined ? undefined : rendered(drawingSvg(drawing, { prefix, title: caption }))), [drawing, prefix, caption]);
  const name = freeDocumentName(example.name, namesOf(documents));
  return (
    <figure className="help-figure">
      <div className="help-drawing">{svg ?? <p className="quiet">Drawing…</p>}</div>
      <figcaption>
        {caption}
        <button type="button" className="link" disabled={offline || busy} onClick={() => void attempt(() => createFrom(name, example.document))}>
          Open as a document of your own
        </button>
      </figcaption>
      {reason !== undefined && (
        <p className="bad" role="alert">
          {reason}
        </p>
      )}
    </figure>
  );
}
