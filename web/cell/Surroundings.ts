// What is around the bodies of a cell: light, floor and background, in the colours of the theme.
import { AmbientLight, Color, DirectionalLight, GridHelper, Group, HemisphereLight, type Scene } from "three";
import { tokenColour } from "../pro/theme/tokenColour";

export class Surroundings {
  private readonly floor = new Group();

  constructor(private readonly scene: Scene) {
    const light = tokenColour("--cell-light");
    const sun = new DirectionalLight(light, 2.1);
    sun.position.set(1.5, -2, 3.5);
    sun.castShadow = true;
    sun.shadow.mapSize.set(2048, 2048);
    sun.shadow.camera.left = sun.shadow.camera.bottom = -1.8;
    sun.shadow.camera.right = sun.shadow.camera.top = 1.8;
    scene.add(sun, new AmbientLight(light, 0.55), new HemisphereLight(light, tokenColour("--cell-ground"), 0.9), this.floor);
    this.paint();
  }

  /** Takes the colours of the theme that is shown. */
  paint(): void {
    this.scene.background = new Color(tokenColour("--cell-background"));
    this.clearFloor();
    this.floor.add(new GridHelper(6, 60, tokenColour("--cell-grid-axis"), tokenColour("--cell-grid")).rotateX(Math.PI / 2));
  }

  /** The height of the floor [m]. */
  placeFloor(z: number): void {
    this.floor.position.z = z;
  }

  dispose(): void {
    this.clearFloor();
  }

  private clearFloor(): void {
    for (const grid of this.floor.children) if (grid instanceof GridHelper) grid.dispose();
    this.floor.clear();
  }
}
