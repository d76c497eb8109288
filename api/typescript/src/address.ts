// Where a server is.

/** Whether a host name is this machine's own. */
const isOwnMachine = (host: string): boolean => host === "localhost" || host.endsWith(".localhost") || host === "[::1]" || /^127\.\d+\.\d+\.\d+$/.test(host);

/**
 * `http://HOST:PORT` or `https://HOST:PORT`, as all requests begin. Throws a TypeError: it is none, or http to another machine. A server
 * of RACE speaks http on its own machine alone; to send a token further would show it to the network.
 */
export function originOf(address: string): string {
  const url = new URL(address);
  const further = url.username + url.password + url.pathname.slice(1) + url.search + url.hash;
  if ((url.protocol !== "http:" && url.protocol !== "https:") || further !== "") throw new TypeError(`\`${address}\` is no http://HOST:PORT or https://HOST:PORT`);
  if (url.protocol === "http:" && !isOwnMachine(url.hostname)) throw new TypeError(`\`${address}\`: another machine is reached by https alone`);
  return url.origin;
}

/** The token, which goes into a header. Throws a TypeError: it has other characters than a token (RFC 6750). */
export function checkedToken(token: string): string {
  if (!/^[A-Za-z0-9._~+/-]+=*$/.test(token)) throw new TypeError("the token has characters that no token has");
  return token;
}
