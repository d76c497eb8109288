// The drawing that is shown, as an SVG file in the colours of the theme.
import { drawingSvg, svgText } from "../../shared/drawing/svg";
import { saveText } from "../saveText";
import { tokenColour } from "../theme/tokenColour";
import type { Laid } from "./useDrawing";

/** The rules of styles/drawingSvg.css, as the page has them, without its tokens. */
function rules(): string {
  const all = [...document.styleSheets].flatMap((sheet) => [...sheet.cssRules]);
  const own = all.filter((rule) => rule instanceof CSSStyleRule && rule.selectorText.includes(".drawing-svg"));
  return own.map((rule) => rule.cssText.replaceAll(/var\((--[\w-]+)\)/g, (_, token: `--${string}`) => tokenColour(token))).join("\n");
}

export function saveDrawing({ drawing, tree }: Laid): void {
  const [root = "drawing"] = tree.keys();
  const svg = drawingSvg(drawing, { prefix: "arrow", title: root, style: rules() });
  saveText(`${root}.svg`, "image/svg+xml", svgText(svg));
}
