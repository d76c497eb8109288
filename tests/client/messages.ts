// Messages of the stream about core 1, as a server sends them.
import type { messages } from "../../api/typescript/src/index";
import example from "../../api/examples/core.running.json";

export const kEmpty = { active: [], ports: [], activated: {}, parameters: {}, results: {}, variables: {} };
export const kNoChange = { active: {}, ports: {}, activated: {}, parameters: {}, results: {}, variables: {}, unset: {}, fired: [], calls: [] };

export const core = (step: number, status: messages.Core["status"] = "running"): messages.Core => ({ ...(example as unknown as messages.Core), id: "1", status, step });

export const message = (kind: string, sequence: number, data: unknown, channel = "core/1/state"): string => JSON.stringify({ channel, kind, sequence, data });

export const snapshot = (number: number, step = 0, state: object = {}): string => message("snapshot", number, { core: core(step), state: { ...kEmpty, ...state } });

export const delta = (number: number, step: number, status: messages.Core["status"] = "running", changes: object = {}): string =>
  message("delta", number, { ...kNoChange, core: core(step, status), ...changes });
