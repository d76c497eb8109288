// What fields can offer: poses that were taught and labels that the camera knows, as far as this page can find out.
import { useEffect, useMemo } from "react";
import { controls, useControls } from "../../control/page";
import type { JsonValue } from "../../shared/json";
import { namedIn, type Named } from "../../shared/skills/named";
import { createStore, useSelected } from "../../page/store";
import { useTree } from "../editing";
import { useNamedElsewhere } from "../skills";

const kKey = "pose_";

const textsIn = (value: JsonValue | undefined): readonly string[] => (Array.isArray(value) ? value.filter((item) => typeof item === "string") : []);

const sorted = (texts: readonly string[]): readonly string[] => [...new Set(texts)].filter((text) => text !== "").sort((a, b) => a.localeCompare(b));

/** What this document names, and all others. */
function useNamed(what: keyof Named): readonly string[] {
  const tree = useTree();
  const others = useNamedElsewhere();
  return useMemo(() => [...(tree === undefined ? [] : namedIn(tree)[what]), ...others.flatMap((each) => each[what])], [tree, others, what]);
}

/** The joints [rad] of the poses that were taught, by their names, once this page has had the controls; they stay known when it gives them back. */
type Taught = ReadonlyMap<string, readonly number[]>;
const taught = createStore<Taught | undefined, Taught>(undefined, (_, next) => next);

/** More are not asked for. */
const kMost = 200;

function jointsIn(value: JsonValue): readonly number[] {
  const joints = typeof value === "object" && value !== null && "q" in value ? value["q"] : undefined;
  return Array.isArray(joints) ? joints.filter((joint: JsonValue) => typeof joint === "number") : [];
}

/** One after the other: few calls may wait. What cannot be had is asked for when the controls are taken again. */
async function loadTaught(): Promise<void> {
  const keys = textsIn(await controls.call("db", "list", { prefix: kKey })).slice(0, kMost);
  const found = new Map<string, readonly number[]>();
  for (const key of keys) found.set(key.slice(kKey.length), jointsIn(await controls.call("db", "get", { key })));
  taught.dispatch(found);
}

export interface Poses {
  readonly names: readonly string[];
  /** Nothing: not all that were taught are known. */
  readonly joints: Taught | undefined;
}

/** Poses that documents name and, for who has had the controls of the cell, those in the database. */
export function usePoses(): Poses {
  const named = useNamed("poses");
  const isHeld = useControls((state) => state.kind === "held");
  const joints = useSelected(taught, (now) => now);
  useEffect(() => {
    if (isHeld) loadTaught().catch(() => undefined);
  }, [isHeld]);
  return useMemo(() => ({ names: sorted([...named, ...(joints?.keys() ?? [])]), joints }), [named, joints]);
}

/** What the camera may know: the labels in all documents, as the service does not tell. */
export function useLabels(): readonly string[] {
  const named = useNamed("labels");
  return useMemo(() => sorted(named), [named]);
}
