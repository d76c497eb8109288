// Derivations are sent while something shows them. When they come again, the server says where they begin, and those just before are loaded.
import { derivationsWanted } from "../../shared/session/derivations";
import { listenToStream, session, view } from "../client";

/** To be called once, when the page is connected. */
export function followDerivations(): void {
  const { stream } = listenToStream({ update: () => undefined, connection: () => undefined });
  let followed: string | undefined;
  const follow = () => {
    const wanted = derivationsWanted(session.get(), view.get());
    if (wanted === followed) return;
    if (followed !== undefined) stream.unsubscribe(`core/${followed}/derivation`);
    if (wanted !== undefined) stream.subscribe(`core/${wanted}/derivation`);
    followed = wanted;
  };
  session.listen(follow);
  view.listen(follow);
  follow();
}
