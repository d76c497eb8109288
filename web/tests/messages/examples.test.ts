// Every file of api/examples is read by the decoder of its schema, so the pages and the contract cannot part unseen.
import { readdirSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { describe, expect, it } from "vitest";
import { array, boolean, number, object, oneOf, string, type Decoder } from "../../shared/json/decode";
import { cellPose, scene } from "../../shared/messages/cell";
import { core, coreState, cores } from "../../shared/messages/core";
import { person } from "../../shared/messages/person";
import { rules, traceSteps } from "../../shared/messages/derivation";
import { services } from "../../shared/messages/service";
import { serverErrors, streamMessage, type StreamRequest } from "../../shared/messages/stream";
import { why } from "../../shared/messages/why";
import { rcmDocument } from "../../shared/model/decodeModel";
import { readJson } from "../conformance";

const folder = new URL("../../../api/examples/", import.meta.url);
/** All but what processes of components and the server say to each other. */
const files = readdirSync(fileURLToPath(folder)).filter((name) => name.endsWith(".json") && !name.startsWith("component_"));

const stringOrNumber: Decoder<string | number> = (value, path) => (typeof value === "number" ? value : string(value, path));

/** What the pages send is written, not read: these examples only have to name what the pages write. */
const request: Decoder<StreamRequest> = object((f): StreamRequest => {
  const type = f.need("type", oneOf("subscribe", "unsubscribe", "display", "answer", "press", "played"));
  switch (type) {
    case "display":
      return { type, name: f.need("name", string), sound: f.need("sound", boolean) };
    case "answer":
      return { type, question: f.need("question", number), answer: f.need("answer", stringOrNumber) };
    case "press":
      return { type, button: f.need("button", string) };
    case "played":
      return { type, sound: f.need("sound", number) };
    default:
      f.maybe("since", number);
      return { type, channel: f.need("channel", string) };
  }
});

const decoders: Readonly<Record<string, Decoder<unknown>>> = {
  core,
  cores,
  core_state: coreState,
  core_create: object((f) => f.need("document", string)),
  cell_pose: cellPose,
  derivations: traceSteps,
  document: rcmDocument,
  errors: serverErrors,
  operator: object((f) => f.need("acts", array(object((act) => act.has("do"))))),
  person,
  person_command: object((f) => f.need("act", oneOf("grab", "drag", "release", "push", "place", "take"))),
  rules,
  scene,
  services,
  step_request: object((f) => f.need("kind", oneOf("micro", "macro", "until"))),
  stream_message: streamMessage,
  stream_request: request,
  why,
};

describe("api/examples", () => {
  it("are there", () => expect(files.length).toBeGreaterThan(10));
  it.each(files)("%s is read by the decoder of its schema", (file) => {
    const decoder = decoders[file.split(".")[0] ?? ""];
    if (decoder === undefined) throw new Error(`no decoder for ${file}`);
    expect(decoder(readJson(new URL(file, folder)), "")).toBeDefined();
  });
});
