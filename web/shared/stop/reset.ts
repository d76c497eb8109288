// The reset of the stop.
import type { Control } from "../../generated/messages";
import * as schema from "../../generated/stopValidators";
import { check } from "../messages/check";

/** `fetcher`: of the account. Throws why the server refuses it. */
export async function resetStop(fetcher: typeof fetch): Promise<Control> {
  const answer = await fetcher("/api/v1/stop/reset", { method: "POST" });
  const data: unknown = await answer.json();
  if (!answer.ok) throw new Error(check(schema.problem, data).errors.map(({ message }) => message).join("; "));
  return check(schema.control, data);
}
