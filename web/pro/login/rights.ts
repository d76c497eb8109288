// Why the account that uses the page may not do something: asked of shared/login/doings.ts, for functions and for components.
import { refusalTo, type Doing } from "../../shared/login/doings";
import { login, useLogin } from "../client";

export const refusalNow = (doing: Doing): string | undefined => refusalTo(login.get().me, doing);

export const useRefusal = (doing: Doing): string | undefined => useLogin(({ me }) => refusalTo(me, doing));
