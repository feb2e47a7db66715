// Masses that are dragged: their tensor, worked out here, and how they resist a torque.
import { read } from "../drawn.flat.mjs";
import { set, shown } from "./controls.mjs";
import { finger } from "./hands.mjs";
import { near } from "./space.mjs";

const shows = (page, widget) => page.locator(`#live-${widget} canvas`).evaluate((canvas) => canvas.shows);
const DEGREES = 180 / Math.PI;

export async function masses(page, wants) {
  const entries = () => page.locator("#live-masses [data-at]").evaluateAll((all) => Object.fromEntries(all.map((place) => [place.dataset.at, place.textContent.replace("−", "-")])));
  const holds = async (when) => {
    const { pairs } = await shows(page, "masses");
    const sum = (of) => 2 * pairs.reduce((all, [x, y]) => all + of(x, y), 0);
    const [xx, yy, xy] = [sum((x, y) => y * y), sum((x) => x * x), -sum((x, y) => x * y)];
    const got = await entries();
    const right = { 0: xx, 1: yy, 2: xx + yy, 3: xy, 4: 0, 5: 0 };
    for (const [place, value] of Object.entries(right)) wants(`${when}: entry ${place} is ${got[place]}, not ${value}`, near(Number(got[place]), value, 0.0051));
    const gap = Math.atan2(Math.abs(xy), xx) * DEGREES;
    const told = await Promise.all(["about", "faster", "gap"].map(async (what) => read(await shown(page, "masses", what))));
    wants(`${when}: it tells ${told}`, near(told[0], xx, 0.0051) && near(told[1], 1 / xx, 0.0051) && near(told[2], gap, 0.051));
    return { xx };
  };
  await holds("at first");
  const canvas = page.locator("#live-masses canvas");
  await canvas.scrollIntoViewIfNeeded();
  const box = await canvas.boundingBox();
  const place = async (k) => {
    const { x, y } = (await shows(page, "masses")).places.find((place) => place.k === k);
    return [box.x + x, box.y + y];
  };
  for (const [k, right, down] of [[0, -30, 25], [1, 20, -30]]) {
    const [before, [x, y]] = [(await shows(page, "masses")).pairs[k], await place(k)];
    const scrolled = await finger(page, [x, y], Array.from({ length: 10 }, (_, i) => [x + (i + 1) * right / 10, y + (i + 1) * down / 10]));
    wants(`dragged by a finger a mass moves, and the page stays: ${scrolled} px`, scrolled === 0 && String((await shows(page, "masses")).pairs[k]) !== String(before));
    const apart = (await shows(page, "masses")).places.map((at) => Math.hypot(box.x + at.x - x - right, box.y + at.y - y - down));
    wants(`a mass lies under the finger: ${Math.min(...apart)} px off`, Math.min(...apart) < 9);
    await holds(`pair ${k} dragged`);
  }
  const { turn } = await shows(page, "masses");
  await finger(page, [box.x + 8, box.y + 12], Array.from({ length: 10 }, (_, i) => [box.x + 8 + 4 * i, box.y + 12]));
  wants("dragged beside them, the picture turns", (await shows(page, "masses")).turn > turn + 10);
  await set(page, "#masses-pair", 1);
  for (const [along, out] of [[0.8, 0.2], [0.8, 1]]) {
    await set(page, "#masses-along", along);
    await set(page, "#masses-out", out);
    await holds(`by sliders ${along}, ${out}`);
  }
  // Driven for a second: half the angular acceleration, and as fast as it.
  const { xx } = await holds("before the torque acts");
  for (let i = 0; i < 2; i += 1) await page.click("#masses-play");
  wants("driven for a second, it has turned as far", near((await shows(page, "masses")).far, 0.5 / xx, 1e-9));
  wants("and turns as fast", near(read(await shown(page, "masses", "now")), 1 / xx, 0.051));
  for (const pair of [0, 1]) {
    await set(page, "#masses-pair", pair);
    await set(page, "#masses-out", 0);
  }
  wants("all on the axle, nothing resists, and no torque can act", (await shown(page, "masses", "about")) === "none" && await page.locator("#masses-play").isDisabled());
}
