// Validators of messages: code that ajv makes of the schemas, without ajv itself.
import Ajv from "ajv";
import standaloneCode from "ajv/dist/standalone/index.js";
import { mapSchemas, typeName, validatorName } from "./schemas.mjs";

const kAnnotations = new Set(["$schema", "$id", "title", "description", "default", "contentEncoding"]);
const kClosing = new Set(["additionalProperties", "unevaluatedProperties"]);

/**
 * What a validator needs of a schema. Fields that the schema does not have are accepted: a page of an older build reads
 * the messages of a newer server.
 */
function essence(schema) {
  const kept = Object.entries(schema).filter(([key, value]) => !kAnnotations.has(key) && !(kClosing.has(key) && value === false));
  return withDiscriminator(Object.fromEntries(kept));
}

/** Says which field tells alternatives apart, where one does: then only the alternative that is meant is checked. */
function withDiscriminator(schema) {
  const constants = schema.oneOf?.map(({ properties = {} }) => Object.keys(properties).filter((name) => properties[name].const !== undefined));
  const propertyName = constants?.[0].find((name) => constants.every((each) => each.includes(name)));
  return propertyName === undefined ? schema : { type: "object", ...schema, discriminator: { propertyName } };
}

/** The text of a module that exports a validator for each message at `addresses`. */
export function validatorsOf(schemas, addresses) {
  const ajv = new Ajv.default({
    allowUnionTypes: true,
    discriminator: true,
    code: { esm: true, source: true },
    inlineRefs: false,
    logger: false, // it only says that `unicode` is deprecated; all else throws
    messages: false,
    strictTypes: false,
    unicode: false, // lengths in UTF-16 units need no library
  });
  for (const [file, schema] of schemas) ajv.addSchema(mapSchemas(schema, essence), file);
  const names = Object.fromEntries(addresses.map((address) => [validatorName(address), address]));
  const code = standaloneCode.default(ajv, names);
  if (code.includes("require(")) throw new Error("a validator needs a library");
  return code.replaceAll(/schemaPath:"[^"]*",/g, ""); // a tenth of the code, and the pages do not show it
}

/** The declarations of that module, which finds the type of validators in `check`, and those of messages in `messages`. */
export function declarationsOf(addresses, check, messages) {
  const types = addresses.map(typeName);
  return [
    `import type { Validator } from "${check}";`,
    `import type { ${types.join(", ")} } from "${messages}";`,
    ...addresses.map((address) => `export declare const ${validatorName(address)}: Validator<${typeName(address)}>;`),
    "",
  ].join("\n");
}
