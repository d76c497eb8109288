// What each error code and fault means, and what to do. A test holds the codes equal to core/value/expected.h, those of requests to the server's, and
// the faults to api/schemas/core.json.
import type { Core } from "../../generated/messages";
import type { Term, Topic } from "./blocks";
import { heading, text } from "./blocks";

type FaultKind = NonNullable<Core["fault"]>["kind"];

/** Code -> what it means and what to do. */
export const errorCodes: Readonly<Record<string, string>> = {
  json: "The text is no JSON. The line and column are those of the first character that does not fit.",
  version: "It was written for another version of the format or of the program. Open it with that version, or write `\"rcm\": 1`.",
  missing: "A field that must be there is not. Add the field that the message names.",
  type: "A value has the wrong kind, such as a text for a number. The message says which kind is wanted.",
  unknown_field: "There is no field of this name. Look for a spelling mistake; what has no place goes into `meta`.",
  name: "It is no name: names begin with a letter or `_` and go on with letters, digits and `_`. Rename it.",
  duplicate: "Two next to each other have the same name. Rename one of them.",
  constant: "A number is too large, or not finite. Write one that a 64-bit number can hold.",
  parameter: "A parameter has both a constant and an expression. Remove one of them.",
  root_from: "A parameter of the root has an expression, but there is nothing above the root. Give it a constant, or nothing: then it is an argument of the run.",
  first: "The state that is to be entered first is not there, or is missing. Choose one of the children as first.",
  port_target: "A port leads to something that is not next to its state. Ports lead to states and barriers of the same level only; to leave the level, use a port of the state around.",
  barrier_target: "A barrier leads to something that is no state of its level. Lead it to states next to it.",
  link_unknown: "A state links a library state that is not there. Choose another one, or put it into the library.",
  link_cycle: "Library states link each other in a circle, so they would be endless. Take one of the links out.",
  link_field: "A linked state has functions or children of its own. It can have parameters and ports only; the rest is in the library state.",
  link_parameter: "A linked state has a parameter that its library state does not have. Remove it, or add it there.",
  link_port: "A linked state has a port that its library state does not have. Remove it, or add it there.",
  oracle: "An oracle misses what it needs: children, a first one, or a call to ask. The message says what.",
  after: "A time-out stands where it cannot: beside a condition, or on a port of a linked state. Keep one of the two.",
  reference: "The model of a service names something that it does not have.",
  keep: "`keep` names a port that is not there, or a change would lose what a state keeps. Correct the name, or take `keep` away first.",
  syntax: "The code cannot be read at the marked place. Often a bracket, a colon or a quote is missing.",
  forbidden: "The language does not have this: see The language. Imports, own functions, classes and exceptions are not part of it.",
  scope: "It cannot be seen from here. A state sees itself, its children and services; a parameter's expression sees the state around.",
  effect: "A condition or expression would change something. Do that in a function.",
  service_call: "An operation is called inside an expression. Call it in a statement of its own, and read its result in a condition.",
  unknown_name: "There is nothing of this name here. Declare it, or look for a spelling mistake; completion (Ctrl+Space) offers what there is.",
  too_large: "It is larger, or there are more, than the server takes; the message says how many. Make it smaller, split it, or remove what is not needed.",
  too_deep: "It is nested too deeply. Move inner states up, or into the library.",
  out_of_range: "A number or position is not within its limits; the message says which.",
  not_found: "There is nothing of this name or number, or not any more. Load the list again.",
  conflict: "Somebody else has changed it meanwhile, or it is not in the state for this. Look at how it is now, then do it again.",
  io: "A file or device could not be read or written. Look at the log of the server.",
  unavailable: "It is not there now: a service without its process, or a server that is busy. Start it, or try again.",
  not_accepted: "The service does not accept this call in its present state. See the page Services; lead the task through a state in which it does.",
  storage: "The disk of the server is full or fails. Nothing was changed. Make room, then try again; runs wait as interrupted.",
  corrupt: "What is stored is damaged. Take it from a backup, or remove it; the rest is not concerned.",
  rights: "Your account may not do that (status 403); the message names the role that may. An admin can give it another role: see Accounts and roles.",
  stopped: "The cell is stopped: nothing there moves, and no run begins. Make sure that nobody is in danger, then reset it.",
  leased: "Somebody has it: another run the service until it is over, or a person the controls of the cell. Wait for that, stop that run, or ask for the controls.",
};

