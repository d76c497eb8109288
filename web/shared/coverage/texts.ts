// Coverage of tests in words.
import { counted } from "../counted";
import type { Count, GapKind } from "./coverage";
import type { CoverageReport } from "./report";

export const kKindNames: Readonly<Record<GapKind, string>> = { states: "States", ports: "Ports", conditions: "Values of conditions" };

/** Of what is missing. */
export const kGapNames: Readonly<Record<GapKind, string>> = { states: "Never active", ports: "Never fired", conditions: "Values never seen" };

/** The value that a condition never had. */
export const valueText = (value: boolean): string => (value ? "never true" : "never false");

export const neverText = (kind: "states" | "ports"): string => `${kGapNames[kind]} in the tests`;

export const kNeverAlone = "No test runs it by itself";

/** So many of the conditions of a state are named. */
const kNamed = 3;

/** "2 of 4 values of conditions seen: done never true, action 1 never false". */
export function partlyText({ covered, all }: Count, missing: readonly string[]): string {
  const more = missing.length > kNamed ? `, ${missing.length - kNamed} more` : "";
  return `${covered} of ${counted(all, "value")} of conditions seen: ${missing.slice(0, kNamed).join(", ")}${more}`;
}

/** Of a state that is drawn closed. */
export const insideText = (missing: number): string => `${counted(missing, "state or port", "states and ports")} in it never active or fired`;

/** "5 of 20 (25 %)". */
export const countText = ({ covered, all }: Count): string => `${covered} of ${all} (${all === 0 ? 100 : Math.floor((100 * covered) / all)} %)`;

/** "coverage.json: 3 tests, 1 failed". */
export function reportText({ file, tests }: CoverageReport): string {
  const failed = tests.filter(({ passed }) => !passed).length;
  return `${file}: ${counted(tests.length, "test")}, ${failed === 0 ? "all passed" : `${failed} failed`}`;
}

/** That the coverage is of another document, or of another revision of it; nothing: it fits. */
export function otherText(model: string, ofModel: string, document: string | undefined, unknown: readonly string[], untold: readonly string[]): string | undefined {
  if (ofModel !== document) return `It is of ${model}, not of ${document ?? "this document"}.`;
  const parts = [
    ...(unknown.length > 0 ? [`it has ${counted(unknown.length, "state or port", "states and ports")} that the document does not have (${unknown[0] ?? ""})`] : []),
    ...(untold.length > 0 ? [`it says nothing of ${counted(untold.length, "state or port", "states and ports")} of the document (${untold[0] ?? ""})`] : []),
  ];
  return parts.length === 0 ? undefined : `It is of another revision: ${parts.join(", and ")}. Run the tests again.`;
}
