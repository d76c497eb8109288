// A tree of SVG elements in the page.
import { createElement, type ReactElement } from "react";
import type { SvgElement } from "../../shared/drawing/svg";

/** React's names of the attributes that it writes in another way. */
const kReactNames: Readonly<Record<string, string>> = { class: "className", "marker-end": "markerEnd" };

function rendered({ tag, attributes, children }: SvgElement, key?: number): ReactElement {
  const props = Object.fromEntries(Object.entries(attributes).map(([name, value]) => [kReactNames[name] ?? name, value]));
  return createElement(tag, { ...props, key }, ...children.map((child, i) => (typeof child === "string" ? child : rendered(child, i))));
}

export const SvgFigure = ({ of }: { readonly of: SvgElement }): ReactElement => rendered(of);
