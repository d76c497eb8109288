// The operations of a service as skills, for services that nobody has written skills for.
import type { HostedService, RsmOperation } from "../../generated/messages";
import type { KnownService } from "../code/services";
import type { ExactObject } from "../edit/clipboard/json";
import { withNewIds } from "../edit/clipboard/paste";
import { plain, type ExactJson } from "../edit/exact";
import { Refusal } from "../edit/refusal";
import { readTree, type Tree } from "../edit/tree";
import { entryOf, type JsonValue } from "../json";
import { declaredServices, servicesOf, type ServiceHere } from "./closure";
import type { SkillDocument } from "./copy";
import { metaOf, textOf } from "./declared";
import { offeredOperations, operationState } from "./operationState";
import { isSkill, skillsIn, wordsOf, type Skill } from "./skill";

/** The operation of which a library state was made, KEY.OPERATION; nothing: somebody has written it. */
const operationOf = (tree: Tree, id: string): string | undefined => textOf(entryOf(metaOf(tree, id), "operation"));

/** The key of the service of which operation a library state was made. */
export const madeOf = (tree: Tree, id: string): string | undefined => operationOf(tree, id)?.split(".")[0];

const kMostTitle = 40;

/** `Move (my_gripper)`, at most 40 characters. */
function titleOf(key: string, operation: string): string {
  const title = `${wordsOf(operation)} (${key})`;
  return title.length > kMostTitle ? `${title.slice(0, kMostTitle - 1)}…` : title;
}

/** What a service offers, as a document of skills that is stored nowhere. */
interface ServiceSkills {
  readonly document: SkillDocument;
  /** By the name of the operation. */
  readonly skills: ReadonlyMap<string, Skill>;
}

/** Ids of states say of which operation they are, so that a press means the same one when the service has got another RSM. Names of operations have no `-`. */
const kMostId = 60;
const idOf = (operation: string, index: number): string => (operation.length > kMostId ? `${operation.slice(0, kMostId - 8)}-${index}` : operation);

/** `wish`, or with the first number from 2 on that makes it free. */
function freeAmong(taken: ReadonlySet<string>, wish: string): string {
  let name = wish;
  for (let i = 2; taken.has(name); ++i) name = `${wish}${i}`;
  return name;
}

function libraryOf(service: KnownService): readonly ExactObject[] {
  const names = new Set<string>();
  let count = 0;
  const newId = (): string => `-${++count}`;
  return offeredOperations(service).map((operation, i) => {
    const state = operationState(service, operation);
    const name = freeAmong(names, typeof state["state"] === "string" ? state["state"] : "");
    names.add(name);
    const about = { skill: true, operation: `${service.key}.${operation.name}`, title: titleOf(service.key, operation.name) };
    return { ...withNewIds({ ...state, state: name }, newId, new Map()), meta: { ...about, id: idOf(operation.name, i) } };
  });
}

function made(service: KnownService): ServiceSkills | undefined {
  // No stored document has a point in its name.
  const name = `svc.${service.key}`;
  const exact: ExactJson = { rcm: 1, name, services: { [service.key]: service.type }, library: libraryOf(service), root: { state: "Root", meta: { id: "-root" } } };
  const tree = readTree(plain<JsonValue>(exact));
  if (tree instanceof Refusal) return undefined;
  const skills = new Map(skillsIn(tree).map((skill) => [operationOf(tree, skill.id)?.slice(service.key.length + 1) ?? "", skill]));
  return { document: { name, tree, exact }, skills };
}

const known = new WeakMap<object, { readonly key: string; readonly skills: ServiceSkills | undefined }>();

/** Made once for each RSM. Nothing: the operations are none that a document can have. */
export function skillsOfService(service: KnownService): ServiceSkills | undefined {
  const before = known.get(service.rsm);
  if (before?.key === service.key) return before.skills;
  const skills = made(service);
  known.set(service.rsm, { key: service.key, skills });
  return skills;
}

/** The documents of skillsOfService() that were made of what these services offer now. */
export const madeDocuments = (services: readonly KnownService[]): readonly SkillDocument[] =>
  services.flatMap(({ key, rsm }) => {
    const before = known.get(rsm);
    return before?.key === key && before.skills !== undefined ? [before.skills.document] : [];
  });

/** The offered operations with all words of the query in their name, description or service. */
export function searchOperations(service: KnownService, query: string): readonly RsmOperation[] {
  const words = query.toLowerCase().split(/\s+/).filter((word) => word !== "");
  return offeredOperations(service).filter(({ name, doc = "" }) => {
    const text = `${wordsOf(name)} ${name} ${doc} ${service.key}`.toLowerCase();
    return words.every((word) => text.includes(word));
  });
}

interface Need {
  readonly key: string;
  readonly type: string | undefined;
}
const needs = new WeakMap<Tree, readonly Need[]>();

/** The services of the skills of a document that somebody has written. */
function neededIn(tree: Tree): readonly Need[] {
  const before = needs.get(tree);
  if (before !== undefined) return before;
  const types = declaredServices(tree);
  const written = tree.library.filter((id) => isSkill(tree, id) && operationOf(tree, id) === undefined);
  const found = [...new Set(written.flatMap((id) => servicesOf(tree, id)))].map((key) => ({ key, type: types[key] }));
  needs.set(tree, found);
  return found;
}

/** The services that no skill of these documents uses, but for skills that were made of them. A key that no service has is found by its type. */
export function servicesWithoutSkills<T extends ServiceHere>(services: readonly T[], documents: readonly Tree[]): readonly T[] {
  const needed = documents.flatMap(neededIn);
  const keys = new Set(services.map(({ key }) => key));
  return services.filter(({ key, type }) => !needed.some((need) => need.key === key || (need.type === type && !keys.has(need.key))));
}

type Offering = Pick<HostedService, "key" | "type" | "rsm" | "available">;

/** Of a list of services: the same list as before, as long as none comes, goes or offers something else. What they do now changes with every transition. */
export function keepServices(): (services: readonly Offering[]) => readonly Offering[] {
  let last: readonly Offering[] = [];
  const isSame = (one: Offering, other: Offering | undefined): boolean => one.key === other?.key && one.rsm === other.rsm && one.available === other.available;
  return (services) => {
    if (services.length !== last.length || !services.every((service, i) => isSame(service, last[i]))) last = services;
    return last;
  };
}
