// "Why?" at an action or a parameter of the state that is selected: a button, and the answer below it while it is asked.
import { useEffect, useRef } from "react";
import { isSameAsked, type Asked } from "../../shared/run/subject";
import { useCore, useView, view } from "../client";
import { AskWhy } from "./AskWhy";

/** `name`: of what, for those who do not see the row. */
export function WhyButton({ asked, name }: { readonly asked: Asked; readonly name: string }) {
  const isOpen = useView((v) => isSameAsked(v.asked, asked));
  const isThere = useCore() !== undefined;
  if (!isThere) return null;
  return (
    <button type="button" className="link why-button" aria-expanded={isOpen} aria-label={`Why ${name}`} onClick={() => view.dispatch({ type: "ask", asked: isOpen ? undefined : asked })}>
      Why?
    </button>
  );
}

/** The answer about an action or a parameter of the state at `path`, if that is asked. */
export function WhyAnswer({ path, asked }: { readonly path: string; readonly asked: Asked }) {
  const isOpen = useView((v) => isSameAsked(v.asked, asked));
  return isOpen ? <Answer path={path} asked={asked} /> : null;
}

function Answer({ path, asked }: { readonly path: string; readonly asked: Asked }) {
  const place = useRef<HTMLDivElement>(null);
  // Once the answer is there, as it stands below what was clicked.
  useEffect(() => {
    const shown = place.current;
    if (shown === null) return;
    const arrival = new ResizeObserver(() => {
      if (shown.offsetHeight === 0) return;
      arrival.disconnect();
      shown.scrollIntoView({ block: "nearest" });
    });
    arrival.observe(shown);
    return () => arrival.disconnect();
  }, []);
  return (
    <div ref={place}>
      <AskWhy subject={{ state: path, ...asked }} />
    </div>
  );
}
