// Where a page leads a person whose device does not trust the server yet: nowhere, unless the page came over TLS.
export const kTrustPage = "/trust/";

export const trustAddress = ({ protocol }: Pick<Location, "protocol">): string | undefined => (protocol === "https:" ? kTrustPage : undefined);
