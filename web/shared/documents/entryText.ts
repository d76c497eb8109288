// The text of one field of a JSON object, as it stands there.

const kToken = /"(?:[^"\\]|\\.)*"|[[\]{}:,]|[^\s"[\]{}:,]+/g;
const kOpening: ReadonlySet<string> = new Set(["{", "["]);
const kClosing: ReadonlySet<string> = new Set(["}", "]"]);

/** The text of the value of `field` of the object itself, without space around it; nothing if it has none. Requires JSON. */
export function fieldText(json: string, field: string): string | undefined {
  let depth = 0;
  let key = true;
  let named = false;
  let begin: number | undefined;
  let end = 0;
  for (const { 0: token, index } of json.matchAll(kToken)) {
    if (kClosing.has(token)) depth -= 1;
    if (begin !== undefined && (depth === 0 || (depth === 1 && token === ","))) return json.slice(begin, end);
    if (depth === 1 && token === ",") key = true;
    else if (depth === 1 && token === ":" && key) key = false;
    else if (depth === 1 && key) named = JSON.parse(token) === field;
    else if (begin === undefined && depth === 1 && named) begin = index;
    if (kOpening.has(token)) depth += 1;
    end = index + token.length;
  }
  return undefined;
}
