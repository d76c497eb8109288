// The methods of texts, lists and dicts, with their parameters; a test compares them with the table of core/language.
import type { Type } from "../../generated/messages";
import type { Name } from "./names";
import { parametersText } from "./words";

type Methods = Readonly<Record<string, string>>;

/** Each method with its parameters, as core/language/library/functions.h writes them. */
export const kTextMethods: Methods = {
  capitalize: "", center: "width fill?", endswith: "suffix start? end?", find: "sub start? end?", isalnum: "", isalpha: "", isdigit: "", islower: "", isspace: "", isupper: "",
  join: "iterable", ljust: "width fill?", lower: "", lstrip: "chars?", partition: "sep", replace: "old new count?", rfind: "sub start? end?", rindex: "sub start? end?",
  rjust: "width fill?", rpartition: "sep", rsplit: "sep?= maxsplit?=", rstrip: "chars?", split: "sep?= maxsplit?=", splitlines: "keepends?=", startswith: "prefix start? end?",
  strip: "chars?", swapcase: "", title: "", upper: "", zfill: "width", count: "sub start? end?", index: "sub start? end?",
};
export const kListMethods: Methods = {
  count: "x", index: "x start? end?", append: "x", clear: "", copy: "", extend: "iterable", insert: "i x", pop: "i?", remove: "x", reverse: "", sort: "reverse!",
};
export const kDictMethods: Methods = { clear: "", copy: "", get: "key default?", items: "", keys: "", pop: "key default?", setdefault: "key default?", update: "other", values: "" };

const names = (methods: Methods): readonly Name[] => Object.entries(methods).map(([name, parameters]) => ({ name, kind: "method", call: parametersText(parameters) }));

/** The methods of a value of this type; none if it is not known. */
export function methodsOf(type: Type | undefined): readonly Name[] {
  if (type === undefined) return [];
  if (type === "string") return names(kTextMethods);
  if (type === "pose" || type === "image") return names(kDictMethods);
  if (typeof type === "string") return [];
  if ("optional" in type) return methodsOf(type.optional);
  if ("list" in type) return names(kListMethods);
  return "record" in type ? names(kDictMethods) : [];
}
