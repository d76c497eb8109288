// The views of a display page and their parts, as the fragment of its address has them: `#move/tool`.

export const kViews = ["show", "move", "run"] as const;
/** `show`: what tasks say and ask; `move`: the robot is moved by hand; `run`: tasks are started and stopped. */
export type PendantView = (typeof kViews)[number];

export const kMoveParts = ["joints", "tool", "hand", "poses"] as const;
/** How the robot is moved: each joint, the tool along its axes, led by hand, to a taught pose. */
export type MovePart = (typeof kMoveParts)[number];

export interface PendantPlace {
  readonly view: PendantView;
  readonly part: MovePart;
}

/** What is not there is what tasks show, and the first part. */
export function placeOf(hash: string): PendantPlace {
  const [view, part] = hash.replace(/^#/, "").split("/");
  return { view: kViews.find((each) => each === view) ?? "show", part: kMoveParts.find((each) => each === part) ?? kMoveParts[0] };
}

export const hashOf = ({ view, part }: PendantPlace): string => (view === "move" ? `#move/${part}` : `#${view}`);
