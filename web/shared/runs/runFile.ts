// Files of runs (api/schemas/run_file.json), told from documents by what is in them.
import { entryOf, isObject, type JsonValue } from "../json";

/** The server takes no larger file of a run [byte]. */
export const kMostRunBytes = 16 * 1024 * 1024;

/** Whether the text is the file of a run: a document has neither a journal nor a run. */
export function isRunFile(text: string): boolean {
  try {
    const json = JSON.parse(text) as JsonValue;
    return isObject(json) && isObject(entryOf(json, "run") ?? null) && isObject(entryOf(json, "journal") ?? null);
  } catch {
    return false;
  }
}
