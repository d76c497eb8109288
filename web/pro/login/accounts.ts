// The accounts of the server, for admins: shown, made, changed and removed.
import type { Account } from "../../generated/messages";
import type { PersonRole } from "../../shared/login/roles";
import { api } from "../client";
import { createStore, useSelected } from "../../page/store";

interface Shown {
  readonly shown: boolean;
  readonly accounts: readonly Account[];
}

const list = createStore<Shown, Partial<Shown>>({ shown: false, accounts: [] }, (now, next) => ({ ...now, ...next }));
export const useAccounts = <T>(select: (shown: Shown) => T): T => useSelected(list, select);

export const showAccounts = (shown: boolean): void => list.dispatch({ shown });

export async function loadAccounts(): Promise<void> {
  list.dispatch({ accounts: await api.accounts() });
}

export async function addAccount(name: string, role: PersonRole, password: string): Promise<void> {
  await api.addAccount({ name, role, password });
  await loadAccounts();
}

export async function setRole(name: string, role: PersonRole): Promise<void> {
  await api.changeAccount(name, { role });
  await loadAccounts();
}

export async function removeAccount(name: string): Promise<void> {
  await api.removeAccount(name);
  await loadAccounts();
}
