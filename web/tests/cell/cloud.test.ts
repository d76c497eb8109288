// The points that a depth camera sees, against the plane that it looks at; three.js is the second opinion on rotations.
import { Quaternion, Vector3 } from "three";
import { describe, expect, it } from "vitest";
import { cloudOf, kMostPoints } from "../../shared/cell/cloud";
import type { Packet, Pose } from "../../generated/messages";
import { readStreamMessage } from "../../shared/messages/stream";
import { readJson } from "../files";

/** The camera of the demo: 0.9 m above the plane of the table, 45 degrees down. */
const { camera } = readJson(new URL("../../../deploy/demo/scene.json", import.meta.url)) as { readonly camera: { readonly pose: Pose } };
const o_t_c = { ...camera.pose };
const pinhole = { width: 640, height: 480, fx: 589.4, fy: 609.3, cx: 319.5, cy: 239.5 };

/** Depths [mm] of a plane of this height, as packets have them: of the top left pixel of each square of 2x2. */
function planePacket(z: number, { width, height } = { width: 320, height: 240 }): Packet {
  const turn = new Quaternion(...camera.pose.orientation);
  const depth = Buffer.alloc(2 * width * height);
  const shrink = pinhole.width / width;
  for (let i = 0; i < width * height; i++) {
    const [u, v] = [(i % width) * shrink, Math.floor(i / width) * shrink];
    const ray = new Vector3((u - pinhole.cx) / pinhole.fx, (v - pinhole.cy) / pinhole.fy, 1).applyQuaternion(turn);
    depth.writeUInt16LE(Math.min(65_535, Math.round((1000 * (z - camera.pose.position[2])) / ray.z)), 2 * i);
  }
  const colour = Buffer.alloc(3 * width * height);
  for (let i = 0; i < width * height; i++) colour.set([i % width === 0 ? 255 : 0, 128, 7], 3 * i);
  return { time: 2, header: { ...pinhole, o_t_c }, picture: { width, height, depth: depth.toString("base64"), colour: colour.toString("base64") } };
}

const pointsOf = (packet: Packet) => {
  const cloud = cloudOf(packet);
  if (cloud === undefined) throw new Error("the packet has no cloud");
  const { positions, count } = cloud;
  return Array.from({ length: count }, (_, i) => [...positions.subarray(3 * i, 3 * i + 3)] as [number, number, number]);
};

describe("cloudOf", () => {
  it.each([0, -0.75])("puts the points of a plane at height %f onto it, within 2 mm", (height) => {
    const points = pointsOf(planePacket(height));
    expect(points.length).toBeGreaterThan(10_000);
    expect(Math.max(...points.map(([, , z]) => Math.abs(z - height)))).toBeLessThan(0.002);
  });

  it("puts the middle of the picture before the camera, its left at negative y: it looks along -x", () => {
    const points = pointsOf(planePacket(0));
    const nearest = points.reduce((best, point) => (Math.hypot(point[0] - 0.55, point[1]) < Math.hypot(best[0] - 0.55, best[1]) ? point : best));
    expect(Math.hypot(nearest[0] - 0.55, nearest[1])).toBeLessThan(0.02);
    const aside = points.map(([, y]) => y);
    expect(points[0]?.[1]).toBeCloseTo(Math.min(...aside), 3);
    expect(Math.min(...aside)).toBeLessThan(-0.3);
    expect(Math.min(...aside) + Math.max(...aside)).toBeCloseTo(0, 1);
  });

  it("has the colours of the pixels", () => {
    const colours = cloudOf(planePacket(0))?.colours;
    expect([...(colours?.subarray(0, 6) ?? [])]).toEqual([255, 128, 7, 0, 128, 7]);
  });

  it("leaves out what was not measured", () => {
    const packet = planePacket(0);
    const picture = packet.picture && { ...packet.picture, depth: Buffer.alloc(2 * 320 * 240).toString("base64") };
    expect(cloudOf({ ...packet, ...(picture && { picture }) })?.count).toBe(0);
  });

  it("has a bound, also for pictures that are higher", () => {
    for (const size of [{ width: 320, height: 240 }, { width: 320, height: 2400 }]) {
      const count = cloudOf(planePacket(-0.75, size))?.count ?? 0;
      expect(count).toBeGreaterThan(kMostPoints / 4);
      expect(count).toBeLessThanOrEqual(kMostPoints);
    }
  });

  it("reads the packets of the stream", () => {
    const { update } = readStreamMessage(readJson(new URL("../../../api/examples/stream_message.flow_delta.json", import.meta.url)));
    const cloud = update.type === "packet" ? cloudOf(update.packet) : undefined;
    expect(cloud?.count).toBe(1);
    expect([...(cloud?.colours ?? [])]).toEqual([200, 10, 20]);
  });

  it("is nothing without a picture, a pinhole or a place of the camera", () => {
    const packet = planePacket(0);
    expect(cloudOf({ time: 1, header: packet.header })).toBeUndefined();
    for (const header of [null, 3, pinhole, { ...pinhole, o_t_c: 1 }, { ...pinhole, o_t_c: { ...o_t_c, orientation: [0, 0, 1] } }, { o_t_c }])
      expect(cloudOf({ ...packet, header })).toBeUndefined();
  });
});
