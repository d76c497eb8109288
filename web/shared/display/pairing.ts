// How a phone comes to show a display page: its address; where the page came over a network, what the phone has to trust; and where it came
// from this machine, how a network is served, or the tunnel that leads there.
import { isRefusal } from "../../../api/typescript/src/errors";
import { kTrustPage } from "../trust/trustAddress";
import { nameOf } from "./page";

/** Of the page, as `location` has it. */
export interface PageAddress {
  readonly protocol: string;
  readonly hostname: string;
  readonly port: string;
}

export interface Pairing {
  /** Of the display page, as the phone opens it. */
  readonly address: string;
  /** Of the page by which the phone comes to trust the server; nothing: it has nothing to trust. */
  readonly trust?: string;
  /** Commands, one of which makes that address reach the server; nothing: the phone reaches it as it is. */
  readonly tunnel?: { readonly usb: string; readonly ssh: string };
}

const kLoopback: ReadonlySet<string> = new Set(["localhost", "127.0.0.1", "[::1]"]);

/** Whether a display can have this name. */
export const isDisplayName = (name: string): boolean => nameOf(`?name=${encodeURIComponent(name)}`) === name;

/** The display that a phone becomes. */
export interface PairedDisplay {
  /** As isDisplayName() takes it. */
  readonly name: string;
  /** Where it stands, a name as well; nothing: nowhere in particular. */
  readonly place?: string;
  /** By which the server lets it in. */
  readonly code?: string;
}

const kCode = /^#code=([A-Za-z0-9_-]{22})$/;

/** The code of a pairing in the fragment of an address, which no server is told. */
export const codeOf = (hash: string): string | undefined => kCode.exec(hash)?.[1];

/** Why a phone is not paired, and what to do then. */
export function notPairedText(error: unknown): string {
  const renew = "press “New code” on the page that shows it, and scan that code within a minute";
  if (!isRefusal(error)) return `This phone is not paired: the server does not answer. Connect the phone to the network of the server, ${renew}.`;
  if (error.retryAfter !== undefined) return `This phone is not paired: too many codes were tried. Wait ${error.retryAfter} s, then ${renew}.`;
  const why = error.code === "pairing" ? "the code was used already, or it is too old" : error.message;
  return `This phone is not paired: ${why}. ${renew.charAt(0).toUpperCase()}${renew.slice(1)}.`;
}

/** The address of the display page below `origin`. */
export const displayAddress = (origin: string, { name, place, code }: PairedDisplay): string =>
  `${origin}/display/?name=${name}${place === undefined ? "" : `&place=${place}`}${code === undefined ? "" : `#code=${code}`}`;

/** Of the addresses at which networks reach the server, those of which a person chooses one; none: there is no choice, or the phone takes the way of the page. */
export const networkChoice = ({ hostname }: PageAddress, addresses: readonly string[]): readonly string[] => (kLoopback.has(hostname) && addresses.length > 1 ? addresses : []);

/** `network`: where the network reaches the server, if the page came from this machine. Through a tunnel the phone has the server at its own `localhost`, at the same port: the server accepts no other. */
export function pairing({ protocol, hostname, port }: PageAddress, shown: PairedDisplay, network?: string): Pairing {
  const isLocal = kLoopback.has(hostname);
  if (isLocal && network !== undefined) return { address: displayAddress(network, shown), trust: `${network}${kTrustPage}` };
  const at = `${isLocal ? "localhost" : hostname}${port === "" ? "" : `:${port}`}`;
  const address = displayAddress(`${protocol}//${at}`, shown);
  const real = port === "" ? (protocol === "https:" ? "443" : "80") : port;
  if (isLocal) return { address, tunnel: { usb: `adb reverse tcp:${real} tcp:${real}`, ssh: `ssh -L ${real}:127.0.0.1:${real} USER@THIS_MACHINE` } };
  return protocol === "https:" ? { address, trust: `${protocol}//${at}${kTrustPage}` } : { address };
}
