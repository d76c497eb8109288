// The context menu of the drawing and the tree of a run, and that of the tree of a document: by right click, or by the key of menus.
import { useEffect, useEffectEvent } from "react";
import { selectionsOf } from "../../shared/model/identity";
import { selectionAt, type Page, type Selection } from "../../shared/session/view";
import { shownCanvas } from "../canvas/canvasView";
import { useView, view } from "../client";
import { actionOf } from "../edit/actions/registry";
import { runAction } from "../edit/actions/action";
import { ask, isPrompting, type ScreenPoint } from "../edit/prompt";
import { Prompts } from "../edit/prompts/Prompts";
import { commandOf, menuEntryOf } from "./actions";
import { placeOnScreen, shownTree } from "./target";

const kInMenu = ["breakpoint", "breakpoint_kind", "until_here", "step_into", "step_over", "step_out", "force_port"];

/** Where it opens. The drawing of a document has a menu of its own. */
const kWhere: Readonly<Partial<Record<Page, string>>> = { task: '.canvas, [role="tree"]', edit: '[role="tree"]' };

/** What of the model is at a place of the page: what the element there stands for, else what is drawn at the point. */
function selectionUnder(target: Element, at: ScreenPoint): Selection | undefined {
  const tree = shownTree();
  const element = target.closest<HTMLElement>("[data-address], [data-path]");
  const address = element?.dataset["address"] ?? element?.dataset["path"];
  if (tree === undefined) return undefined;
  if (address !== undefined) return selectionAt(tree, address);
  const hit = shownCanvas()?.nodeAt(at);
  if (hit === undefined) return undefined;
  return (hit.id === undefined ? undefined : selectionsOf(tree).get(hit.id)) ?? selectionAt(tree, hit.port ?? hit.path);
}

function openMenu(at: ScreenPoint): void {
  ask({ kind: "menu", label: "Debug", at, entries: kInMenu.map((id) => menuEntryOf(commandOf(id))) });
}

export function DebugMenu() {
  const page = useView((v) => v.page);
  const open = useEffectEvent((event: MouseEvent) => {
    const target = event.target instanceof Element ? event.target : null;
    const where = kWhere[page];
    if (target === null || where === undefined || target.closest(where) === null || isPrompting()) return;
    event.preventDefault();
    const at = { x: event.clientX, y: event.clientY };
    const selection = selectionUnder(target, at);
    if (selection !== undefined) view.dispatch({ type: "select", selection });
    if (page === "edit") runAction(actionOf("menu"));
    // By key there is no place of the pointer.
    else openMenu(event.button === 2 ? at : placeOnScreen());
  });
  useEffect(() => {
    const listen = (event: MouseEvent) => open(event);
    addEventListener("contextmenu", listen);
    return () => removeEventListener("contextmenu", listen);
  }, []);
  return page === "task" ? <Prompts /> : null;
}
