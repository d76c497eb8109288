// Which requests tell the server that the page has the controls.

const kNeed: readonly { readonly method: string; readonly path: RegExp }[] = [
  { method: "POST", path: /\/api\/v1\/cores\/[^/]+\/(?:start|resume|step|force|confirm_edit)$/ },
  { method: "POST", path: /\/api\/v1\/cell\/reset$/ },
  { method: "PUT", path: /\/api\/v1\/control\/mode$/ },
  { method: "POST", path: /\/api\/v1\/services\/[^/]+\/calls$/ },
];

export const kControlHeader = "race-control";

/** A fetch that says so where it matters; `secret`: of the controls, while they are had. */
export const withControls =
  (fetcher: typeof fetch, secret: () => string | undefined): typeof fetch =>
  (input, init) => {
    const held = typeof input === "string" && kNeed.some(({ method, path }) => method === init?.method && path.test(input)) ? secret() : undefined;
    if (held === undefined) return fetcher(input, init);
    const headers = new Headers(init?.headers);
    headers.set(kControlHeader, held);
    return fetcher(input, { ...init, headers });
  };
