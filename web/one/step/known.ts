// What fields can offer: poses that were taught and labels that the camera knows, as far as this page can find out.
import { useEffect, useMemo, useState } from "react";
import { controls, useControls } from "../../control/page";
import { elementOf, type Tree } from "../../shared/edit/tree";
import { entryOf, type JsonValue } from "../../shared/json";
import { declaredIn } from "../../shared/skills/declared";
import { parameterOf } from "../../shared/skills/skill";
import { api, useSession } from "../client";
import { useTree } from "../editing";
import { useSkillDocuments } from "../skills";

const kKey = "pose_";
const kLabels: ReadonlySet<string> = new Set(["label", "labels"]);

const textsIn = (value: JsonValue | undefined): readonly string[] => (typeof value === "string" ? [value] : Array.isArray(value) ? value.filter((item) => typeof item === "string") : []);

/** The texts that parameters of a domain have anywhere in a document. */
function valuesOf(tree: Tree, isWanted: (domain: string | undefined, name: string) => boolean): readonly string[] {
  return [...tree.elements.keys()].flatMap((id) => {
    if (elementOf(tree, id).kind !== "state") return [];
    return declaredIn(tree, id, "parameters").flatMap((declared) => (isWanted(parameterOf(declared).domain, declared.name) ? textsIn(entryOf(declared.fields, "value")) : []));
  });
}

function useValues(isWanted: (domain: string | undefined, name: string) => boolean): readonly string[] {
  const tree = useTree();
  const documents = useSkillDocuments();
  return useMemo(() => [tree, ...documents.map((document) => document.tree)].flatMap((each) => (each === undefined ? [] : valuesOf(each, isWanted))), [tree, documents, isWanted]);
}

const isPose = (domain: string | undefined): boolean => domain === "pose";
/** Models of before skills call them so. */
const isLabel = (domain: string | undefined, name: string): boolean => (domain !== undefined && kLabels.has(domain)) || name === "labels" || name === "label";

const sorted = (texts: readonly string[]): readonly string[] => [...new Set(texts)].filter((text) => text !== "").sort((a, b) => a.localeCompare(b));

/** Names of poses: those in documents and, for who has the controls of the cell, those in the database. `isWhole`: all that are taught. */
export function usePoses(): { readonly names: readonly string[]; readonly isWhole: boolean } {
  const named = useValues(isPose);
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

/** What the camera may know: labels in documents, and the movable parts of the cell. */
export function useLabels(): readonly string[] {
  const named = useValues(isLabel);
  const hasCell = useSession((s) => s.cell);
  const [parts, setParts] = useState<readonly string[]>([]);
  useEffect(() => {
    if (hasCell) api.cell().then(({ bodies }) => setParts(bodies.filter(({ fixed }) => !fixed).map(({ name }) => name)), () => undefined);
  }, [hasCell]);
  return useMemo(() => sorted([...named, ...parts]), [named, parts]);
}
