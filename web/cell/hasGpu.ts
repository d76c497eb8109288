// Whether the browser draws by a graphics processor. Without one, drawing takes the time of the page itself.

/** How drawing by software is called: of Chromium, of Mesa, of Windows. */
const kSoftware = /SwiftShader|llvmpipe|softpipe|Software|Basic Render/i;

let known: boolean | undefined;

export function hasGpu(): boolean {
  if (known !== undefined) return known;
  const context = document.createElement("canvas").getContext("webgl2", { failIfMajorPerformanceCaveat: true });
  const about = context?.getExtension("WEBGL_debug_renderer_info");
  const name: unknown = about && context?.getParameter(about.UNMASKED_RENDERER_WEBGL);
  context?.getExtension("WEBGL_lose_context")?.loseContext();
  known = context !== null && !(typeof name === "string" && kSoftware.test(name));
  return known;
}
