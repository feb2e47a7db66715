// A lumpy body on an axle: where the axle is true, that it stays there, and that it wobbles elsewhere.
import { read } from "../drawn.flat.mjs";
import { set, shown } from "./controls.mjs";
import { finger } from "./hands.mjs";
import { dot, near, size, unit } from "./space.mjs";

const shows = (page, widget) => page.locator(`#live-${widget} canvas`).evaluate((canvas) => canvas.shows);
const DEGREES = 180 / Math.PI;

export async function axle(page, wants) {
  const wobble = async (steps) => {
    for (let i = 0; i < steps; i += 1) await page.click("#axle-play");
    return read(await shown(page, "axle", "wobble"));
  };
  const first = await shows(page, "axle");
  const gap = read(await shown(page, "axle", "gap"));
  wants(`off its axes the momentum leans by ${gap}°`, gap > 15 && near(Math.acos(dot(unit(first.up), unit(first.spin))) * DEGREES, gap, 0.06));
  wants("let go, the axle wobbles", (await wobble(12)) > 20);
  const later = await shows(page, "axle");
  wants("the momentum stands, and the spin has moved", near(dot(first.up, later.up), 1, 1e-12) && dot(unit(first.spin), unit(later.spin)) < 0.999);
  wants("the energy is kept: the spin leans on the momentum as before", near(dot(first.spin, first.up), dot(later.spin, later.up), 1e-9) && near(size(later.end), 1, 1e-9));
  await page.click("#axle-back");
  const canvas = page.locator("#live-axle canvas");
  await canvas.scrollIntoViewIfNeeded();
  const box = await canvas.boundingBox();
  // All over the ball: wherever the axle is true.
  const found = await page.evaluate(() => {
    const [around, above, words] = ["#axle-around", "#axle-above", "#live-axle [data-shows=words]"].map((what) => document.querySelector(what));
    const found = {};
    for (let low = -90; low <= 90; low += 5) {
      for (let round = -90; round < 90; round += 5) {
        [around.value, above.value] = [round, low];
        above.dispatchEvent(new Event("input", { bubbles: true }));
        const which = words.textContent.match(/^True: on the axis of the (\w+)/)?.[1];
        if (which) found[which] ??= [round, low];
      }
    }
    return found;
  });
  const axes = [];
  for (const [which, [round, low]] of Object.entries(found)) {
    await set(page, "#axle-around", round);
    await set(page, "#axle-above", low);
    axes.push((await shows(page, "axle")).axle);
    wants(`on the ${which} moment's axis there is no gap`, (await shown(page, "axle", "gap")) === "0.0°");
    wants(`let go there, it stays: ${await shown(page, "axle", "wobble")}`, (await wobble(10)) === 0);
    await page.click("#axle-back");
  }
  wants(`three axes are found: ${Object.keys(found)}`, axes.length === 3);
  wants("and stand at right angles", axes.every((a, i) => axes.every((b, k) => i === k || Math.abs(dot(a, b)) < 1e-9)));
  const { tip: [x, y], axle: before } = await shows(page, "axle");
  const scrolled = await finger(page, [box.x + x, box.y + y], Array.from({ length: 10 }, (_, i) => [box.x + x + 4 * i, box.y + y + 5 * i]));
  const { tip, axle } = await shows(page, "axle");
  wants(`the axle's end follows the finger, and the page stays: ${scrolled} px`, scrolled === 0 && dot(before, axle) < 0.99 && Math.hypot(tip[0] - x - 36, tip[1] - y - 45) < 12);
}
