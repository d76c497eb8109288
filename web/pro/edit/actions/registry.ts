// All actions of the page that edits.
import { cellActions } from "../../cell/reset";
import { debuggerActions } from "../../debugger/actions";
import { liveActions } from "../../live/liveActions";
import type { Action } from "./action";
import { addActions } from "./addActions";
import { clipboardActions } from "./clipboardActions";
import { commentActions } from "./commentActions";
import { connectActions } from "./connectActions";
import { documentActions } from "./documentActions";
import { editActions } from "./editActions";
import { menuAction } from "./menuAction";
import { nameActions } from "./nameActions";
import { pageActions } from "./pageActions";
import { pairingActions } from "../../pairing/pairing";
import { placingActions } from "./placingActions";
import { structureActions } from "./structureActions";
import { walkActions } from "./walkActions";

const inMenus: readonly Action[] = [...editActions, ...clipboardActions, ...addActions, ...connectActions, ...structureActions, ...placingActions, ...commentActions, ...nameActions, ...debuggerActions, ...documentActions, ...pageActions];

export const actions: readonly Action[] = [...inMenus, ...walkActions, ...liveActions, ...cellActions, ...pairingActions, menuAction(inMenus)];

/** Requires the id of an action. */
export function actionOf(id: string): Action {
  const found = actions.find((action) => action.id === id);
  if (found === undefined) throw new Error(`there is no action ${id}`);
  return found;
}
