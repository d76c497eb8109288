// What a picture of a QR code says.
import jsQR from "jsqr";
import type { Page } from "playwright-core";

/** `png`: a screenshot; `page` unpacks it. */
export async function readCode(page: Page, png: Buffer): Promise<string | undefined> {
  const { width, height, pixels } = await page.evaluate(async (source) => {
    const image = new Image();
    image.src = source;
    await image.decode();
    const canvas = document.createElement("canvas");
    Object.assign(canvas, { width: image.width, height: image.height });
    const context = canvas.getContext("2d");
    context?.drawImage(image, 0, 0);
    return { width: image.width, height: image.height, pixels: [...(context?.getImageData(0, 0, image.width, image.height).data ?? [])] };
  }, `data:image/png;base64,${png.toString("base64")}`);
  return jsQR(Uint8ClampedArray.from(pixels), width, height)?.data;
}