/** The same for codes that only requests have: they say what is wrong with the request, not with what it asks for. */
export const requestCodes: Readonly<Record<string, string>> = {
  login: "The server knows nobody by this name and password, or by this token (status 401). Log in; a program needs a token in `RACE_TOKEN`, see Logging in.",
  attempts: "Too many logins have failed (status 429). Wait as long as the message says, then try again.",
  pairing: "The code that lets a phone in is wrong, was used, or is older than a minute (status 401). Show a new one where it was shown.",
  too_many: "As many of these wait as your account may have, or all accounts together (status 429). A code for a phone is good for a minute, and a call waits for five seconds at most: try again then.",
  no_accounts: "This server has no accounts, so no phone needs a code (status 409): the address is all.",
  password: "The old password is another one (status 403). Who has forgotten it asks an admin for a new one.",
  origin: "A page of another site has asked (status 403). Only pages of this server may: open them from it.",
  tls: "The address is served over TLS: write `https://` before it, not `http://`.",
  host: "The server was asked under a name that it does not answer to. Use an address that it has printed when it started.",
  overload: "The server has more to do than it can (status 503). Try again in a moment.",
  out_of_memory: "The server has no memory left for this. Make it smaller, or end other runs.",
  internal: "The server has failed to answer. Look at its log; the run is not concerned.",
  method: "The route is there, but not for this. The message says what it has.",
  upgrade: "Here a WebSocket is served, not a request.",
  content_type: "The body must be JSON, and say so: `Content-Type: application/json`.",
  content_length: "The length of the body is not said, or not as a number.",
  transfer_encoding: "The body is sent in pieces, which the server does not take. Send `Content-Length`.",
  not_acceptable: "The client accepts no encoding in which the server has this file.",
  http: "The request is no HTTP that the server understands.",
};

export const faultKinds: Readonly<Record<FaultKind, string>> = {
  type: "A value has the wrong kind for what is done with it, such as a text that is added to a number.",
  missing: "A key of a dict or an item of a list is not there. Test it with `in` or `len` before.",
  zero_division: "A division by zero. Test the divisor before.",
  overflow: "A whole number is too large for 64 bit.",
  budget: "A function, a macro step or the data of the run is larger than it may be. Look for a loop that goes on for too long, or for a list that grows.",
  value: "A value is not one that a function takes, such as the root of a negative number.",
  name: "A name has no value yet at this place of the function.",
  unmet: "An entry or exit function uses something that is unknown. Wait for it with a port before, or ask `available(x)`.",
  unresolved: "A parameter has no value when its state is entered. Give it one, or make sure that what it is made of is known.",
  divergence: "More than 10 000 micro steps in one macro step: ports fire in a circle. Make one of their conditions depend on something that has to happen.",
};

const termsOf = (table: Readonly<Record<string, string>>, prefix: string): readonly Term[] => Object.entries(table).map(([name, words]) => ({ name, text: words, id: `${prefix}-${name}` }));

export const errorTopics: readonly Topic[] = [
  { id: "errors", title: "Error codes", group: "Reference", blocks: [text("Everything that is refused says where, a code, and why. What to do:"), { kind: "terms", terms: termsOf(errorCodes, "error") }, heading("Of requests"), { kind: "terms", terms: termsOf(requestCodes, "error") }] },
  { id: "fault-kinds", title: "Kinds of faults", group: "Reference", blocks: [text("Why a run has faulted, and what to do:"), { kind: "terms", terms: termsOf(faultKinds, "fault") }] },
];

/** The topic, and the place in it, that explains an error code; nothing: the code is not known. */
export const placeOfCode = (name: string): { readonly topic: string; readonly term: string } | undefined => (Object.hasOwn(errorCodes, name) || Object.hasOwn(requestCodes, name) ? { topic: "errors", term: `error-${name}` } : undefined);
