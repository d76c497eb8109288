// Marks the link at which a collision was felt: a ball at its joint, and what is known of it in words.
import { Mesh, MeshBasicMaterial, SphereGeometry, type Camera, type Object3D } from "three";
import { apart } from "../shared/cell/labels";

/** [m] */
const kRadius = 0.045;
/** From the joint to the words [px]. */
const kAbove = 34;

export class CollisionMark {
  readonly ball = new Mesh(new SphereGeometry(kRadius, 20, 14), new MeshBasicMaterial({ depthTest: false, transparent: true, opacity: 0.55 }));
  private readonly label = document.createElement("span");
  private link: Object3D | undefined;

  constructor(private readonly host: HTMLElement) {
    this.ball.name = "collision";
    this.ball.renderOrder = 1;
    this.ball.visible = false;
    this.label.className = "cell-collision";
    this.label.setAttribute("role", "status");
    host.append(this.label);
  }

  paint(colour: string): void {
    this.ball.material.color.set(colour);
  }

  /** Marks a link from now on; nothing: none. */
  show(link: Object3D | undefined, text = ""): void {
    this.link = link;
    this.ball.visible = link !== undefined;
    this.label.textContent = link === undefined ? "" : text;
    // Until the next frame has placed it.
    this.label.style.visibility = "hidden";
  }

  /** Follows the link, which moves. To be called with each frame. */
  follow(camera: Camera): void {
    if (this.link === undefined) return;
    this.link.getWorldPosition(this.ball.position);
    const at = this.ball.position.clone().project(camera);
    const view = { width: this.host.clientWidth, height: this.host.clientHeight };
    const { offsetWidth: width, offsetHeight: height } = this.label;
    const [place] = apart([{ x: ((at.x + 1) / 2) * view.width - width / 2, y: ((1 - at.y) / 2) * view.height - kAbove - height, width, height }], view);
    if (place === undefined) return;
    this.label.style.setProperty("translate", `${place.x}px ${place.y}px`);
    this.label.style.visibility = "visible";
  }

  dispose(): void {
    this.label.remove();
    this.ball.geometry.dispose();
    this.ball.material.dispose();
  }
}
