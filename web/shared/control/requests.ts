// What a page asks the server about the controls, besides the connection that holds them. Rejects with a RaceError.
import { answerControlRequest, setCellMode } from "../../../api/typescript/src/calls/control";
import { request } from "../../../api/typescript/src/request";
import type { Control, ControlMode } from "../../generated/messages";

/** Whether who asks for the controls gets them. */
export const answerRequest = (fetcher: typeof fetch, number: number, allow: boolean): Promise<Control> =>
  request({ origin: "", fetch: fetcher }, answerControlRequest({ request: number, allow }));

/** `fetcher`: which tells who has the controls (header.ts). */
export const setMode = (fetcher: typeof fetch, mode: ControlMode["mode"]): Promise<Control> => request({ origin: "", fetch: fetcher }, setCellMode({ mode }));
