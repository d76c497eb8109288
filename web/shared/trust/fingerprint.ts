// The fingerprint of the authority, in groups that two people can compare.

/** Pairs of digits that are read together. */
const kGroup = 4;

/** "AB:CD:..." as its groups ("AB:CD:EF:01"); nothing: it is no SHA-256. */
export function fingerprintGroups(text: string | null): readonly string[] | undefined {
  const pairs = text?.trim().toUpperCase().split(":") ?? [];
  if (pairs.length !== 32 || !pairs.every((pair) => /^[0-9A-F]{2}$/.test(pair))) return undefined;
  return Array.from({ length: pairs.length / kGroup }, (_, i) => pairs.slice(i * kGroup, (i + 1) * kGroup).join(":"));
}
