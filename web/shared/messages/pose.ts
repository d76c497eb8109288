// Points and poses (api/schemas/pose.json). Metres; quaternions are [qx, qy, qz, qw].
import { array, DecodeError, number, object, type Decoder } from "../json/decode";

export type Triple = readonly [number, number, number];
export type Quadruple = readonly [number, number, number, number];

export interface Pose {
  readonly position: Triple;
  readonly orientation: Quadruple;
}

export const triple: Decoder<Triple> = (value, path) => {
  const [x, y, z, ...rest] = array(number)(value, path);
  if (x === undefined || y === undefined || z === undefined || rest.length > 0) throw new DecodeError(path, "three numbers", value);
  return [x, y, z];
};

const quadruple: Decoder<Quadruple> = (value, path) => {
  const [x, y, z, w, ...rest] = array(number)(value, path);
  if (x === undefined || y === undefined || z === undefined || w === undefined || rest.length > 0) {
    throw new DecodeError(path, "four numbers", value);
  }
  return [x, y, z, w];
};

export const pose: Decoder<Pose> = object((f) => ({
  position: f.need("position", triple),
  orientation: f.need("orientation", quadruple),
}));
