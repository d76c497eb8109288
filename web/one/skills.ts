// The documents with skills: all that the server has, each loaded once for each of its revisions.
import { createStore, useSelected } from "../page/store";
import { isUnanswered } from "../shared/api";
import { readExact, type ExactJson } from "../shared/edit/exact";
import { Refusal } from "../shared/edit/refusal";
import { readTree } from "../shared/edit/tree";
import type { JsonValue } from "../shared/json";
import type { SkillDocument } from "../shared/skills/copy";
import { namedIn, type Named } from "../shared/skills/named";
import { skillsIn } from "../shared/skills/skill";
import { api, session } from "./client";

/** More documents are not looked through. */
const kMost = 100;
/** Where the skills of the demo are: they come first. */
const kFirst = "skills";

interface Loaded {
  readonly revision: number;
  /** Nothing: it has no skills. */
  readonly document: SkillDocument | undefined;
  readonly named: Named;
}

const kNothing: Named = { poses: [], labels: [] };

const store = createStore<ReadonlyMap<string, Loaded>, ReadonlyMap<string, Loaded>>(new Map(), (_, next) => next);
let listed: readonly SkillDocument[] = [];
let named: readonly Named[] = [];
store.listen(() => {
  named = [...store.get().values()].map((each) => each.named);
  listed = [...store.get().values()].flatMap(({ document }) => (document === undefined ? [] : [document])).sort((a, b) => Number(b.name === kFirst) - Number(a.name === kFirst));
});

export const skillDocuments = (): readonly SkillDocument[] => listed;
export const useSkillDocuments = (): readonly SkillDocument[] => useSelected(store, skillDocuments);

const loaded = createStore<boolean, boolean>(false, (_, next) => next);

/** Whether all documents have been looked through once. */
export const useAreSkillsLoaded = (): boolean => useSelected(loaded, (all) => all);

/** What all documents name. */
export const useNamedElsewhere = (): readonly Named[] => useSelected(store, () => named);

async function load(name: string): Promise<Omit<Loaded, "revision">> {
  const text = await api.documentText(name);
  const { document: json } = JSON.parse(text) as { readonly document: JsonValue };
  const tree = readTree(json);
  if (tree instanceof Refusal) return { document: undefined, named: kNothing };
  const document = skillsIn(tree).length === 0 ? undefined : { name, tree, exact: (readExact(text) as { readonly document: ExactJson }).document };
  return { document, named: namedIn(tree) };
}

let loading: Promise<void> | undefined;
let asked = false;

/** What has no answer is asked for again the next time; what cannot be read has nothing. */
const nothingOf = (error: unknown): Omit<Loaded, "revision"> | undefined => (isUnanswered(error) ? undefined : { document: undefined, named: kNothing });

async function loadListed(): Promise<void> {
  const wanted = [...session.get().documents].sort((a, b) => Number(b.name === kFirst) - Number(a.name === kFirst)).slice(0, kMost);
  const kept = new Map([...store.get()].filter(([name]) => wanted.some((each) => each.name === name)));
  if (kept.size !== store.get().size) store.dispatch(kept);
  for (const { name, revision } of wanted) {
    if (store.get().get(name)?.revision === revision) continue;
    const now = await load(name).catch(nothingOf);
    if (now !== undefined) store.dispatch(new Map([...store.get(), [name, { revision, ...now }]]));
  }
  // An application that is open is a document; without any, their list has not come yet.
  if (wanted.length > 0 && wanted.every(({ name }) => store.get().has(name))) loaded.dispatch(true);
}

async function loadAll(): Promise<void> {
  try {
    while (asked) {
      asked = false;
      await loadListed();
    }
  } finally {
    loading = undefined;
  }
}

/** Loads what is new or has changed, one after the other; done when all of it is here, whoever has asked for it. */
export function loadSkills(): Promise<void> {
  asked = true;
  loading ??= Promise.resolve().then(loadAll);
  return loading;
}
