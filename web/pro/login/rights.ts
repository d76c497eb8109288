// Why the account that uses this page may not do something, or why it cannot be done now: for functions and for components.
import { refusalOfAction } from "../../shared/login/doings";
import { refusalOfActionByStop } from "../../shared/stop/refusals";
import { createRights } from "../../page/rights";
import { stop } from "../../stop/page";
import { login } from "../client";

export const { refusalNow, useRefusal, refusalOfCommandNow, useRefusalOfCommand, useRefusalToStart } = createRights(login);

export const refusalOfActionNow = (action: { readonly id: string; readonly group: string }): string | undefined => refusalOfAction(login.get().me, action) ?? refusalOfActionByStop(stop.get(), action);
