// Giving breakpoints to cores, which may have those of others, too. Requests go one after the other: each is made of what the core has then.
import { RefusedError } from "../../shared/api";
import { breakpointKey, refusedOne, sameBreakpoints } from "../../shared/debugger/onCore";
import type { Breakpoint, Core } from "../../generated/messages";
import { api, session } from "../client";
import { kept, setKept } from "./kept";

/** What a core is to have, of what it has. */
type Wanted = (has: readonly Breakpoint[]) => readonly Breakpoint[];

/** What was sent last, until the stream has told of it. */
let last: { readonly id: string; readonly before: readonly Breakpoint[]; readonly after: readonly Breakpoint[] } | undefined;

function breakpointsOf(core: Core): readonly Breakpoint[] {
  const { id, breakpoints } = session.get().cores.find((each) => each.id === core.id) ?? core;
  return last?.id === id && sameBreakpoints(last.before, breakpoints) ? last.after : breakpoints;
}

/** What the core does not take is left out, with the reason. */
async function send(core: Core, wanted: Wanted): Promise<void> {
  const has = breakpointsOf(core);
  const refused = new Map(kept().refused);
  let list = wanted(has);
  for (let done = sameBreakpoints(list, has); !done; ) {
    try {
      await api.setBreakpoints(core.id, list);
      last = { id: core.id, before: has, after: list };
      done = true;
    } catch (error) {
      const found = error instanceof RefusedError ? refusedOne(error.errors) : undefined;
      const one = found && list[found.index];
      if (found === undefined || one === undefined) throw error;
      refused.set(breakpointKey(one), found.message);
      list = list.filter((each) => each !== one);
      done = sameBreakpoints(list, has);
    }
  }
  list.forEach((each) => refused.delete(breakpointKey(each)));
  setKept({ refused });
}

let line: Promise<void> = Promise.resolve();

export function give(core: Core, wanted: Wanted): Promise<void> {
  const done = line.then(() => send(core, wanted));
  line = done.catch(() => undefined);
  return done;
}
