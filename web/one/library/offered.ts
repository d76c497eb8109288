// The skills that are offered: those of all documents, each once, then the application's own; and the services for which nobody has written any.
import { useMemo } from "react";
import type { Tree } from "../../shared/edit/tree";
import { missingServices, serviceText, type ServiceHere } from "../../shared/skills/closure";
import type { SkillDocument } from "../../shared/skills/copy";
import { keepServices, madeOf, searchOperations, servicesWithoutSkills, skillsOfService } from "../../shared/skills/serviceSkills";
import { skillsIn, type Skill } from "../../shared/skills/skill";
import type { SkillPlace } from "../../shared/timeline/changes/add";
import { useSession } from "../client";
import { useEditing, useTree } from "../editing";
import { useAreSkillsLoaded, useSkillDocuments } from "../skills";
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

/** What was made of an operation is offered by its service, as that is now. */
export function offeredSkills(own: string | undefined, tree: Tree | undefined, documents: readonly SkillDocument[], here: readonly ServiceHere[]): readonly Offered[] {
  const found = new Map<string, Offered>();
  const keys = new Set(here.map(({ key }) => key));
  const add = (of: Tree, document: string | undefined) => {
    for (const skill of skillsIn(of)) {
      if (found.has(skill.name) || keys.has(madeOf(of, skill.id) ?? "")) continue;
      found.set(skill.name, { ...skill, place: { document, id: skill.id }, missing: missingText(of, skill.id, here) });
    }
  };
  for (const document of documents) if (document.name !== own) add(document.tree, document.name);
  if (tree !== undefined) add(tree, undefined);
  return [...found.values()];
}

const servicesNow = keepServices();
export type OfferedService = ReturnType<typeof servicesNow>[number];
const useServices = (): readonly OfferedService[] => useSession(({ services }) => servicesNow(services));

export function useOffered(): readonly Offered[] {
  const documents = useSkillDocuments();
  const services = useServices();
  const tree = useTree();
  const own = useEditing((now) => now.document);
  return useMemo(() => offeredSkills(own, tree, documents, services), [own, tree, documents, services]);
}

const kNoServices: readonly OfferedService[] = [];

/** The services of which the operations are offered; none before it is known which skills there are. */
export function useServicesWithoutSkills(): readonly OfferedService[] {
  const documents = useSkillDocuments();
  const areLoaded = useAreSkillsLoaded();
  const services = useServices();
  const tree = useTree();
  return useMemo(() => {
    const trees = [...documents.map((document) => document.tree), ...(tree === undefined ? [] : [tree])];
    return areLoaded ? servicesWithoutSkills(services, trees) : kNoServices;
  }, [documents, areLoaded, services, tree]);
}

/** The operations of a service as skills: those that a search finds. */
export function operationSkills(service: OfferedService, query: string): readonly Offered[] {
  const made = skillsOfService(service);
  if (made === undefined) return [];
  const missing = service.available ? undefined : texts.library.missing(serviceText(service.key));
  return searchOperations(service, query).flatMap(({ name }): readonly Offered[] => {
    const skill = made.skills.get(name);
    return skill === undefined ? [] : [{ ...skill, place: { document: made.document.name, id: skill.id }, missing }];
  });
}
