// What fields can offer: poses that were taught and labels that the camera knows, as far as this page can find out.
import { useEffect, useMemo, useState } from "react";
import { controls, useControls } from "../../control/page";
import type { JsonValue } from "../../shared/json";
import { namedIn, type Named } from "../../shared/skills/named";
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

/** Names of poses: those in documents and, for who has the controls of the cell, those in the database. `isWhole`: all that are taught. */
export function usePoses(): { readonly names: readonly string[]; readonly isWhole: boolean } {
  const named = useNamed("poses");
  const isHeld = useControls((state) => state.kind === "held");
  const [taught, setTaught] = useState<readonly string[]>();
  useEffect(() => {
    if (!isHeld) return;
    let isWanted = true;
    controls.call("db", "list", { prefix: kKey }).then(
      (keys) => isWanted && setTaught(textsIn(keys).map((key) => key.slice(kKey.length))),
      () => undefined,
    );
    return () => {
      isWanted = false;
    };
  }, [isHeld]);
  return useMemo(() => ({ names: sorted([...named, ...(taught ?? [])]), isWhole: taught !== undefined }), [named, taught]);
}

/** The joints of a taught pose [rad]. Throws what is in the way; only who has the controls is answered. */
export async function jointsOf(name: string): Promise<readonly number[]> {
  const value = await controls.call("db", "get", { key: `${kKey}${name}` });
  const joints = typeof value === "object" && value !== null && "q" in value ? value["q"] : undefined;
  if (!Array.isArray(joints)) throw new Error("its joints are not known");
  return joints.filter((joint: JsonValue) => typeof joint === "number");
}

/** What the camera may know: the labels in all documents, as the service does not tell. */
export function useLabels(): readonly string[] {
  const named = useNamed("labels");
  return useMemo(() => sorted(named), [named]);
}
