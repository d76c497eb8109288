// Entry of the page on trust: STOP, the fingerprint of the server's authority, and the steps for the visitor's system.
import "@fontsource-variable/inter";
import "../display/tokens.css";
import "../stop/tokens.css";
import "../stop/stop.css";
import "./trust.css";
import { askAuthority, type Authority } from "../shared/trust/authority";
import { firstSystem, kSystems, systemInHash, type System } from "../shared/trust/system";
import { stoppedText } from "../shared/stop/texts";
import { stop } from "../stop/page";
import { showStop } from "../stop/show";

/** Between two questions to a server that does not answer [ms]. */
const kRetry = 3000;

function part(id: string): HTMLElement {
  const found = document.getElementById(id);
  if (found === null) throw new Error(`the page has no #${id}`);
  return found;
}

/** Says that the cell is stopped. The page has no reset: that is for who has logged in. */
function drawStopped(): void {
  const { stopped } = stop.get();
  part("stopped").hidden = !stopped;
  part("stopped-by").textContent = stopped ? stoppedText(stopped, Date.now()) : "";
}

function show({ kind }: Authority): void {
  for (const id of ["asking", "lost", "none", "there"]) part(id).hidden = id !== kind;
}

/** Each group is a word, so that a line breaks between groups. */
function writeFingerprint(groups: readonly string[]): void {
  const words = groups.map((group) => {
    const word = document.createElement("span");
    word.textContent = group;
    return word;
  });
  part("fingerprint").replaceChildren(...words.flatMap((word, i) => (i === 0 ? [word] : [" ", word])));
}

let again: ReturnType<typeof setTimeout> | undefined;

async function ask(): Promise<void> {
  clearTimeout(again);
  const authority = await askAuthority("/api/v1", (input, init) => fetch(input, init));
  if (authority.kind === "there") writeFingerprint(authority.fingerprint);
  show(authority);
  if (authority.kind === "lost") again = setTimeout(() => void ask(), kRetry);
}

const section = (system: System): HTMLDetailsElement => part(system) as HTMLDetailsElement;

/** One section is open; the address names it once it was chosen. */
function followSections(first: System | undefined): void {
  let open = first;
  for (const system of kSystems) {
    section(system).addEventListener("toggle", () => {
      if (!section(system).open || system === open) return;
      open = system;
      history.replaceState(null, "", `#${system}`);
    });
  }
  addEventListener("hashchange", () => {
    const system = systemInHash(location.hash);
    if (system !== undefined) section(system).open = true;
  });
}

showStop();
stop.listen(drawStopped);
const first = firstSystem(location.hash, navigator);
if (first !== undefined) section(first).open = true;
followSections(first);
part("retry").addEventListener("click", () => void ask());
void ask();
