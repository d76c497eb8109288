// What `race test --coverage --json` has printed (api/schemas/test_report.json), read from a file that somebody opens.
import * as schema from "../../generated/validators";
import type { ModelCoverage, TestReport } from "../../generated/messages";
import { isObject, type JsonValue } from "../json";
import { check } from "../messages/check";
import { messageOf } from "../messageOf";

/** No larger file is read [byte]. */
export const kMostReportBytes = 16 * 1024 * 1024;

export interface CoverageReport {
  /** Its name. */
  readonly file: string;
  readonly tests: TestReport["tests"];
  /** By the file of the model; at least one. */
  readonly models: Readonly<Record<string, ModelCoverage>>;
}

/** Whether the text is what `race test --json` prints, told from documents and tests by what is in it. */
export function isTestReport(text: string): boolean {
  try {
    const json = JSON.parse(text) as JsonValue;
    return isObject(json) && Array.isArray(json["tests"]) && json["race_test"] === undefined;
  } catch {
    return false;
  }
}

const refuse = (file: string, reason: string): Error => new Error(`${file} is no coverage: ${reason}. \`race test --coverage --json FILE > coverage.json\` makes one.`);

function parsed(file: string, text: string): unknown {
  try {
    return JSON.parse(text);
  } catch (error) {
    throw refuse(file, messageOf(error));
  }
}

/** Throws what is wrong, with the file and the place in it. */
export function readReport(file: string, text: string): CoverageReport {
  const json = parsed(file, text);
  let report: TestReport;
  try {
    report = check(schema.testReport, json);
  } catch (error) {
    throw refuse(file, messageOf(error));
  }
  const { tests, coverage } = report;
  if (coverage === undefined) throw refuse(file, "it was made without --coverage");
  if (Object.keys(coverage).length === 0) throw refuse(file, "it has no model");
  return { file, tests, models: coverage };
}

/** The document that a file of a model is by its name: `deploy/demo/pick.rcm.json` is `pick`. */
export const documentOfModel = (model: string): string => model.slice(model.lastIndexOf("/") + 1).replace(/(?:\.rcm)?\.json$/, "");

/** The model that is of a document; else the first one. */
export function modelFor({ models }: CoverageReport, document: string | undefined): string {
  const names = Object.keys(models);
  return names.find((name) => documentOfModel(name) === document) ?? names[0] ?? "";
}
