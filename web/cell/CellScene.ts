// The three.js scene of a cell: robots from URDF, bodies from their shapes, moved by poses. Z points up, as in the cell.
import {
  Box3,
  BoxGeometry,
  BufferGeometry,
  Color,
  CylinderGeometry,
  Group,
  Mesh,
  MeshStandardMaterial,
  Object3D,
  PCFShadowMap,
  PerspectiveCamera,
  Scene,
  SphereGeometry,
  WebGLRenderer,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import URDFLoader, { type URDFRobot } from "urdf-loader";
import type { Cloud } from "../shared/cell/cloud";
import type { Hand } from "../shared/cell/hand";
import { looksDifferent } from "../shared/cell/redraw";
import type { Body, CellPose, Pose, Shape } from "../generated/messages";
import { tokenColour } from "../pro/theme/tokenColour";
import { CollisionMark } from "./CollisionMark";
import { Grabbing } from "./Grabbing";
import { HandLines } from "./HandLines";
import { FrameThrottle } from "./FrameThrottle";
import { PointCloud } from "./PointCloud";
import { Surroundings } from "./Surroundings";

export interface RobotModel {
  readonly name: string;
  readonly pose: Pose;
  /** URDF text. */
  readonly text: string;
}

function geometryOf(shape: Shape): BufferGeometry {
  if ("box" in shape) return new BoxGeometry(...shape.box);
  if ("sphere" in shape) return new SphereGeometry(shape.sphere, 32, 20);
  const { radius, length } = shape.cylinder;
  return new CylinderGeometry(radius, radius, length, 40).rotateX(Math.PI / 2);
}

/** Distance after a key that zooms in, of the one before. */
const kKeyZoom = 0.87;

const isMesh = (object: Object3D): object is Mesh => object instanceof Mesh;

function place(object: Object3D, pose: Pose): void {
  object.position.set(...pose.position);
  object.quaternion.set(...pose.orientation);
}

export class CellScene {
  private readonly scene = new Scene();
  private readonly camera = new PerspectiveCamera(38, 1, 0.02, 40);
  private readonly renderer: WebGLRenderer;
  private readonly controls: OrbitControls;
  private readonly contents = new Group();
  private readonly surroundings: Surroundings;
  private readonly bodies = new Map<string, Object3D>();
  private readonly movable = new Set<string>();
  private readonly hands: HandLines;
  private readonly collision: CollisionMark;
  private readonly cloud = new PointCloud();
  /** Mouse and finger. */
  readonly grabbing: Grabbing;
  private robots: URDFRobot[] = [];
  private readonly observer: ResizeObserver;
  private shown: CellPose | undefined;
  private readonly throttle = new FrameThrottle(() => {
    this.collision.follow(this.camera);
    this.renderer.render(this.scene, this.camera);
    this.hands.placeLabels(this.camera);
    this.appear();
  });
  /** What is still to appear, one after the other. */
  private hidden: Object3D[] = [];

  /** `isPlain`: without shadows and smooth edges, and drawn in steps, so that it takes little of the time of the page where no GPU draws it. */
  constructor(
    private readonly host: HTMLElement,
    hand: Hand,
    private readonly isPlain = false,
  ) {
    this.renderer = new WebGLRenderer({ antialias: !isPlain });
    this.camera.up.set(0, 0, 1);
    this.camera.position.set(2.3, -2.0, 1.6);
    this.renderer.setPixelRatio(isPlain ? 1 : Math.min(2, devicePixelRatio));
    this.renderer.shadowMap.enabled = !isPlain;
    this.renderer.debug.checkShaderErrors = !isPlain;
    this.renderer.shadowMap.type = PCFShadowMap;
    host.append(this.renderer.domElement);
    this.renderer.domElement.setAttribute("aria-label", "3D view of the cell; drag to turn, wheel to zoom, Shift and drag to pull a link or a part; arrows move it, with Shift they turn it, + and − zoom, Home shows it as at first");
    this.hands = new HandLines(host);
    this.collision = new CollisionMark(host);
    this.grabbing = new Grabbing(this.renderer.domElement, this.camera, this.contents, hand, (holding) => {
      this.controls.enabled = !holding;
    });
    this.controls = new OrbitControls(this.camera, this.renderer.domElement);
    this.controls.target.set(0.25, 0, 0.3);
    this.controls.addEventListener("change", () => this.throttle.request());
    this.surroundings = new Surroundings(this.scene);
    this.scene.add(this.contents, this.hands.group, this.collision.ball, this.cloud.points);
    this.paintMarks();
    this.observer = new ResizeObserver(() => this.resize());
    this.observer.observe(host);
    this.controls.update();
    this.controls.saveState();
    this.listenToKeys();
  }

  /** Replaces the contents by these bodies and robots. */
  fill(bodies: readonly Body[], robots: readonly RobotModel[]): void {
    this.empty();
    for (const body of bodies) this.addBody(body);
    this.robots = robots.map((model) => this.addRobot(model));
    const lowest = new Box3().setFromObject(this.contents).min.z;
    this.surroundings.placeFloor(Number.isFinite(lowest) ? Math.min(0, lowest) - 0.002 : 0);
    if (this.isPlain) this.hide([this.contents, ...this.robots]);
    this.throttle.request();
  }

  /** The view as at first. */
  home(): void {
    this.controls.reset();
  }

  /** Takes the colours of the theme that is shown, but for bodies, which have their own. */
  paint(): void {
    this.surroundings.paint();
    this.paintMarks();
    this.throttle.request();
  }

  /** Draws these points; nothing: none. */
  showCloud(cloud: Cloud | undefined): void {
    this.cloud.show(cloud);
    this.throttle.request();
  }

  /** Marks the link of a robot at which a collision was felt; nothing: none. A link that the scene does not have is not marked. */
  showCollision(link: string | undefined, text?: string): void {
    const found = link === undefined ? undefined : this.robots.map((robot) => robot.links[link]).find((each) => each !== undefined);
    this.collision.show(found, text);
    this.throttle.request();
  }

  /** Says at the hand that pulls this link why the arm holds; nothing: it is not pulled, or goes with the hand. */
  explain(link: string | undefined, reason: string | undefined): void {
    this.hands.explain(link, reason);
    this.throttle.request();
  }

  /** Applies a pose; names that the scene does not have are ignored. */
  move(pose: CellPose): void {
    if (this.shown !== undefined && !looksDifferent(this.shown, pose)) return;
    this.shown = pose;
    for (const robot of this.robots) {
      for (const [joint, value] of Object.entries(pose.joints)) if (joint in robot.joints) robot.setJointValue(joint, value);
    }
    for (const [name, body] of Object.entries(pose.bodies)) {
      const object = this.bodies.get(name);
      if (object !== undefined) place(object, body);
    }
    for (const name of this.movable) this.bodies.get(name)?.traverse((each) => (each.visible = name in pose.bodies));
    this.hands.show(pose.hands ?? []);
    this.throttle.request();
  }

  dispose(): void {
    this.throttle.stop();
    this.observer.disconnect();
    this.grabbing.dispose();
    this.hands.dispose();
    this.collision.dispose();
    this.cloud.dispose();
    this.surroundings.dispose();
    this.controls.dispose();
    this.renderer.dispose();
    this.renderer.domElement.remove();
  }

  /** While the view has the focus. */
  private listenToKeys(): void {
    const { domElement } = this.renderer;
    domElement.tabIndex = 0;
    domElement.setAttribute("role", "application");
    this.controls.listenToKeyEvents(domElement);
    domElement.addEventListener("keydown", (event) => {
      if (event.ctrlKey || event.metaKey || event.altKey) return;
      if (event.key === "Home") this.home();
      else if (event.key === "+" || event.key === "=") this.controls.dollyIn(kKeyZoom);
      else if (event.key === "-") this.controls.dollyOut(kKeyZoom);
      else return;
      event.preventDefault();
      event.stopPropagation();
    });
  }

  /** Each of these appears in a frame of its own, as shaders are made when something is drawn for the first time. */
  private hide(objects: readonly Object3D[]): void {
    this.hidden = [...objects];
    for (const object of objects) object.visible = false;
  }

  private appear(): void {
    const next = this.hidden.shift();
    if (next === undefined) return;
    next.visible = true;
    this.throttle.request();
  }

  private paintMarks(): void {
    this.hands.paint(tokenColour("--hand"));
    this.collision.paint(tokenColour("--bad"));
  }

  private empty(): void {
    this.grabbing.letGo();
    this.hands.show([]);
    this.collision.show(undefined);
    this.shown = undefined;
    this.bodies.clear();
    this.movable.clear();
    this.hidden = [];
    this.contents.traverse((part) => {
      if (!isMesh(part)) return;
      part.geometry.dispose();
      for (const material of [part.material].flat()) material.dispose();
    });
    this.contents.clear();
  }

  private addBody(body: Body): void {
    const mesh = new Mesh(geometryOf(body.shape), new MeshStandardMaterial({ color: new Color(body.colour ?? tokenColour("--cell-body")), roughness: 0.75 }));
    mesh.castShadow = !body.fixed;
    mesh.receiveShadow = true;
    place(mesh, body.pose);
    mesh.name = body.name;
    mesh.userData["movable"] = !body.fixed;
    this.bodies.set(body.name, mesh);
    if (!body.fixed) this.movable.add(body.name);
    this.contents.add(mesh);
  }

  private addRobot(model: RobotModel): URDFRobot {
    const robot = new URDFLoader().parse(model.text);
    place(robot, model.pose);
    robot.traverse((part) => {
      part.castShadow = true;
      part.receiveShadow = true;
    });
    this.contents.add(robot);
    return robot;
  }

  private resize(): void {
    const { clientWidth, clientHeight } = this.host;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.camera.aspect = clientWidth / clientHeight;
    this.camera.updateProjectionMatrix();
    this.renderer.setSize(clientWidth, clientHeight);
    this.throttle.request();
  }
}
