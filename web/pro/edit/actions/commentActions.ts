// Commenting on what is selected, and the list of all open comments.
import { focusComments, goToComments } from "../../comments/goToComments";
import { listComments } from "../../comments/listed";
import type { Action } from "./action";

export const commentActions: readonly Action[] = [
  {
    id: "comment", name: "Comment", keys: ["Ctrl+Alt+M"], group: "Edit", where: "untyped",
    when: ({ node, ids }) => (node !== undefined ? undefined : ids.length > 1 ? "several are selected" : "no state is selected"),
    run: ({ node }) => {
      if (node === undefined) return;
      goToComments(node);
      focusComments(node);
    },
  },
  { id: "list_comments", name: "List the open comments", keys: [], group: "Walk", where: "untyped", when: () => undefined, run: () => listComments(true) },
];
