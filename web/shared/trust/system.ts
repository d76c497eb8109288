// Which system a visitor has, and which section of the page on trust is open: that of the address, else that of the visitor.

/** Each has a section of the page, by this id. */
export const kSystems = ["android", "apple", "windows", "macos", "linux"] as const;
export type System = (typeof kSystems)[number];

/** Of a browser, as `navigator` has it. */
export interface Visitor {
  readonly userAgent: string;
  readonly maxTouchPoints: number;
}

/** Nothing: it is not known. An iPad calls itself a Mac, but a Mac has no touch screen. */
export function systemOf({ userAgent, maxTouchPoints }: Visitor): System | undefined {
  if (/android/i.test(userAgent)) return "android";
  if (/iphone|ipad|ipod/i.test(userAgent)) return "apple";
  if (/windows/i.test(userAgent)) return "windows";
  if (/macintosh|mac os x/i.test(userAgent)) return maxTouchPoints > 1 ? "apple" : "macos";
  return /linux|cros|x11/i.test(userAgent) ? "linux" : undefined;
}

/** The system that the address names (`#windows`). */
export const systemInHash = (hash: string): System | undefined => kSystems.find((system) => hash === `#${system}`);

/** The section that is open first. */
export const firstSystem = (hash: string, visitor: Visitor): System | undefined => systemInHash(hash) ?? systemOf(visitor);
