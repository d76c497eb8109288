// Draws hands and pushes: a line to the target, a dot at the contact point, the force beside it; and at a hand that pulls an arm that holds, why it does.
import { BufferAttribute, BufferGeometry, Group, Line, LineBasicMaterial, Mesh, MeshBasicMaterial, SphereGeometry, Vector3, type Camera } from "three";
import { apart } from "../shared/cell/labels";
import { forceText, lineEnd } from "../shared/cell/touch";
import type { Touch } from "../generated/messages";

/** From the end of a line to its label [px]. */
const kBeside = 8;
/** From the end of a line to the reason below its force [px]. */
const kBelow = 13;

export class HandLines {
  readonly group = new Group();
  private readonly material = new LineBasicMaterial({ depthTest: false });
  private readonly dotMaterial = new MeshBasicMaterial({ depthTest: false });
  private readonly dot = new SphereGeometry(0.008, 12, 8);
  private readonly drawn: { readonly line: Line; readonly dot: Mesh; readonly label: HTMLElement }[] = [];
  private readonly why = document.createElement("span");
  private touches: readonly Touch[] = [];
  /** The body about which `why` is. */
  private held: string | undefined;

  constructor(private readonly host: HTMLElement) {
    this.why.className = "cell-why";
    this.why.setAttribute("role", "status");
    host.append(this.why);
  }

  /** The colour of lines and dots from now on. */
  paint(colour: string): void {
    this.material.color.set(colour);
    this.dotMaterial.color.set(colour);
  }

  show(touches: readonly Touch[]): void {
    this.touches = touches;
    while (this.drawn.length < touches.length) this.add();
    this.drawn.forEach(({ line, dot, label }, i) => {
      const touch = touches[i];
      line.visible = dot.visible = touch !== undefined;
      label.hidden = touch === undefined;
      if (touch === undefined) return;
      line.geometry.setAttribute("position", new BufferAttribute(new Float32Array([...touch.at, ...lineEnd(touch)]), 3));
      dot.position.set(...touch.at);
      label.textContent = forceText(touch);
      label.title = `${touch.hand}: ${touch.body}`;
    });
  }

  /** Why this body does not go with the hand that pulls it. */
  explain(body: string | undefined, reason: string | undefined): void {
    // Until the next frame has placed it; another reason stays where the one before was.
    if (body !== this.held || this.why.textContent === "") this.why.style.visibility = "hidden";
    this.held = body;
    this.why.textContent = body === undefined ? "" : (reason ?? "");
  }

  /** Places the labels at the ends of the lines, without overlap. */
  placeLabels(camera: Camera): void {
    const view = { width: this.host.clientWidth, height: this.host.clientHeight };
    const shown = this.touches.flatMap((touch, i) => {
      const label = this.drawn[i]?.label;
      const end = new Vector3(...lineEnd(touch)).project(camera);
      const force = label === undefined ? [] : [{ label, end, below: 0 }];
      return touch.body === this.held && this.why.textContent !== "" ? [...force, { label: this.why, end, below: kBelow }] : force;
    });
    const wanted = shown.map(({ label: { offsetWidth: width, offsetHeight: height }, end, below }) => {
      return { x: ((end.x + 1) / 2) * view.width + kBeside, y: ((1 - end.y) / 2) * view.height + (below > 0 ? below : -height / 2), width, height };
    });
    apart(wanted, view).forEach(({ x, y }, i) => shown[i]?.label.style.setProperty("translate", `${x}px ${y}px`));
    this.why.style.visibility = shown.some(({ label }) => label === this.why) ? "visible" : "hidden";
  }

  dispose(): void {
    for (const { line, label } of this.drawn) {
      line.geometry.dispose();
      label.remove();
    }
    this.why.remove();
    this.material.dispose();
    this.dotMaterial.dispose();
    this.dot.dispose();
  }

  private add(): void {
    const line = new Line(new BufferGeometry(), this.material);
    const dot = new Mesh(this.dot, this.dotMaterial);
    line.renderOrder = dot.renderOrder = 1;
    line.frustumCulled = false;
    const label = document.createElement("span");
    label.className = "cell-force";
    this.host.append(label);
    this.group.add(line, dot);
    this.drawn.push({ line, dot, label });
  }
}
