// Who uses a page, and what asks the server in their name.
import { createApi, type Api } from "../shared/api";
import { createAccess, type Access, type AccessControl } from "../shared/login/access";
import { storedTokens } from "../shared/login/tokens";
import { withControls } from "../shared/control/header";
import { controlUrl } from "../shared/control/link";
import type { Store } from "../shared/store";
import { streamUrl } from "../shared/stream";
import { controls } from "../control/page";
import { createStore } from "./store";

export interface Account {
  /** Who uses the page. */
  readonly login: Store<Access, Access>;
  readonly access: AccessControl;
  /** Of the account, and of who has the controls of the cell. */
  readonly fetchWithControls: typeof fetch;
  readonly api: Api;
  /** For what is only asked: it is answered also when the controls have just been lost. */
  readonly bystander: Api;
  /** The address of the controls, for this page. */
  readonly ownControls: () => Promise<string>;
  /** The address of a stream of this page. */
  readonly ownStream: () => Promise<string>;
}

/** To be called once. `onOtherLogin`: another page of the browser has logged in, and this one is of that account now. */
export function createAccount(onOtherLogin: () => void): Account {
  const login = createStore<Access, Access>({ asked: false }, (_, next) => next);
  const access = createAccess({
    fetcher: (input, init) => fetch(input, init),
    tokens: storedTokens(() => localStorage, window),
    onChange: (next) => login.dispatch(next),
    onOtherLogin,
  });
  const fetchWithControls = withControls(access.fetch, controls.secret);
  return {
    login,
    access,
    fetchWithControls,
    api: createApi(fetchWithControls),
    bystander: createApi(access.fetch),
    ownControls: () => access.streamUrl(controlUrl(location)),
    ownStream: () => access.streamUrl(streamUrl(location)),
  };
}
