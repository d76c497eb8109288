// A new run of an application, from its beginning.
import { api, session } from "../client";

export async function begin(name: string): Promise<void> {
  const made = await api.createCore(name, {});
  session.dispatch({ type: "update", update: { type: "core", core: made } });
  await api.start(made.id);
}
