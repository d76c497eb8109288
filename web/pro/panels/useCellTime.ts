// The time of the cell, read some times a second while something depends on it.
import { useEffect, useState } from "react";
import { cellPose } from "../client";

export function useCellTime(wanted: boolean): number | undefined {
  const [time, setTime] = useState<number>();
  useEffect(() => {
    if (!wanted) return;
    const read = () => setTime(cellPose.get()?.time);
    read();
    const timer = setInterval(read, 300);
    return () => clearInterval(timer);
  }, [wanted]);
  return time;
}
