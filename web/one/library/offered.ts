// The skills that are offered: those of all documents, each once, then the application's own.
import { useMemo } from "react";
import type { Tree } from "../../shared/edit/tree";
import { missingServices, serviceText, type ServiceHere } from "../../shared/skills/closure";
import type { SkillDocument } from "../../shared/skills/copy";
import { skillsIn, type Skill } from "../../shared/skills/skill";
import type { SkillPlace } from "../../shared/timeline/changes/add";
import { useSession } from "../client";
import { useEditing, useTree } from "../editing";
import { useSkillDocuments } from "../skills";
import { texts } from "../texts";

export interface Offered extends Skill {
  readonly place: SkillPlace;
  /** Why it cannot be used here, in words. */
  readonly missing: string | undefined;
}

function missingText(tree: Tree, id: string, here: readonly ServiceHere[]): string | undefined {
  const missing = missingServices(tree, id, here).map(serviceText);
  return missing.length === 0 ? undefined : texts.library.missing(missing.join(", "));
}

export function offeredSkills(own: string | undefined, tree: Tree | undefined, documents: readonly SkillDocument[], here: readonly ServiceHere[]): readonly Offered[] {
  const found = new Map<string, Offered>();
  const add = (of: Tree, document: string | undefined) => {
    for (const skill of skillsIn(of)) if (!found.has(skill.name)) found.set(skill.name, { ...skill, place: { document, id: skill.id }, missing: missingText(of, skill.id, here) });
  };
  for (const document of documents) if (document.name !== own) add(document.tree, document.name);
  if (tree !== undefined) add(tree, undefined);
  return [...found.values()];
}

export function useOffered(): readonly Offered[] {
  const documents = useSkillDocuments();
  const services = useSession((s) => s.services);
  const tree = useTree();
  const own = useEditing((now) => now.document);
  return useMemo(() => offeredSkills(own, tree, documents, services), [own, tree, documents, services]);
}
