// Keeping breakpoints on the server: the newest of each document and person, one request at a time.
import { isRefusal } from "../../shared/api";
import type { KeptBreakpoint } from "../../generated/messages";
import { api } from "../client";
import { kept, setKept, type Owner } from "./kept";
import { messageOf } from "../../shared/messageOf";

interface Unsaved {
  readonly of: Owner;
  readonly breakpoints: readonly KeptBreakpoint[];
}

const unsaved = new Map<string, Unsaved>();
let saving = false;

/** Whether what the page has is newer than what the server has. */
export const isSaving = (): boolean => saving || unsaved.size > 0;

function reasonOf(error: unknown): string {
  if (isRefusal(error) && error.status === 404) return "the server does not have the document";
  return messageOf(error);
}

async function saveOne({ of, breakpoints }: Unsaved): Promise<void> {
  let unkept: string | undefined;
  try {
    await api.keepBreakpoints(of.document, of.author, breakpoints);
  } catch (error) {
    unkept = reasonOf(error);
  }
  if (kept().of === of) setKept({ unkept });
}

/** Keeps what the page has now. */
export async function save(): Promise<void> {
  const { of, entries } = kept();
  if (of !== undefined) unsaved.set(`${of.document} ${of.author}`, { of, breakpoints: entries.map(({ breakpoint }) => breakpoint) });
  if (saving) return;
  saving = true;
  for (let [next] = unsaved; next !== undefined; [next] = unsaved) {
    unsaved.delete(next[0]);
    await saveOne(next[1]);
  }
  saving = false;
}
