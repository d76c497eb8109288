// Makes an application of one task, of skills with some of their values: what a person would build by hand.
import { namesOf } from "../../shared/documents/listed";
import { freeDocumentName, newDocumentText } from "../../shared/documents/names";
import type { ExactJson } from "../../shared/edit/exact";
import type { Tree } from "../../shared/edit/tree";
import { addSkill, addTask } from "../../shared/timeline/changes/add";
import { setValue } from "../../shared/timeline/changes/values";
import { readApplication } from "../../shared/timeline/read";
import { api, loadDocuments, session } from "../client";
import { perform, toldNow, treeNow, untilEditing } from "../editing";
import { offeredSkills } from "../library/offered";
import { author } from "../own";
import { go } from "../place";
import { loadSkills, skillDocuments } from "../skills";

export interface WantedSkill {
  /** Of the library state. */
  readonly skill: string;
  readonly values: Readonly<Record<string, ExactJson>>;
}

type Perform = Parameters<typeof perform>[0];

/** The id of what was made. */
function made(change: Perform): string {
  const id = perform(change);
  if (id === undefined) throw new Error(toldNow());
  return id;
}

const rootOf = (tree: Tree): string => readApplication(tree).root.id;

function placeOf(skill: string, own: string) {
  const found = offeredSkills(own, treeNow(), skillDocuments(), session.get().services).find(({ name }) => name === skill);
  if (found === undefined || found.missing !== undefined) throw new Error(found?.missing ?? skill);
  return found.place;
}

/** Opens it, saved. Throws if something is missing. `wish`: its name, if that is free. */
export async function makeApplication(wish: string, title: string, skills: readonly WantedSkill[]): Promise<string> {
  await loadSkills();
  const name = freeDocumentName(wish, namesOf(session.get().documents));
  const places = skills.map(({ skill }) => placeOf(skill, name));
  await api.putDocument(name, newDocumentText(name), { author: author() });
  await loadDocuments();
  go({ edit: name });
  await untilEditing((now) => now.document === name && now.session?.view !== undefined);
  const task = made((tree, supplies) => addTask(tree, rootOf(tree), 0, title, supplies));
  skills.forEach(({ values }, i) => {
    const place = places[i];
    if (place === undefined) return;
    const id = made((tree, supplies) => addSkill(tree, task, i, place, supplies));
    for (const [parameter, value] of Object.entries(values)) made((tree, supplies) => setValue(tree, id, parameter, value, supplies));
  });
  await untilEditing((now) => now.session?.pending.length === 0);
  return name;
}
