// asyncapi.yaml, by the official schema of AsyncAPI 3.0; what it refers to, and its examples of messages.
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { unresolvedIn } from "./references.mjs";

const kFile = "asyncapi.yaml";
const kVersion = "3.0.0";

/** The errors of a schema with alternatives that say most: those deepest in the document, and why, not that, no alternative fits. */
function deepest(errors) {
  const depth = ({ instancePath }) => instancePath.split("/").length;
  const most = Math.max(...errors.map(depth));
  const found = errors.filter((error) => depth(error) === most);
  const reasons = found.filter(({ keyword }) => keyword !== "oneOf");
  return reasons.length > 0 ? reasons : found;
}

const keysOf = (pointer) => pointer.split("/").slice(1).map((key) => key.replaceAll("~1", "/").replaceAll("~0", "~"));

const textOf = ({ message, params }) => `${message}${params.additionalProperty === undefined ? "" : ` (${params.additionalProperty})`}`;

/** What the official schema says of the document: {path, rule, message}. */
function checkFormat(load, document) {
  const Ajv = load("ajv").default;
  // The official schema has a copy of the metaschema in itself.
  const ajv = new Ajv({ strict: false, meta: false, validateSchema: false });
  load("ajv-formats")(ajv);
  const validate = ajv.compile(load("@asyncapi/specs").schemas[kVersion]);
  if (validate(document)) return [];
  return deepest(validate.errors).map((error) => ({ path: keysOf(error.instancePath), rule: "asyncapi", message: textOf(error) }));
}

/** The examples of messages that are not of their payload's schema. */
function checkExamples(document, validatorOf) {
  return Object.entries(document.channels ?? {}).flatMap(([channel, { messages = {} }]) =>
    Object.entries(messages).flatMap(([name, { payload, examples = [] }]) => {
      const validate = validatorOf(payload?.schema?.$ref?.replace("schemas/", "") ?? "");
      if (examples.length > 0 && validate === undefined) {
        return [{ path: ["channels", channel, "messages", name], rule: "example", message: "it has examples and no schema of its payload" }];
      }
      return examples.flatMap((example, index) =>
        validate(example.payload) ? [] : validate.errors.map((error) => ({
          path: ["channels", channel, "messages", name, "examples", index],
          rule: "example",
          message: `payload${error.instancePath} ${textOf(error)}`,
        })),
      );
    }),
  );
}

/** The findings in FOLDER/asyncapi.yaml; `validatorOf` knows the schemas beside it. */
export function checkAsyncapi(load, folder, validatorOf) {
  const { LineCounter, parseDocument } = load("yaml");
  const counter = new LineCounter();
  const parsed = parseDocument(readFileSync(join(folder, kFile), "utf8"), { lineCounter: counter, prettyErrors: false });
  const at = ({ path, ...finding }) => {
    const range = path.map((_, index) => parsed.getIn(path.slice(0, path.length - index), true)?.range).find((each) => each);
    return { file: kFile, at: counter.linePos(range?.[0] ?? 0), ...finding, message: `${finding.message} (#/${path.join("/")})` };
  };
  const problems = [...parsed.errors, ...parsed.warnings];
  if (problems.length > 0) return problems.map(({ pos, message }) => ({ file: kFile, at: counter.linePos(pos[0]), rule: "yaml", message }));
  const document = parsed.toJS();
  if (document?.asyncapi !== kVersion) return [at({ path: ["asyncapi"], rule: "asyncapi", message: `must be ${kVersion}` })];
  const unresolved = unresolvedIn(document, folder).map(({ path, target }) => ({ path, rule: "reference", message: `there is no ${target}` }));
  const format = checkFormat(load, document);
  return [...format, ...unresolved, ...(format.length > 0 ? [] : checkExamples(document, validatorOf))].map(at);
}
