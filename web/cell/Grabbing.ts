// Mouse and touch in the cell: finds the link or part below the pointer and drags its point in a plane that faces
// the camera. A pointer that hits nothing turns the camera.
import { Plane, Raycaster, Vector2, Vector3, type Object3D, type PerspectiveCamera } from "three";
import type { Hand } from "../shared/cell/hand";
import type { Vector } from "../generated/messages";

export interface Found {
  readonly body: string;
  readonly part: boolean;
  /** In the frame of the body, and in o. */
  readonly local: Vector3;
  readonly at: Vector3;
}

const triple = ({ x, y, z }: Vector3): Vector => [x, y, z];

/** The link of a robot or the part that an object on the screen belongs to; fixed bodies are none. */
function bodyOf(object: Object3D | null): { readonly frame: Object3D; readonly part: boolean } | undefined {
  for (let each = object; each !== null; each = each.parent) {
    if ("isURDFLink" in each) return { frame: each, part: false };
    if (each.userData["movable"] === true) return { frame: each, part: true };
  }
  return undefined;
}

export class Grabbing {
  /** Whether a plain pointer grabs; else only one with Shift does. */
  always = false;
  /** What is shown is not the cell as it is: nothing can be grabbed. */
  isPast = false;
  private readonly ray = new Raycaster();
  private readonly plane = new Plane();
  private pointer: number | undefined;

  constructor(
    private readonly surface: HTMLElement,
    private readonly camera: PerspectiveCamera,
    private readonly contents: Object3D,
    private readonly hand: Hand,
    private readonly onHolding: (holding: boolean) => void,
  ) {
    // Runs before the camera's own listener, so that it can stop the event.
    surface.addEventListener("pointerdown", this.down, { capture: true });
    surface.addEventListener("pointermove", this.move);
    for (const over of ["pointerup", "pointercancel", "lostpointercapture"] as const) surface.addEventListener(over, this.up);
  }

  dispose(): void {
    this.surface.removeEventListener("pointerdown", this.down, { capture: true });
    this.surface.removeEventListener("pointermove", this.move);
    for (const over of ["pointerup", "pointercancel", "lostpointercapture"] as const) this.surface.removeEventListener(over, this.up);
    this.hand.release();
  }

  /** The link or part at a position of the window [px]. */
  find(x: number, y: number): Found | undefined {
    if (this.isPast) return undefined;
    this.aim(x, y);
    const hit = this.ray.intersectObject(this.contents, true)[0];
    const found = bodyOf(hit?.object ?? null);
    if (hit === undefined || found === undefined) return undefined;
    return { body: found.frame.name, part: found.part, local: found.frame.worldToLocal(hit.point.clone()), at: hit.point };
  }

  /** Shows by cursor and title what the pointer would grab. */
  private hint(event: PointerEvent): void {
    const found = event.buttons === 0 && (this.always || event.shiftKey) ? this.find(event.clientX, event.clientY) : undefined;
    this.surface.style.cursor = found === undefined ? "" : "grab";
    this.surface.title = found?.body ?? "";
  }

  private aim(x: number, y: number): void {
    const { left, top, width, height } = this.surface.getBoundingClientRect();
    this.ray.setFromCamera(new Vector2(((x - left) / width) * 2 - 1, 1 - ((y - top) / height) * 2), this.camera);
  }

  private readonly down = (event: PointerEvent): void => {
    if (event.button !== 0 || this.pointer !== undefined || !(this.always || event.shiftKey)) return;
    const found = this.find(event.clientX, event.clientY);
    if (found === undefined) return;
    event.stopImmediatePropagation();
    event.preventDefault();
    this.pointer = event.pointerId;
    this.surface.setPointerCapture(event.pointerId);
    this.plane.setFromNormalAndCoplanarPoint(this.camera.getWorldDirection(new Vector3()), found.at);
    this.onHolding(true);
    void this.hand.grab(found.body, triple(found.local));
  };

  private readonly move = (event: PointerEvent): void => {
    if (this.pointer === undefined) this.hint(event);
    if (event.pointerId !== this.pointer) return;
    this.aim(event.clientX, event.clientY);
    const target = this.ray.ray.intersectPlane(this.plane, new Vector3());
    if (target !== null) this.hand.drag(triple(target));
  };

  private readonly up = (event: PointerEvent): void => {
    if (event.pointerId === this.pointer) this.letGo();
  };

  /** Releases the hold, also while the pointer is down. */
  letGo(): void {
    if (this.pointer === undefined) return;
    this.pointer = undefined;
    this.hand.release();
    this.onHolding(false);
  }
}
