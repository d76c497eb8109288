// The nodes of a painted drawing that have elements in the page, for what reads the page and for the keyboard: those in use, and as
// many of those that can be read now as are bearable, from the middle of the view on.
import type { Box } from "./drawing";
import { nameSize, showsInside } from "./levels";
import type { Scene, SceneNode } from "./scene";

const kInUse = { nodes: 6, elements: 22 };

const elementsOf = ({ node }: SceneNode): number => 3 + node.ports.length;

/** Paths, in the order of the model. `used`: selected, under the pointer, or with the focus. */
export function nodesInUse(scene: Scene, area: Box, zoom: number, used: Iterable<string>): readonly string[] {
  const middle = { x: area.x + area.width / 2, y: area.y + area.height / 2 };
  const distance = ({ node }: SceneNode) => Math.hypot(node.x + node.width / 2 - middle.x, node.y + node.height / 2 - middle.y);
  const readable = scene.items
    .within(area)
    .filter((item): item is SceneNode => item.kind === "node" && (item.inside === undefined || showsInside(item.inside, zoom)) && (item.node.kind === "barrier" || nameSize(item.node, zoom) > 0))
    .map((item) => ({ item, distance: distance(item) }))
    .sort((a, b) => a.distance - b.distance)
    .map(({ item }) => item);
  const chosen = new Set<SceneNode>();
  let elements = 0;
  for (const item of [...[...used].flatMap((path) => scene.node(path) ?? []), ...readable]) {
    if (chosen.has(item)) continue;
    elements += elementsOf(item);
    if (chosen.size >= kInUse.nodes || (elements > kInUse.elements && chosen.size > 0)) break;
    chosen.add(item);
  }
  return [...chosen].sort((a, b) => a.order - b.order).map(({ node }) => node.path);
}
