// Packets of data flows between services (api/schemas: packet).
import { json, number, object, present, string, type Decoder, type JsonValue } from "../json/decode";

/** What a camera saw, as small as a page needs it; both in base64, by rows from the top left. */
export interface Picture {
  /** [pixels] */
  readonly width: number;
  readonly height: number;
  /** 16 bit little-endian for each pixel [mm]; 0: not measured. */
  readonly depth: string;
  /** Red, green, blue for each pixel. */
  readonly colour: string;
}

export interface Packet {
  /** What it shows was so then [s]. */
  readonly time: number;
  /** What the packet says of itself; what that means is the flow's own. */
  readonly header: JsonValue;
  /** Of a packet in a camera's encoding. */
  readonly picture?: Picture;
}

const picture: Decoder<Picture> = object((f) => ({
  width: f.need("width", number),
  height: f.need("height", number),
  depth: f.need("depth", string),
  colour: f.need("colour", string),
}));

export const packet: Decoder<Packet> = object((f) =>
  present<Packet>({ time: f.need("time", number), header: f.need("header", json), picture: f.maybe("picture", picture) }),
);
