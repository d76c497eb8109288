// The condition of a breakpoint: names that mean nothing are told while it is typed; cores tell the rest when they take it.
import { useEffect, useId, useMemo, useState, type KeyboardEvent } from "react";
import type { KeptBreakpoint } from "../../generated/messages";
import { mistakesIn, type Mistake } from "../../shared/code/mistakes";
import { runScope } from "../../shared/code/runScope";
import { conditionScope, type Scope } from "../../shared/code/scope";
import { selectionOf } from "../../shared/debugger/places";
import type { State } from "../../shared/model/model";
import { ownerOf, stateAt } from "../../shared/model/modelTree";
import { useSession, useView } from "../client";
import { useEditing } from "../edit/editing";
import { useKnownServices } from "../edit/forms/useKnownServices";
import { useRunTree } from "../live/runTree";

/** The word that is being written is not told of until it is whole [ms]. */
const kPause = 400;

/** The state whose names a breakpoint in the run may use; nothing: the run has none such. */
function useRunState(breakpoint: KeptBreakpoint): State | undefined {
  const tree = useRunTree();
  return useMemo(() => {
    if (tree === undefined) return undefined;
    const { id, path } = breakpoint;
    if (id === undefined && path === undefined) return stateAt(tree, tree.keys().next().value ?? "");
    const at = selectionOf(tree, breakpoint);
    return at && stateAt(tree, at.kind === "port" ? ownerOf(at.address) : at.path);
  }, [tree, breakpoint]);
}

/** On the page of the run the document is not here: the names are those of the model that the run executes. */
function useScope(breakpoint: KeptBreakpoint): Scope {
  const { id, path } = breakpoint;
  const isEdited = useView((v) => v.page === "edit");
  const edited = useEditing(({ session }) => session?.view);
  const services = useKnownServices();
  // Of a place that is named by a path, the element is not known.
  const tree = isEdited && path === undefined ? edited : undefined;
  const state = useRunState(breakpoint);
  const declared = useSession((s) => s.model?.services);
  const inRun = isEdited ? undefined : state;
  return useMemo(() => (inRun === undefined ? conditionScope(tree, id, services) : runScope(inRun, declared ?? {}, services)), [inRun, declared, tree, id, services]);
}

/** The first mistake of a text that has rested. */
function useMistake(text: string, scope: Scope): Mistake | undefined {
  const [rested, setRested] = useState(text);
  useEffect(() => {
    const timer = setTimeout(() => setRested(text), kPause);
    return () => clearTimeout(timer);
  }, [text]);
  return useMemo(() => (rested === text ? mistakesIn(text, scope)[0] : undefined), [rested, text, scope]);
}

interface Props {
  readonly breakpoint: KeptBreakpoint;
  readonly value: string;
  readonly isRequired: boolean;
  /** A core has refused it. */
  readonly wrong: boolean;
  readonly onCommit: (condition: string) => void;
}

/** Enter or leaving the field takes what is written, Esc does not. */
export function ConditionInput({ breakpoint, value, isRequired, wrong, onCommit }: Props) {
  const [draft, setDraft] = useState<string>();
  const told = useId();
  const text = draft ?? value;
  const mistake = useMistake(text, useScope(breakpoint));
  const commit = () => {
    const written = draft?.trim();
    setDraft(undefined);
    if (written !== undefined && written !== value && !(isRequired && written === "")) onCommit(written);
  };
  const press = (event: KeyboardEvent) => {
    if (event.key === "Enter") commit();
    else if (event.key === "Escape") setDraft(undefined);
    else return;
    event.preventDefault();
    event.stopPropagation();
  };
  return (
    <>
      <input
        aria-label="Condition"
        aria-invalid={wrong || mistake?.severity === "error"}
        aria-describedby={told}
        placeholder="if …"
        maxLength={500}
        spellCheck={false}
        value={text}
        onChange={({ target }) => setDraft(target.value)}
        onBlur={commit}
        onKeyDown={press}
      />
      <small id={told} role="status" className={`condition-told ${mistake?.severity === "error" ? "bad" : "quiet"}`}>
        {mistake?.message}
      </small>
    </>
  );
}
