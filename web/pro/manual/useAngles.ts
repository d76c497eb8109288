// The angles of the joints, written as they are told: many times a second, so past React.
import { useCallback, useEffect, useRef } from "react";
import { angleText, armAngles } from "../../shared/control/jog";
import { cellPose } from "../client";

/** What gets the element of each joint, by its number from 0. */
export function useAngles(): (joint: number, element: HTMLElement | null) => void {
  const shown = useRef(new Map<number, HTMLElement>());
  useEffect(() => {
    const elements = shown.current;
    const write = () => {
      const angles = armAngles(cellPose.get()?.joints ?? {});
      for (const [joint, element] of elements) element.textContent = angleText(angles[joint]);
    };
    write();
    return cellPose.listen(write);
  }, []);
  return useCallback((joint, element) => {
    if (element === null) shown.current.delete(joint);
    else shown.current.set(joint, element);
  }, []);
}
