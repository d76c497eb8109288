// The cell as the server tells it (api/schemas: scene, cell_pose, pose). Metres, radians; quaternions are [qx, qy, qz, qw].
import { array, boolean, DecodeError, number, object, present, record, string, type Decoder } from "../json/decode";
import { touches, type Touch } from "./person";
import { pose, triple, type Pose, type Triple } from "./pose";

export type Shape =
  | { readonly kind: "box"; readonly size: Triple }
  | { readonly kind: "cylinder"; readonly radius: number; readonly length: number }
  | { readonly kind: "sphere"; readonly radius: number };

export interface Body {
  readonly name: string;
  readonly shape: Shape;
  readonly pose: Pose;
  readonly fixed: boolean;
  /** `#rrggbb` */
  readonly colour?: string;
}

export interface Scene {
  readonly robots: readonly { readonly name: string; readonly urdf: string; readonly pose: Pose }[];
  readonly bodies: readonly Body[];
}

/** Where everything is at `time` [s]: joints of the URDF by name, bodies by name (none: taken away), hands. */
export interface CellPose {
  readonly time: number;
  readonly joints: Readonly<Record<string, number>>;
  readonly bodies: Readonly<Record<string, Pose>>;
  readonly hands: readonly Touch[];
}

const cylinder = object((f) => ({ radius: f.need("radius", number), length: f.need("length", number) }));

const shape: Decoder<Shape> = (value, path) =>
  object((f): Shape => {
    if (f.has("box")) return { kind: "box", size: f.need("box", triple) };
    if (f.has("cylinder")) return { kind: "cylinder", ...f.need("cylinder", cylinder) };
    if (f.has("sphere")) return { kind: "sphere", radius: f.need("sphere", number) };
    throw new DecodeError(path, "box, cylinder or sphere", value);
  })(value, path);

const colour: Decoder<string> = (value, path) => {
  const text = string(value, path);
  if (!/^#[0-9a-f]{6}$/i.test(text)) throw new DecodeError(path, "#rrggbb", value);
  return text;
};

const body: Decoder<Body> = object((f) =>
  present<Body>({
    name: f.need("name", string),
    shape: f.need("shape", shape),
    pose: f.need("pose", pose),
    fixed: f.need("fixed", boolean),
    colour: f.maybe("colour", colour),
  }),
);

export const scene: Decoder<Scene> = object((f) => ({
  robots: f.need("robots", array(object((r) => ({ name: r.need("name", string), urdf: r.need("urdf", string), pose: r.need("pose", pose) })))),
  bodies: f.need("bodies", array(body)),
}));

export const cellPose: Decoder<CellPose> = object((f) => ({
  time: f.need("time", number),
  joints: f.need("joints", record(number)),
  bodies: f.need("bodies", record(pose)),
  hands: f.or("hands", touches, []),
}));
