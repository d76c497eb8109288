// What a page asks the server about the controls, besides the connection that holds them.
import type { Control, ControlAnswer, ControlMode } from "../../generated/messages";
import * as schema from "../../generated/validators";
import { check } from "../messages/check";

/** The server does not do it. `status` tells whether it ever will. */
export class ControlRefusal extends Error {
  constructor(
    readonly status: number,
    message: string,
  ) {
    super(message);
    this.name = "ControlRefusal";
  }
}

async function send(fetcher: typeof fetch, method: string, path: string, body: ControlAnswer | ControlMode): Promise<Control> {
  const answer = await fetcher(`/api/v1/control/${path}`, { method, body: JSON.stringify(body), headers: { "content-type": "application/json" } });
  const data: unknown = await answer.json();
  if (!answer.ok) throw new ControlRefusal(answer.status, check(schema.problem, data).errors.map(({ message }) => message).join("; "));
  return check(schema.control, data);
}

/** Whether who asks for the controls gets them. Throws a ControlRefusal. */
export const answerRequest = (fetcher: typeof fetch, request: number, allow: boolean): Promise<Control> => send(fetcher, "POST", "answer", { request, allow });

/** `fetcher`: which tells who has the controls (header.ts). Throws a ControlRefusal. */
export const setMode = (fetcher: typeof fetch, mode: ControlMode["mode"]): Promise<Control> => send(fetcher, "PUT", "mode", { mode });
