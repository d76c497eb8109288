// A document that is not edited on this page, as it is now, while something shows it.
import { useEffect } from "react";
import { openEditor } from "../../shared/edit/editor";
import type { Tree } from "../../shared/edit/tree";
import { listenToStream, session } from "../client";
import { author } from "../edit/author";
import { editing, useEditing } from "../edit/editing";
import { createStore, useSelected } from "../../page/store";

interface Followed {
  readonly document: string;
  readonly tree: Tree | undefined;
}

const followed = createStore<Followed | undefined, Followed | undefined>(undefined, (_, next) => next);

/** Follows its channel, unless the page edits it, which follows it too. The result ends that. */
function follow(document: string): () => void {
  let stop: (() => void) | undefined;
  const open = () => {
    const { stream, end } = listenToStream({ update: (update) => editor.receive(update), connection: (now) => editor.connection(now) });
    const editor = openEditor(stream, session.get().connection, document, author(), {
      onSession: ({ view }) => followed.dispatch({ document, tree: view }),
      onNotice: () => undefined,
    });
    return () => {
      editor.close();
      end();
    };
  };
  const turn = () => {
    const isEdited = editing.get().document === document;
    if (isEdited) {
      stop?.();
      stop = undefined;
    } else stop ??= open();
  };
  const end = editing.listen(turn);
  turn();
  return () => {
    end();
    stop?.();
    followed.dispatch(undefined);
  };
}

/** The document of this name, with the edits of this page if it edits it; nothing: it is not here yet, or none. */
export function useDocument(name: string | undefined): Tree | undefined {
  useEffect(() => (name === undefined ? undefined : follow(name)), [name]);
  const edited = useEditing(({ document, session: now }) => (document === name ? now?.view : undefined));
  const seen = useSelected(followed, (now) => (now?.document === name ? now?.tree : undefined));
  return edited ?? seen;
}
