// The racket: twisted as the chapter says by each error of the hand, and drawn with the face that the words call up.
import { read } from "../drawn.flat.mjs";
import { set, shown } from "./controls.mjs";
import { finger } from "./hands.mjs";

const shows = (page, what) => page.locator(`#live-racket [data-draws=${what}]`).evaluate((canvas) => canvas.shows);

export async function racket(page, wants) {
  const text = (await page.textContent("main")).replace(/\s+/g, " ");
  const chapter = [...text.matchAll(/with ([\d.]+) %( of the spin about the middle axis it is back in the hand twisted)? by (\d+)°/gi)].map(([, share, , twist]) => [Number(share), Number(twist)]);
  const [, left, right] = text.match(/With 5 % about both of the other axes it is (\d+)° or (\d+)°/) ?? [];
  wants(`the chapter has four errors and a pair: ${chapter}`, chapter.length >= 4 && left !== undefined);
  const cases = [...chapter.map(([share, twist]) => [share, 0, twist]), [5, -5, Number(left)], [5, 5, Number(right)]];
  for (const [handle, through, twist] of cases) {
    await set(page, "#racket-handle", Math.log10(handle / 100));
    await set(page, "#racket-through", through);
    const words = await shown(page, "racket", "words");
    wants(`${handle} %, ${through} %: "${words}", by the chapter ${twist}°`, read(words.match(/by (\S+)°/)[1]) === twist && words.includes(twist > 90 ? "other" : "same"));
    const [start, end] = [await shows(page, "start"), await shows(page, "end")];
    wants(`${handle} %, ${through} %: the face drawn up is the one told`, start.up && end.up === twist < 90);
    // Caught, its handle points where it did, seen along the axis of the toss.
    const handleSeen = ({ seen }) => seen.map((row) => row[2]);
    const apart = Math.hypot(...handleSeen(start).map((x, i) => x - handleSeen(end)[i]));
    wants(`${handle} %, ${through} %: the handle is back in the hand, ${apart} off`, apart < (through === 0 ? 1 : 1.2));
  }
  await set(page, "#racket-through", 0);
  await set(page, "#racket-handle", -1);
  for (let i = 0; i < 3; i += 1) await page.click("#racket-play");
  const flown = (await shows(page, "flight")).t;
  wants(`three steps of it fly for 0.3 s: ${flown}`, Math.abs(flown - 0.3) < 1e-9);
  await page.click("#racket-back");
  wants("again, it is back in the hand", (await shows(page, "flight")).t === 0);
  const canvas = page.locator("#live-racket [data-draws=flight]");
  await canvas.scrollIntoViewIfNeeded();
  const box = await canvas.boundingBox();
  const { turn } = await shows(page, "flight");
  const scrolled = await finger(page, [box.x + 20, box.y + 60], Array.from({ length: 12 }, (_, i) => [box.x + 20 + 4 * i, box.y + 60]));
  wants(`a finger looks round, and the page stays: ${scrolled} px`, scrolled === 0 && (await shows(page, "start")).turn > turn + 15);
  await page.locator("#racket-handle").focus();
  const [words, address] = [await shown(page, "racket", "words"), page.url()];
  for (let i = 0; i < 4; i += 1) await page.keyboard.press("ArrowLeft");
  wants("keys change the hand's error and turn no page", (await shown(page, "racket", "words")) !== words && page.url() === address);
}
