// Finds things in the 3D view by moving the pointer.
import type { Page } from "playwright-core";

export interface Place {
  readonly x: number;
  readonly y: number;
}

/** Where to look in the view, as shares of its width and height. */
export type Region = readonly [left: number, right: number, top: number, bottom: number];

export const view = (page: Page) => page.getByLabel("3D view of the cell").first();

/** A position [px] in a region of the view at which the pointer would grab something `wanted`, by the title of the view. Pulling must be on. */
export async function find(page: Page, wanted: RegExp, [left, right, top, bottom]: Region): Promise<Place> {
  const box = await view(page).boundingBox();
  if (box === null) throw new Error("the view has no size");
  const kPitch = 5; // px
  for (let y = box.y + top * box.height; y < box.y + bottom * box.height; y += kPitch)
    for (let x = box.x + left * box.width; x < box.x + right * box.width; x += kPitch) {
      await page.mouse.move(x, y);
      if (wanted.test((await view(page).getAttribute("title")) ?? "")) return { x, y };
    }
  throw new Error(`${wanted} is nowhere`);
}
