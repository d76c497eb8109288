// Where a stop is served: on its own port, if it is known, and beside everything else.
import type { Control } from "../../generated/messages";

export const kStopPath = "/api/v1/stop";

export type Place = Pick<Location, "protocol" | "hostname" | "port">;

const portOf = ({ protocol, port }: Place): number => (port !== "" ? Number(port) : protocol === "https:" ? 443 : 80);

/** Of the server that a page came from: its own port first. At an IPv6 address a page may send to that alone which it came from. */
export function stopAddresses(place: Place, ports: Control["stop_ports"]): readonly string[] {
  const own = place.hostname.startsWith("[") ? undefined : ports.find(({ port }) => port === portOf(place));
  return own === undefined ? [kStopPath] : [`${place.protocol}//${place.hostname}:${own.stop_port}${kStopPath}`, kStopPath];
}
