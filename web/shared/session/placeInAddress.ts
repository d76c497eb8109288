// The place in the model in the address of the page: which state is entered, what is selected and asked about, and the panel below.
import type { ModelTree } from "../model/modelTree";
import type { Place } from "./address";
import { askedOf, askedText } from "../run/subject";
import { pageOf, selectionAt, type Drawer, type Gesture, type Page, type View } from "./view";

export type PlaceInModel = Pick<Place, "in" | "sel" | "why" | "top" | "below">;

const kDrawers: readonly Drawer[] = ["derivation", "timeline", "calls", "log", "manual", "closed"];

/** The page that the address asks for. */
export const pageOfPlace = ({ page, edit }: Place): Page => pageOf(page) ?? (edit === undefined ? "task" : "edit");

/** What the address has to say of the view. `first`: the panel with which the window begins; `top`: the state of the library that is edited. */
export function placeInModel({ page, focus, selection, asked, drawer }: Pick<View, "page" | "focus" | "selection" | "asked" | "drawer">, first: Drawer, top: string | undefined): PlaceInModel {
  return {
    in: focus,
    sel: selection?.kind === "port" ? selection.address : selection?.path,
    why: askedText(asked),
    top: page === "edit" ? top : undefined,
    below: drawer === first ? undefined : drawer,
  };
}

export const isSamePlace = (a: PlaceInModel, b: PlaceInModel): boolean => a.in === b.in && a.sel === b.sel && a.why === b.why && a.top === b.top && a.below === b.below;

/** What shows the place; of what the model does not have, nothing. */
export function toPlace(tree: ModelTree, { in: focus, sel, why, below }: PlaceInModel, first: Drawer): Extract<Gesture, { readonly type: "place" }> {
  const selection = sel === undefined ? undefined : selectionAt(tree, sel);
  return {
    type: "place",
    focus: focus !== undefined && tree.has(focus) ? focus : undefined,
    selection,
    asked: selection?.kind === "node" ? askedOf(why) : undefined,
    drawer: kDrawers.find((each) => each === below) ?? first,
  };
}

/** Whether a person went elsewhere, so that the browser's Back leads to where it was: another state was entered; a state that was edited is the same. */
export const isElsewhere = (tree: ModelTree | undefined, before: PlaceInModel, now: PlaceInModel): boolean =>
  now.top !== before.top || (now.in !== before.in && tree !== undefined && (before.in === undefined || tree.has(before.in)));
