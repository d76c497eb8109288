// The JSON Schemas of the messages: Foxglove's well-known ones, by the fields that it publishes
// (https://docs.foxglove.dev/docs/sdk/schemas), and RACE's own.
//
// Foxglove reads a part of JSON Schema: objects with properties, arrays of objects or of simple values. A value of any kind is
// therefore its JSON text.

export interface Field {
  readonly type: "object" | "array" | "string" | "number" | "integer" | "boolean";
  readonly title?: string;
  readonly description?: string;
  readonly properties?: Readonly<Record<string, Field>>;
  readonly required?: readonly string[];
  readonly items?: Field;
  readonly contentEncoding?: "base64";
  readonly minimum?: number;
  readonly maximum?: number;
}

/** All properties are required but those that are named. */
function objectOf(title: string, properties: Readonly<Record<string, Field>>, ...optional: readonly string[]): Field {
  return { type: "object", title, properties, required: Object.keys(properties).filter((name) => !optional.includes(name)) };
}
const text = (description: string): Field => ({ type: "string", description });
const number = (description: string): Field => ({ type: "number", description });
const count = (description: string): Field => ({ type: "integer", minimum: 0, description });
const flag = (description: string): Field => ({ type: "boolean", description });
const listOf = (items: Field, description: string): Field => ({ type: "array", items, description });

const kTime = objectOf("time", { sec: count("Since 1970, UTC [s]."), nsec: { ...count("[ns]"), maximum: 999_999_999 } });
const kCoordinates = { x: number("[m]"), y: number("[m]"), z: number("[m]") };
const kQuaternion = { x: number("x"), y: number("y"), z: number("z"), w: number("w") };

const kFoxglove = {
  "foxglove.FrameTransforms": objectOf("foxglove.FrameTransforms", {
    transforms: listOf(
      objectOf("foxglove.FrameTransform", {
        timestamp: kTime,
        parent_frame_id: text("The frame in which the other one is placed."),
        child_frame_id: text("The frame that is placed."),
        translation: objectOf("foxglove.Vector3", kCoordinates),
        rotation: objectOf("foxglove.Quaternion", kQuaternion),
      }),
      "Links of robots and movable bodies.",
    ),
  }),
  "foxglove.JointStates": objectOf("foxglove.JointStates", {
    timestamp: kTime,
    joints: listOf(objectOf("foxglove.JointState", { name: text("As in the URDF."), position: number("[rad] or [m]") }), "All joints of the cell."),
  }),
  "foxglove.CompressedImage": objectOf("foxglove.CompressedImage", {
    timestamp: kTime,
    frame_id: text("The camera."),
    data: { type: "string", contentEncoding: "base64", description: "The image." },
    format: text("jpeg"),
  }),
  "foxglove.Log": objectOf("foxglove.Log", {
    timestamp: kTime,
    level: { ...count("2 INFO, 3 WARNING, 4 ERROR."), maximum: 5 },
    message: text("A line."),
    name: text("The service that it is about, else run."),
    file: text("Empty."),
    line: count("0"),
  }),
} as const;

const kStep = { timestamp: kTime, step: count("Macro step, from 1.") };

const kRace = {
  "race.State": objectOf("race.State", {
    ...kStep,
    timed: flag("Whether it is recorded when the macro step began; else the time is that of the last one before of which it is."),
    active: listOf(text("Path"), "Active states and barriers after the macro step, in tree order."),
    ports: listOf(text("Path.port"), "Active ports."),
    numbers: listOf(objectOf("race.Number", { name: text("As Root/A.res.width."), value: number("SI units.") }), "Parameters, results and variables that are numbers."),
    values: text("JSON: parameters, results and variables, path -> name -> value."),
  }),
  "race.Input": objectOf(
    "race.Input",
    {
      ...kStep,
      kind: text("start, event, response, edit, force or abort."),
      service: text("Of an event or a response."),
      name: text("The event; of a response, the operation."),
      call: count("Of a response, the number of the call."),
      failed: flag("Of a response, whether it is an error."),
      data: text("JSON: the data of an event, the result or error of a response, an edit, what was forced."),
    },
    "service", "name", "call", "failed", "data",
  ),
  "race.Call": objectOf(
    "race.Call",
    {
      ...kStep,
      micro: count("Micro steps of the macro step that are done with it."),
      call: count("Its number in the run; absent: it has none."),
      service: text("As in svc.<key>."),
      operation: text("Of the service."),
      args: text("JSON: arguments by place."),
      kwargs: text("JSON: arguments by name."),
    },
    "call",
  ),
  "race.Derivation": objectOf("race.Derivation", {
    ...kStep,
    micro: listOf(
      objectOf("race.MicroStep", { rule: text("Of the root of the tree."), equation: text("Of the thesis."), at: text("Path"), tree: text("JSON: the whole tree (api/schemas/derivation.json).") }),
      "The proof trees of the micro steps, in order.",
    ),
  }),
  "race.ServiceState": objectOf(
    "race.ServiceState",
    { timestamp: kTime, service: text("As in svc.<key>."), available: flag("Whether it is there."), state: text("Of its RSM, from then on; absent: it is not available, or a mere interface.") },
    "state",
  ),
} as const;

/** By their names in the file. */
export const kSchemas = { ...kFoxglove, ...kRace };
export type SchemaName = keyof typeof kSchemas;
