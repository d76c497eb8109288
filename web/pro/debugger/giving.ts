// Giving breakpoints to cores, which may have those of others, too. Requests go one after the other.
import { isRefusal } from "../../shared/api";
import { breakpointKey, refusedOne, sameBreakpoints, setBy } from "../../shared/debugger/onCore";
import type { Breakpoint, Core } from "../../generated/messages";
import { api, session } from "../client";
import { kept, setKept } from "./kept";

/** What was sent last, of which the stream may not have told yet. */
let last: { readonly id: string; readonly author: string; readonly breakpoints: readonly Breakpoint[] } | undefined;

/** Whether the core has these of a person, as far as this page can know. */
function has(core: Core, author: string, breakpoints: readonly Breakpoint[]): boolean {
  const now = session.get().cores.find(({ id }) => id === core.id) ?? core;
  const sent = last?.id === core.id && last.author === author ? last.breakpoints : breakpoints;
  return sameBreakpoints(setBy(now, author), breakpoints) && sameBreakpoints(sent, breakpoints);
}

/** What the core does not take is left out, with the reason. */
async function send(core: Core, author: string, wanted: readonly Breakpoint[]): Promise<void> {
  const refused = new Map(kept().refused);
  let list = wanted;
  for (let done = has(core, author, list); !done; ) {
    try {
      await api.setBreakpoints(core.id, author, list);
      last = { id: core.id, author, breakpoints: list };
      done = true;
    } catch (error) {
      const found = isRefusal(error) ? refusedOne(error.errors) : undefined;
      const one = found && list[found.index];
      if (found === undefined || one === undefined) throw error;
      refused.set(breakpointKey(one), found.message);
      list = list.filter((each) => each !== one);
    }
  }
  list.forEach((each) => refused.delete(breakpointKey(each)));
  setKept({ refused });
}

let line: Promise<void> = Promise.resolve();

/** Gives a core the breakpoints of a person, in place of those that they have set there. */
export function give(core: Core, author: string, breakpoints: readonly Breakpoint[]): Promise<void> {
  const done = line.then(() => send(core, author, breakpoints));
  line = done.catch(() => undefined);
  return done;
}
