// Exports a stored run as an MCAP file of the user. Loaded when the first one is exported.
import { exportRun, type CellRobot } from "../../shared/mcap/exportRun";
import { loadWorld } from "../cell/useWorld";
import { api } from "../client";
import { saveBlob } from "../saveText";
import { readUrdf } from "./readUrdf";

async function loadRobots(): Promise<readonly CellRobot[]> {
  const { robots } = await loadWorld();
  return robots.map(({ name, pose, text }) => ({ robot: { base: pose, ...readUrdf(text) }, file: `${name}.urdf`, text }));
}

/** Saves the file, and gives what is missing in it. Throws what the server refuses. */
export async function exportMcap(id: string, signal: AbortSignal, told: (part: number) => void): Promise<readonly string[]> {
  const { file, notes } = await exportRun(api, id, { signal, told, loadRobots });
  signal.throwIfAborted();
  saveBlob(`run-${id}.mcap`, file);
  return notes;
}
