// openapi.yaml, by redocly's recommended rules; a warning of them is a finding, too.
import { join, relative, resolve } from "node:path";

/** Besides: examples of schemas and parameters, as the recommended rules have it of bodies. */
const kConfig = {
  extends: ["recommended"],
  rules: { "no-invalid-schema-examples": "error", "no-invalid-parameter-examples": "error" },
};

/** The findings in FOLDER/openapi.yaml and what it refers to. */
export async function checkOpenapi(load, folder) {
  const { createConfig, getLineColLocation, lint, YamlParseError } = load("@redocly/openapi-core");
  const fileOf = ({ absoluteRef }) => relative(resolve(folder), absoluteRef);
  try {
    const problems = await lint({ ref: join(folder, "openapi.yaml"), config: await createConfig(kConfig) });
    return problems.map(({ location: [location], ruleId, message }) => {
      const { source, start } = getLineColLocation(location);
      return { file: fileOf(source), at: start, rule: ruleId, message: `${message} (${location.pointer ?? "#/"})` };
    });
  } catch (error) {
    if (!(error instanceof YamlParseError)) throw error;
    return [{ file: fileOf(error.source), at: { line: error.line, col: error.col }, rule: "yaml", message: error.originalError.reason }];
  }
}
