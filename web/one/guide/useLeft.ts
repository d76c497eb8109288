// Who leaves the guide is led to the heading of what is shown then: the button that was pressed is gone.
import { useEffect, useRef } from "react";
import { focusPart } from "../../page/keepFocus";

export function useLeft(isGuided: boolean): void {
  const was = useRef(isGuided);
  useEffect(() => {
    const heading = was.current && !isGuided ? document.querySelector<HTMLElement>("main :is(h1, h2)") : null;
    was.current = isGuided;
    if (heading !== null) focusPart(heading);
  }, [isGuided]);
}
