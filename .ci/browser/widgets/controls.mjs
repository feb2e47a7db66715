// How a reader works a widget, and what it says then.
import { finger, frames } from "./hands.mjs";

/** Sets a control as a reader does who moves it. */
export const set = (page, selector, value) =>
  page.locator(selector).evaluate((element, value) => {
    element.value = value;
    element.dispatchEvent(new Event("input", { bubbles: true }));
    element.dispatchEvent(new Event("change", { bubbles: true }));
  }, String(value));

/** Waits until the widget has said a text that matches, to those who do not see it. */
export const said = async (page, widget, pattern) => {
  const place = page.locator(`#live-${widget} .live-said`);
  const holds = await page.waitForFunction(([w, p]) => new RegExp(p).test(document.querySelector(`#live-${w} .live-said`).textContent),
    [widget, pattern.source], { timeout: 60000 }).then(() => true, () => false);
  return [`it says ${pattern}, not "${await place.textContent()}"`, holds];
};

/** What a translated page says, with the decimal point and the words that these checks expect. */
export const asInEnglish = (text) => [[/(\d),(?=\d)/g, "$1."], ["kein Umklappen", "no flip"], ["Umklappen", "Flip"], ["Nein.", "No."], ["alle 1", "every 1"]]
  .reduce((now, [from, to]) => now.replace(from, to), text);

export const shown = async (page, widget, what) => asInEnglish(await page.locator(`#live-${widget} [data-shows=${what}]`).textContent());

/** Whether some part of a widget's drawings has no place, or a number that is none is shown. */
export const broken = (page, widget) => page.locator(`#live-${widget}`).evaluate((box) =>
  [...box.querySelectorAll("svg")].some((svg) => /NaN|Infinity|undefined/.test(svg.outerHTML)) || /NaN|Infinity|undefined|null/.test(box.innerText));

export const atTime = (page, widget) => () => page.getAttribute(`#${widget}-scrub`, "aria-valuetext");

/** A picture that turns by mouse and finger, without the page; and a widget that plays, by steps where less motion is preferred. */
export async function turnsAndPlays(page, wants, widget, time) {
  const canvas = page.locator(`#live-${widget} canvas`).first();
  const looks = () => canvas.evaluate((canvas) => Array.from(canvas.shows.body.xs).join());
  await canvas.scrollIntoViewIfNeeded();
  const box = await canvas.boundingBox();
  const at = (part, low = 0.5) => [box.x + part * box.width, box.y + low * box.height];
  const seen = [await looks()];
  // Half a degree for each pixel to the last of many small moves, downward too: a drag that died would fall short.
  const from = () => canvas.evaluate(({ shows: { turn, tilt } }) => [turn, tilt]);
  const stood = await from();
  const scrolled = await finger(page, at(0.3), Array.from({ length: 20 }, (_, i) => at(0.3 + 0.02 * (i + 1), 0.5 + 0.01 * (i + 1))));
  wants(`under a finger the page does not scroll: ${scrolled} px`, scrolled === 0);
  const went = (await from()).map((degrees, i) => degrees - stood[i]);
  const should = [0.2 * box.width, 0.1 * box.height];
  wants(`the picture follows the finger to its end: by ${went}, not ${should}`, went.every((degrees, i) => Math.abs(degrees - should[i]) < 1));
  seen.push(await looks());
  await page.mouse.move(...at(0.3));
  await page.mouse.down();
  for (let i = 1; i <= 10; i += 1) await page.mouse.move(...at(0.3 + 0.03 * i));
  await page.mouse.up();
  seen.push(await looks());
  wants("dragged by finger and by mouse it is seen from elsewhere", new Set(seen).size === 3);
  const address = page.url();
  await page.locator(`#${widget}-scrub`).focus();
  const before = await time();
  await page.keyboard.press("ArrowRight");
  wants("an arrow key moves time and turns no page", (await time()) !== before && page.url() === address);
  const then = await time();
  const reduced = await page.evaluate(() => matchMedia("(prefers-reduced-motion: reduce)").matches);
  await page.click(`#${widget}-play`);
  if (reduced) return wants("it goes by a step", (await time()) !== then && (await page.textContent(`#${widget}-play`)) === "Step");
  await page.waitForFunction(([w, then]) => document.querySelector(`#${w}-scrub`).getAttribute("aria-valuetext") !== then, [widget, then])
    .catch(() => wants("played, it goes on", false));
  await page.click(`#${widget}-play`);
  wants("and it can be paused", (await page.textContent(`#${widget}-play`)) === "Play");
}

/** A widget that plays and can be paused, by what its last canvas shows. */
export const playsOn = (widget) => async (page, wants) => {
  const at = () => page.locator(`#live-${widget}`).evaluate((box) => JSON.stringify([...box.querySelectorAll("canvas, svg")].map((it) => it.shows)));
  const stood = await at();
  await page.click(`#${widget}-play`);
  await frames(page, 20);
  const later = await at();
  await frames(page, 20);
  wants("played, it moves, and goes on moving", new Set([stood, later, await at()]).size === 3);
  await page.click(`#${widget}-play`);
  const rests = await at();
  await frames(page, 6);
  wants("paused, it rests", (await at()) === rests);
};
