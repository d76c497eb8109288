// What happens in the pages of a context that no text of anybody may bring about: a script that runs, a request to another host, an address that
// is a script, markup made of a text. Scripts of texts are those of scriptPayloads.ts.
import type { BrowserContext, Frame } from "playwright-core";
import { kClobbered, kEvil } from "./scriptPayloads";

export interface ScriptWatch {
  /** What has been found since the last call. */
  readonly found: () => readonly string[];
}

const kBinding = "reportFinding";

/** In each page and frame, before its own scripts. */
function watchPage([binding, evil, clobbered]: readonly [string, string, string]): void {
  const reported = new Set<string>();
  const report = (what: string): void => {
    const send = Reflect.get(window, binding) as (text: string) => unknown;
    const text = `${what} (${location.href.slice(0, 200)})`;
    if (reported.has(text)) return;
    reported.add(text);
    send(text);
  };
  for (const name of ["alert", "confirm", "prompt", "print"]) Reflect.set(window, name, () => report(`ran: ${name}`));
  document.addEventListener("securitypolicyviolation", (event) => report(`refused by the policy: ${event.violatedDirective} ${event.blockedURI}`));

  const isHostile = (text: unknown): boolean => typeof text === "string" && text.includes("<") && (text.includes("alert") || text.includes(evil) || text.includes(clobbered));
  /** Reports what `name` of an object is given or called with, if that is a text of an attacker. */
  const watchSink = (of: object, name: string): void => {
    const own = Object.getOwnPropertyDescriptor(of, name);
    if (own === undefined) return;
    const told = (text: unknown) => isHostile(text) && report(`markup: ${name} of ${String(text).slice(0, 80)}`);
    const value: unknown = own.value;
    const setter: unknown = Reflect.get(own, "set");
    if (typeof setter === "function") {
      const setTold = function (this: unknown, text: unknown) {
        told(text);
        Reflect.apply(setter as (text: unknown) => void, this, [text]);
      };
      Object.defineProperty(of, name, { ...own, set: setTold });
    } else if (typeof value === "function") {
      const callTold = function (this: unknown, ...all: readonly unknown[]): unknown {
        all.forEach(told);
        return Reflect.apply(value as (...all: readonly unknown[]) => unknown, this, all);
      };
      Object.defineProperty(of, name, { ...own, value: callTold });
    }
  };
  for (const name of ["innerHTML", "outerHTML", "insertAdjacentHTML", "setHTMLUnsafe"]) watchSink(Element.prototype, name);
  watchSink(ShadowRoot.prototype, "innerHTML");
  watchSink(Range.prototype, "createContextualFragment");
  watchSink(DOMParser.prototype, "parseFromString");
  watchSink(HTMLIFrameElement.prototype, "srcdoc");
  for (const name of ["write", "writeln"]) watchSink(Document.prototype, name);

  const foreign = new Set(["iframe", "frame", "frameset", "object", "embed", "base", "portal", "applet", "marquee", "math", "foreignobject", "template", "plaintext", "xmp", "style"]);
  const addresses = new Set(["href", "xlink:href", "src", "srcset", "srcdoc", "action", "formaction", "ping", "data", "poster", "background", "manifest"]);
  const isOwn = (value: string, tag: string): boolean => {
    if (!URL.canParse(value, location.href)) return false;
    const { protocol, origin } = new URL(value, location.href);
    return origin === location.origin || (protocol === "data:" && tag === "img") || (protocol === "blob:" && value.startsWith(`blob:${location.origin}/`));
  };
  const lookAt = (element: Element): void => {
    const tag = element.localName.toLowerCase();
    const tell = (what: string) => report(`${what} in ${element.outerHTML.slice(0, 120)}`);
    // A drawing that was saved has its style with it.
    if (foreign.has(tag) && !(tag === "style" && document instanceof XMLDocument)) tell(`element ${tag}`);
    if (tag === "script" && element.textContent !== "") tell("a script of a text");
    if (tag === "meta" && element.getAttribute("http-equiv")?.toLowerCase() === "refresh" && element.getAttribute("content") !== "0; url=/pro/") tell("a refresh");
    for (const { name, value } of element.attributes) {
      if (/^on/i.test(name)) tell(`handler ${name}`);
      else if (addresses.has(name.toLowerCase()) && !isOwn(value, tag)) tell(`address ${name}`);
      else if (/javascript:|expression\s*\(|url\(\s*["']?(?!["']?(#|data:image|blob:))/i.test(name === "style" || element instanceof SVGElement && name !== "aria-label" ? value : "")) tell(`style ${name}`);
      else if ((name === "id" || name === "name") && value === clobbered) tell(`name ${name}`);
    }
  };
  const lookInto = (node: Node): void => {
    if (!(node instanceof Element)) return;
    lookAt(node);
    node.querySelectorAll("*").forEach(lookAt);
  };
  new MutationObserver((changes) => {
    for (const change of changes) {
      change.addedNodes.forEach(lookInto);
      if (change.type === "attributes" && change.target instanceof Element) lookAt(change.target);
    }
    if (Reflect.get(Object.prototype, clobbered) !== undefined || Reflect.get(window, clobbered) !== undefined) report("clobbered");
  }).observe(document, { subtree: true, childList: true, attributes: true });
}

/** The name of a frame, or of the nearest around it that has one. */
const nameOf = (frame: Frame | null): string => (frame === null ? "" : frame.name() === "" ? nameOf(frame.parentFrame()) : `${frame.name()}: `);

/** `url`: of the server, the only host that pages may ask. */
export async function watchScripts(context: BrowserContext, url: string): Promise<ScriptWatch> {
  const { host } = new URL(url);
  const found: string[] = [];
  await context.exposeBinding(kBinding, ({ frame }, text: string) => void found.push(`${nameOf(frame)}${text}`));
  await context.addInitScript(watchPage, [kBinding, kEvil, kClobbered] as const);
  context.on("dialog", (dialog) => {
    found.push(`dialog: ${dialog.type()} ${dialog.message()}`);
    void dialog.dismiss();
  });
  const ask = (address: string, from = "") => {
    const { protocol, host: asked } = new URL(address);
    if (asked !== host && !(["data:", "blob:", "about:"].includes(protocol) && !address.startsWith("data:text/"))) found.push(`${from}request: ${address.slice(0, 200)}`);
  };
  context.on("request", (request) => ask(request.url(), request.isNavigationRequest() || request.serviceWorker() !== null ? "" : nameOf(request.frame())));
  context.on("page", (page) => page.on("websocket", (socket) => ask(socket.url())));
  return { found: () => found.splice(0) };
}

/** What stays of a text wherever it is quoted, escaped or broken into lines. */
const bare = (text: string): string => text.replace(/[^A-Za-z0-9<>]/g, "");

/** How many of the texts the page shows now: as text, in a field, as a title or name, over all its elements. */
export async function shownOf(texts: readonly string[], context: BrowserContext): Promise<ReadonlySet<string>> {
  const all = await Promise.all(
    context.pages().map((page) =>
      page.evaluate(() => {
        const parts: string[] = [document.title];
        const walker = document.createTreeWalker(document, NodeFilter.SHOW_ELEMENT);
        for (let node = walker.nextNode(); node !== null; node = walker.nextNode()) {
          if (!(node instanceof Element)) continue;
          if (node.childElementCount === 0) parts.push(node.textContent);
          for (const { value } of node.attributes) parts.push(value);
          if (node instanceof HTMLInputElement || node instanceof HTMLTextAreaElement) parts.push(node.value);
        }
        parts.push(document.body.textContent);
        return parts.join("\n");
      }),
    ),
  );
  const there = bare(all.join("\n"));
  return new Set(texts.filter((text) => there.includes(bare(text))));
}
