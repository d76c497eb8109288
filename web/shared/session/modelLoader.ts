// Loads the model of the run that a page shows, once for each edit of it.

export interface ModelLoader {
  /**
   * Loads the model of run `id`, of which `key` is the edit (modelKey). Does nothing if that was the last request, also if it failed: the
   * page may ask at every message. The answer to a request before the last one is dropped.
   */
  readonly load: (id: string, key: string) => void;
  /** The next request is made whatever was before: another run is shown, or the server is there again. */
  readonly forget: () => void;
}

export interface ModelHandlers<Model> {
  readonly onModel: (id: string, key: string, model: Model) => void;
  readonly onError: (error: unknown) => void;
}

/** `Model`: what is loaded of a run. */
export function createModelLoader<Model>(fetchModel: (id: string) => Promise<Model>, { onModel, onError }: ModelHandlers<Model>): ModelLoader {
  let last: { readonly id: string; readonly key: string } | undefined;
  const load = (id: string, key: string) => {
    if (last?.id === id && last.key === key) return;
    const request = (last = { id, key });
    void fetchModel(id).then(
      (model) => last === request && onModel(id, key, model),
      (error: unknown) => last === request && onError(error),
    );
  };
  return { load, forget: () => (last = undefined) };
}
