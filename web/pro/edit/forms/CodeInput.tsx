// The control of a field that is a text of code.
import { useMemo } from "react";
import { languageNames, scopeOf, type CodePlace, type Scope } from "../../../shared/code/scope";
import type { CodeFieldName } from "../../../shared/code/texts";
import { CodeField, type Assistance, type OtherCursor } from "../../code/CodeField";
import { useOfOthers } from "../../presence/others";
import { stopWriting, writeAt } from "../../presence/presence";
import { prepareAssistance, unreachableAt } from "../assistance";
import { useEditing } from "../editing";
import { useRowEnter } from "./rowEnter";
import type { DraftField } from "./useDraft";
import { useFieldErrors } from "./useFieldErrors";
import { useKnownServices } from "./useKnownServices";

const kFields: Readonly<Record<string, CodeFieldName>> = { entry: "entry", exit: "exit", when: "when", do: "do", after: "after", from: "from", "oracle:expr": "oracle", "oracle:call": "oracle" };

/** The text of code that a field of a form is; nothing: it is none. */
export const codeFieldOf = (field: string): CodeFieldName | undefined => (Object.hasOwn(kFields, field) ? kFields[field] : undefined);

const kNoScope: Scope = { kind: "function", names: languageNames };

/** The names for a text of the document that is edited. */
function useScope({ id, field }: CodePlace): Scope {
  const tree = useEditing(({ session }) => session?.view);
  const services = useKnownServices();
  return useMemo(() => (tree?.elements.has(id) === true ? scopeOf(tree, { id, field }, services) : kNoScope), [tree, id, field, services]);
}

/** Who else writes in the text. */
const useCursors = (id: string, field: string): readonly OtherCursor[] =>
  useOfOthers((others) =>
    others.flatMap(({ name, person: { id: who, colour, text } }) => (text !== undefined && (text.element ?? "") === id && text.field === field ? [{ id: who, name, colour, offset: text.offset }] : [])),
  );

interface Props {
  readonly id: string;
  readonly field: string;
  readonly code: CodeFieldName;
  readonly label: string;
  readonly describedBy: string;
  readonly draft: DraftField;
  readonly placeholder: string | undefined;
  readonly multiline: boolean;
  readonly readOnly: boolean;
}

export function CodeInput({ id, field, code, draft, ...shown }: Props) {
  const scope = useScope({ id, field: code });
  const errors = useFieldErrors(id, code);
  const assistance = useMemo((): Assistance => ({ prepare: prepareAssistance, unreachable: (before) => unreachableAt({ id, field: code }, before) }), [id, code]);
  const cursors = useCursors(id, field);
  const enter = useRowEnter();
  const commit = (by: "key" | "enter" | "blur") => {
    if (by === "blur" || draft.isDraft) draft.commit(by !== "blur");
    else if (by === "enter") enter?.();
  };
  const cancel = () => {
    if (draft.isDraft) draft.giveUp();
    return draft.isDraft;
  };
  const cursor = (offset: number | undefined) => {
    if (offset === undefined) stopWriting(id, field);
    else writeAt({ ...(id !== "" && { element: id }), field, offset });
  };
  return <CodeField {...shown} value={draft.text} onChange={draft.type} onCommit={commit} onCancel={cancel} onCursor={cursor} cursors={cursors} place={`${id}/${field}`} scope={scope} assistance={scope.kind === "function" ? assistance : undefined} errors={errors} />;
}
