// What the roles of accounts may do, by the server's own table.
import rights from "../../../api/rights.json";
import type { Me } from "../../generated/messages";

/** Each may do what those before it may. */
export const kRoles = ["observer", "operator", "developer", "admin"] as const;
export type PersonRole = (typeof kRoles)[number];

/** What each role is for, as the page says it. */
export const kRoleTexts: Readonly<Record<PersonRole, string>> = {
  observer: "sees everything, changes nothing",
  operator: "also starts, pauses and stops runs, answers them, and acts at the cell",
  developer: "also edits documents, steps, forces values, and imports and deletes runs",
  admin: "also manages accounts, backups, and what starts with the server",
};

const placeOf = (role: string): number => kRoles.findIndex((each) => each === role);

/** Whether a role may do what needs `right`, a word of the table; without one: nobody is known to ask. */
export function mayUse(role: string | undefined, right: string): boolean {
  if (right === "anyone") return true;
  return role !== undefined && placeOf(right) >= 0 && placeOf(role) >= placeOf(right);
}

type Route = keyof typeof rights.routes;

/** Why a person may not do what needs `right`; nothing: they may, or it is not known yet who it is. */
export function refusalOfRight(me: Me | undefined, right: string): string | undefined {
  if (me === undefined || mayUse(me.role, right)) return undefined;
  return `this needs the role ${right}, and ${me.role === undefined ? "nobody is logged in" : `your account has the role ${me.role}`}`;
}

/** The same for a route. */
export const refusalOf = (me: Me | undefined, route: Route): string | undefined => refusalOfRight(me, rights.routes[route]);
