// Draws what a depth camera sees: a point for each measured pixel, in its colour.
import { BufferAttribute, BufferGeometry, Points, PointsMaterial } from "three";
import type { Cloud } from "../shared/cell/cloud";

/** [m] */
const kSize = 0.006;

export class PointCloud {
  private readonly material = new PointsMaterial({ size: kSize, vertexColors: true });
  readonly points = new Points(new BufferGeometry(), this.material);

  constructor() {
    this.points.name = "cloud";
    this.points.frustumCulled = false;
    this.points.visible = false;
  }

  /** Replaces what is drawn; nothing: no points. */
  show(cloud: Cloud | undefined): void {
    this.points.visible = cloud !== undefined;
    this.points.geometry.dispose();
    this.points.geometry = new BufferGeometry();
    if (cloud === undefined) return;
    this.points.geometry.setAttribute("position", new BufferAttribute(cloud.positions, 3));
    this.points.geometry.setAttribute("color", new BufferAttribute(cloud.colours, 3, true));
  }

  dispose(): void {
    this.points.geometry.dispose();
    this.material.dispose();
  }
}
