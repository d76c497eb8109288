// TypeScript types of messages: json-schema-to-typescript makes them, a transformation makes them read-only.
import { compile } from "json-schema-to-typescript";
import ts from "typescript";
import { lookUp, mapSchemas, resolve, typeName } from "./schemas.mjs";

const kRoot = "AllMessages";
const kAnyJson = { tsType: "JsonValue" };
/** Keywords that say nothing about the JSON type of a value. */
const kAnnotations = new Set(["description", "title", "default"]);

const isAnnotation = (schema) => Object.keys(schema).every((key) => kAnnotations.has(key));

/** A schema as json-schema-to-typescript understands it best. Limits that a type cannot state are left out. */
function simplify(schema) {
  const { minItems, maxItems, not, ...rest } = schema;
  const result = minItems === maxItems ? schema : rest;
  // Alternatives that differ in their required fields alone.
  if (result.oneOf?.every((each) => Object.keys(each).join() === "required")) delete result.oneOf;
  // An object of which nothing else is said.
  if (result.type === "object" && result.properties === undefined && result.additionalProperties === undefined) result.additionalProperties = true;
  for (const key of ["items", "additionalProperties"]) if (result[key] === true) result[key] = kAnyJson;
  for (const [name, property] of Object.entries(result.properties ?? {})) {
    if (property === true) result.properties[name] = kAnyJson;
    else if (isAnnotation(property)) result.properties[name] = { ...property, ...kAnyJson };
  }
  return result;
}

/** One schema with a definition for each type: the messages at `addresses` and all definitions that they refer to. */
function bundle(schemas, addresses) {
  const definitions = {};
  const sources = new Map();
  const referTo = (address) => {
    const name = typeName(address);
    if (name === undefined) return { $ref: undefined, address };
    if ((sources.get(name) ?? address) !== address) throw new Error(`${sources.get(name)} and ${address} are both named ${name}`);
    if (!sources.has(name)) {
      sources.set(name, address);
      definitions[name] = convert(address, name);
    }
    return { $ref: `#/$defs/${name}` };
  };
  const convert = (address, name) => {
    const base = address.split("#")[0];
    const { $defs, $schema, $id, title, ...body } = lookUp(schemas, address);
    const converted = mapSchemas(body, (schema) => {
      if (schema.$ref === undefined) return simplify(schema);
      const { $ref, ...beside } = schema;
      const target = resolve($ref, base);
      const reference = typeName(target) === undefined ? convert(target) : referTo(target);
      return Object.keys(beside).length === 0 ? reference : { ...beside, allOf: [reference] };
    });
    return name === undefined ? converted : { description: title, ...converted, title: name };
  };
  const properties = Object.fromEntries(addresses.map((address) => [typeName(address), referTo(address)]));
  return { title: kRoot, type: "object", properties, $defs: definitions };
}

/** Makes all properties and arrays read-only, and drops the type of the bundle. */
const readOnly = (context) => {
  const { factory } = context;
  const modifiers = [factory.createModifier(ts.SyntaxKind.ReadonlyKeyword)];
  const visit = (given) => {
    if (ts.isInterfaceDeclaration(given) && given.name.text === kRoot) return undefined;
    const node = ts.visitEachChild(given, visit, context);
    if (ts.isPropertySignature(node)) return factory.updatePropertySignature(node, modifiers, node.name, node.questionToken, node.type);
    if (ts.isIndexSignatureDeclaration(node)) return factory.updateIndexSignature(node, modifiers, node.parameters, node.type);
    const list = ts.isArrayTypeNode(node) || ts.isTupleTypeNode(node);
    return list ? factory.createTypeOperatorNode(ts.SyntaxKind.ReadonlyKeyword, node) : node;
  };
  return (file) => ts.visitNode(file, visit);
};

/** The text of a module that exports the types of the messages at `addresses`. */
export async function typesOf(schemas, addresses) {
  const text = await compile(bundle(schemas, addresses), kRoot, { additionalProperties: false, bannerComment: "", format: false });
  const source = ts.createSourceFile("messages.ts", text, ts.ScriptTarget.ES2022, true);
  const { transformed } = ts.transform(source, [readOnly]);
  return ts.createPrinter().printFile(transformed[0]);
}
