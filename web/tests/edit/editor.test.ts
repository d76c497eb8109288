import { describe, expect, it } from "vitest";
import type { OwnRequest } from "../../shared/stream";
import { openEditor } from "../../shared/edit/editor";
import type { EditSession } from "../../shared/edit/session";
import type { Exact } from "../../shared/edit/exact";
import type { JsonObject } from "../../shared/json";
import { vector } from "./documents";

const small = (vector("apply.remove.json") as { readonly document: JsonObject }).document;

function opened(connection: "connecting" | "open") {
  const sent: Exact<OwnRequest>[] = [];
  const channels: string[] = [];
  const sessions: EditSession[] = [];
  const stream = { send: (request: Exact<OwnRequest>) => sent.push(request) > 0, subscribe: (channel: string) => void channels.push(channel), unsubscribe: () => undefined };
  const editor = openEditor(stream, connection, "small", "ann", { onSession: (session) => sessions.push(session), onNotice: () => undefined }, () => "t1");
  return { editor, sent, channels, sessions };
}

describe("an editor", () => {
  it("sends at once over a stream that was open before it, and else when the stream opens", () => {
    for (const connection of ["open", "connecting"] as const) {
      const { editor, sent, channels } = opened(connection);
      expect(channels).toEqual(["document/small"]);
      editor.receive({ type: "document", snapshot: { document: "small", revision: 5, json: small, errors: [] } });
      editor.edit({ operations: [{ op: "set", id: "a", field: "doc", value: "new" }] });
      expect(sent.length).toBe(connection === "open" ? 1 : 0);
      if (connection === "connecting") editor.connection("open");
      expect(sent).toMatchObject([{ type: "edit", document: "small", request: "t1", revision: 5 }]);
    }
  });
  it("says that its document is not there, and ignores refusals of other channels", () => {
    const { editor, sessions } = opened("open");
    const errors = [{ path: "document/small", code: "not_found", message: "there is no channel of this name" }];
    for (const channel of ["", "cores", "document/other"]) editor.receive({ type: "refused", channel, errors });
    expect(sessions).toEqual([]);
    editor.receive({ type: "refused", channel: "document/small", errors });
    expect(editor.session().unreadable).toEqual(errors[0]);
  });
});
