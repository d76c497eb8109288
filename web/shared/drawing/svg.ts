// A drawing as a tree of SVG elements: for figures in a page, whose style sheet knows the classes (pro/styles/drawingSvg.css), and for files, which bring that.
import type { DrawnLine, DrawnNode, DrawnPort, Drawing } from "./drawing";
import { nameWidth } from "./measure";
import { roundedPath } from "./path";
import { stubs } from "./stubs";

export interface SvgElement {
  readonly tag: "svg" | "g" | "rect" | "path" | "text" | "title" | "circle" | "line" | "defs" | "marker" | "style";
  readonly attributes: Readonly<Record<string, string | number>>;
  readonly children: readonly (SvgElement | string)[];
}

const element = (tag: SvgElement["tag"], attributes: SvgElement["attributes"], ...children: readonly (SvgElement | string)[]): SvgElement => ({ tag, attributes, children });
/** For what others add to a drawing. */
export { element as svgElement };

const kHead = 30;
/** Size of the name of a state, as in the style sheet. */
const kName = 13;
const kRow = 16;
const kValueAt = 57;

/** A port of a dispatcher is too small for its name, as on the canvas. */
function portOf({ x, y, width, height, name, condition, timed, exits }: DrawnPort, isOfDispatcher: boolean): SvgElement {
  if (isOfDispatcher) return element("g", { class: "svg-port" }, element("rect", { x, y, width, height, rx: Math.min(width, height) / 2 }, element("title", {}, name)));
  const lines = condition === "" ? [y + height / 2 + 4] : [y + height / 2 - 2, y + height / 2 + 10];
  return element(
    "g",
    { class: exits ? "svg-port is-exit" : "svg-port" },
    element("rect", { x, y, width, height }),
    element("text", { x: x + 7, y: lines[0] ?? y }, timed ? `◷ ${name}` : name),
    ...(condition === "" ? [] : [element("text", { class: "svg-code", x: x + 7, y: lines[1] ?? y }, condition)]),
  );
}

/** The signs of dispatchers: those of UML for histories. */
const kSigns = { history: "H", "deep history": "H*", choice: "?" } as const;

function nodeOf(node: DrawnNode): SvgElement {
  const { x, y, width, height, kind, name, lines, ports, open, dispatcher, badge } = node;
  if (kind === "barrier") return element("rect", { class: "svg-barrier", x, y, width, height, rx: 2 }, element("title", {}, name));
  const sign = dispatcher === undefined ? undefined : kSigns[dispatcher];
  const box = element("rect", { x, y, width, height, rx: sign === undefined ? 12 : height / 2 });
  const head = sign === undefined ? element("text", { class: "svg-name", x: x + 11, y: y + 20 }, name) : element("text", { class: "svg-name", x: x + width / 2 - 5, y: y + height / 2 + 4 }, sign);
  const texts = lines.flatMap((line, i) => {
    const at = y + kHead + 16 + i * kRow;
    const isSame = lines[i - 1]?.label === line.label;
    return [...(isSame ? [] : [element("text", { class: "svg-label", x: x + 11, y: at }, line.label)]), element("text", { class: "svg-code", x: x + kValueAt, y: at }, line.text)];
  });
  const rule = lines.length === 0 ? [] : [element("line", { x1: x + 1, y1: y + kHead, x2: x + width - 1, y2: y + kHead })];
  const beside = badge === undefined || sign !== undefined ? [] : [element("text", { class: "svg-badge", x: x + 19 + nameWidth(name, kName), y: y + 20 }, badge)];
  return element("g", { class: `svg-state${open ? " is-open" : ""}${sign === undefined ? "" : " is-dispatcher"}` }, box, ...rule, head, ...beside, ...texts, ...ports.map((port) => portOf(port, sign !== undefined)));
}

function lineOf(line: DrawnLine, prefix: string): SvgElement {
  const start = line.points[0];
  const isOpen = line.kind === "exit" || line.kind === "nowhere";
  return element(
    "g",
    { class: `svg-line is-${line.kind}` },
    element("path", { d: roundedPath(line.points, 7), fill: "none", "marker-end": `url(#${prefix}-${isOpen ? "open" : "plain"})` }),
    ...(line.kind === "first" && start !== undefined ? [element("circle", { cx: start.x, cy: start.y, r: 4 })] : []),
  );
}

const marker = (id: string, shape: SvgElement): SvgElement =>
  element("marker", { id, viewBox: "0 0 10 10", refX: 9, refY: 5, markerWidth: 9, markerHeight: 9, markerUnits: "userSpaceOnUse", orient: "auto" }, shape);

/** Room around the drawing for what stands on its border [px]. */
const kMargin = 12;

/** `prefix`: of ids, which are those of the whole page; `style`: a style sheet that the file brings. */
export function drawingSvg(drawing: Drawing, { prefix, title, style }: { readonly prefix: string; readonly title: string; readonly style?: string }): SvgElement {
  const [width, height] = [drawing.width + 2 * kMargin, drawing.height + 2 * kMargin];
  const open = drawing.nodes.filter((node) => node.open);
  const others = drawing.nodes.filter((node) => !node.open);
  return element(
    "svg",
    { xmlns: "http://www.w3.org/2000/svg", class: "drawing-svg", viewBox: `${-kMargin} ${-kMargin} ${width} ${height}`, width, height, role: "img", "aria-label": title },
    element("title", {}, title),
    ...(style === undefined ? [] : [element("style", {}, style)]),
    element(
      "defs",
      {},
      marker(`${prefix}-plain`, element("path", { class: "svg-arrow", d: "M 0 0.5 L 10 5 L 0 9.5 z" })),
      marker(`${prefix}-open`, element("path", { class: "svg-arrow-open", d: "M 1 1 L 9 5 L 1 9", fill: "none" })),
    ),
    // An open state is the ground of what is in it.
    ...open.map(nodeOf),
    ...[...drawing.lines, ...stubs(drawing)].map((line) => lineOf(line, prefix)),
    ...others.map(nodeOf),
  );
}

/** Characters that no XML can have, in no writing. */
// eslint-disable-next-line no-control-regex
const kForbidden = /[\u0000-\u0008\u000b\u000c\u000e-\u001f\ufffe\uffff]|\p{Surrogate}/gu;

const escaped = (text: string): string => text.replaceAll(kForbidden, "\ufffd").replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll(">", "&gt;").replaceAll('"', "&quot;");

/** As the text of a file. */
export function svgText({ tag, attributes, children }: SvgElement): string {
  const written = Object.entries(attributes).map(([name, value]) => ` ${name}="${escaped(String(value))}"`);
  const inner = children.map((child) => (typeof child === "string" ? escaped(child) : svgText(child)));
  return `<${tag}${written.join("")}>${inner.join("")}</${tag}>`;
}
