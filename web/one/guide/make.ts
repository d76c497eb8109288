// Makes an application of one task, of skills with some of their values: what a person would build by hand. A try after one that has failed goes on with what that
// one has made: there is one document.
import { namesOf } from "../../shared/documents/listed";
import { freeDocumentName, newDocumentText } from "../../shared/documents/names";
import type { SkillPlace } from "../../shared/timeline/changes/add";
import { api, loadDocuments, session } from "../client";
import { editingNow, perform, toldNow, treeNow, untilEditing } from "../editing";
import { offeredSkills } from "../library/offered";
import { author } from "../own";
import { go, place } from "../place";
import { loadSkills, skillDocuments } from "../skills";
import { texts } from "../texts";
import { isMade, nextChange, type WantedSkill } from "./wanted";

const t = texts.application;

function placeOf(skill: string, own: string): SkillPlace {
  const found = offeredSkills(own, treeNow(), skillDocuments(), session.get().services).find(({ name }) => name === skill);
  if (found === undefined || found.missing !== undefined) throw new Error(found?.missing ?? t.noSkill(skill));
  return found.place;
}

/** The name that was asked for last, for each wish: the server may have taken it although its answer was lost. */
const asked = new Map<string, string>();

/** The document of a try before, in which nobody has changed anything. */
async function madeBefore(wish: string): Promise<string | undefined> {
  const name = asked.get(wish);
  if (name === undefined || !namesOf(session.get().documents).has(name)) return undefined;
  const entry = await api.document(name);
  return entry.revision === 1 && entry.author === author() ? name : undefined;
}

/** What a try before has opened, if it can be gone on with. */
function openedBefore(): string | undefined {
  const { edit } = place();
  return edit !== undefined && editingNow().session?.unreadable === undefined ? edit : undefined;
}

async function newDocument(wish: string): Promise<string> {
  const name = freeDocumentName(wish, namesOf(session.get().documents));
  asked.set(wish, name);
  await api.putDocument(name, newDocumentText(name), { author: author() });
  asked.delete(wish);
  await loadDocuments();
  return name;
}

/** What is missing, and all of it taken by the server. */
async function complete(title: string, wanted: readonly WantedSkill[], places: readonly SkillPlace[]): Promise<void> {
  for (let tree = treeNow(); tree !== undefined && !isMade(tree, wanted); tree = treeNow()) {
    const done = perform((now, supplies) => nextChange(now, title, wanted, places, supplies) ?? { reason: t.isChanged });
    if (done === undefined) throw new Error(toldNow());
  }
  await untilEditing((now) => now.session?.pending.length === 0);
  const tree = treeNow();
  // The server has refused a part of it.
  if (tree === undefined || !isMade(tree, wanted)) throw new Error(toldNow() ?? texts.frame.noAnswer);
}

/** Opens it, saved. Throws what has failed. `wish`: its name, if that is free. */
export async function makeApplication(wish: string, title: string, skills: readonly WantedSkill[]): Promise<void> {
  if (session.get().connection !== "open") throw new Error(texts.frame.away);
  const { guide } = place();
  // Names may have been taken since the page has asked for them.
  await loadDocuments();
  await loadSkills();
  const opened = openedBefore();
  const places = skills.map(({ skill }) => placeOf(skill, opened ?? wish));
  const name = opened ?? (await madeBefore(wish)) ?? (await newDocument(wish));
  // Whoever has left the guide meanwhile stays where they are.
  if (place().guide !== guide) return;
  go({ edit: name });
  await untilEditing((now) => now.document === name && now.session?.view !== undefined);
  await complete(title, skills, places);
}
