// The text of a constant as the server has it: `1.0` is 1 in the page's own document.
import { useEffect, useState } from "react";
import { exactElements, type ExactObject } from "../../../shared/edit/exactElements";
import { readExact } from "../../../shared/edit/exact";
import { exactLine, isInexact } from "../../../shared/edit/exactLine";
import type { Element } from "../../../shared/edit/tree";
import { entryOf } from "../../../shared/json";
import { api, problem } from "../../client";
import { editing, useEditing } from "../editing";

const known = new WeakMap<Element, ExactObject>();

interface Loaded {
  readonly revision: number;
  readonly elements: ReadonlyMap<string, ExactObject>;
}
let loading: { readonly document: string; readonly answer: Promise<Loaded> } | undefined;

async function load(document: string): Promise<Loaded> {
  const entry = readExact(await api.documentText(document));
  const { revision, document: json } = entry as { readonly revision: number; readonly document: Parameters<typeof exactElements>[0] };
  return { revision, elements: exactElements(json) };
}

/** Asked for once by all fields that need it at the same time. */
function loadOnce(document: string): Promise<Loaded> {
  if (loading?.document !== document) {
    const begun = (loading = { document, answer: load(document) });
    void begun.answer.catch(() => undefined).then(() => (loading = loading === begun ? undefined : loading));
  }
  return loading.answer;
}

/** Whether the document was loaded as it is here; if it was not, it is loaded again when that changes. */
async function learn(document: string, element: Element): Promise<boolean> {
  const { revision, elements } = await loadOnce(document);
  const found = elements.get(element.id);
  const confirmed = editing.get().session?.confirmed;
  if (found === undefined || confirmed?.revision !== revision || confirmed.tree.elements.get(element.id) !== element) return false;
  known.set(element, found);
  return true;
}

/** JSON in one line; empty: the field is absent; nothing: not known yet. Of an element that the server does not have yet, this page knows all that is exact. */
export function useExactText(id: string, field: string): string | undefined {
  const document = useEditing((state) => state.document);
  const revision = useEditing((state) => state.session?.confirmed?.revision);
  const confirmed = useEditing((state) => state.session?.confirmed?.tree.elements.get(id));
  const element = useEditing((state) => confirmed ?? state.session?.view?.elements.get(id));
  const [, setLearnt] = useState<Element>();
  const value = element && entryOf(element.fields, field);
  const isNeeded = confirmed !== undefined && element !== undefined && value !== undefined && isInexact(value) && !known.has(element);
  useEffect(() => {
    if (!isNeeded || document === undefined) return;
    learn(document, element).then((isLearnt) => isLearnt && setLearnt(element), problem);
  }, [isNeeded, document, element, revision]);
  if (value === undefined) return element === undefined ? undefined : "";
  if (!isInexact(value)) return exactLine(value);
  const exact = element && known.get(element)?.[field];
  return exact === undefined ? undefined : exactLine(exact);
}
