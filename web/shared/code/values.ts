// Texts that may be the value of an expression, as core/edit/references.h finds them: where an oracle names the child that it chooses.
import { closingOf, isOpening, splitBy } from "./brackets";
import { literalText } from "./strings";
import { tokensOf, type Span, type Token } from "./tokens";

/** The expression without the brackets around all of it. */
function unwrapped(tokens: readonly Token[]): readonly Token[] {
  const isWrapped = tokens[0]?.text === "(" && closingOf(tokens, 0) === tokens.length - 1;
  return isWrapped ? unwrapped(tokens.slice(1, -1)) : tokens;
}

/** The items of a list, or the values of a dict, of which one is chosen: `[...][i]`, `{...}[key]`. */
function chosenItems(tokens: readonly Token[]): readonly (readonly Token[])[] {
  const [first] = tokens;
  const end = first !== undefined && isOpening(first) && first.text !== "(" ? closingOf(tokens, 0) : undefined;
  if (end === undefined || tokens[end + 1]?.text !== "[" || closingOf(tokens, end + 1) !== tokens.length - 1) return [];
  const [inner, index] = [tokens.slice(1, end), tokens.slice(end + 2, -1)];
  if (splitBy(inner, "for").length > 1 || splitBy(index, ":").length > 1) return [];
  const items = splitBy(inner, ",");
  return first?.text === "[" ? items : items.map((item) => splitBy(item, ":")[1] ?? []);
}

function values(of: readonly Token[]): readonly Token[] {
  const tokens = unwrapped(of);
  const [value, ...condition] = splitBy(tokens, "if");
  if (condition.length > 0) {
    const rest = tokens.slice((value?.length ?? 0) + 1);
    const [test] = splitBy(rest, "else");
    return [...values(value ?? []), ...values(rest.slice((test?.length ?? 0) + 1))];
  }
  for (const operator of ["or", "and"]) {
    const parts = splitBy(tokens, operator);
    if (parts.length > 1) return parts.flatMap(values);
  }
  if (tokens.length === 1) return tokens.filter(({ kind }) => kind === "string");
  return chosenItems(tokens).flatMap(values);
}

/** The literals of `text` in an expression whose text may be its value. */
export const valueSpans = (expression: string, text: string): readonly Span[] =>
  values(tokensOf(expression).filter(({ kind }) => kind !== "comment"))
    .filter((token) => literalText(token) === text)
    .map(({ from, to }) => ({ from, to }));
