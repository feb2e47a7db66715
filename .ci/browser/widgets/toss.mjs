// The book of the first screen.
import { byHand, finger, frames, pass } from "./hands.mjs";

/** The book of the first screen: it flips about its middle axis and about no other, goes on by itself only where it may, and turns under a finger. */
export async function toss(page, wants) {
  const canvas = page.locator("#live-toss canvas");
  const shows = () => canvas.evaluate((canvas) => canvas.shows);
  const play = "#toss-play";
  wants("less motion preferred, it begins at rest", (await page.textContent(play)) === "Play" && (await shows()).t === 0);
  await byHand(page);
  await page.click(play);
  wants("asked to, it plays", (await page.textContent(play)) === "Pause");
  // One clock for all three, which never goes back, however fast the machine is.
  let now = await page.evaluate(() => performance.now());
  for (const [which, axis, flips] of [["across", 0, true], ["spine", 2, false], ["through", 1, false]]) {
    await page.click(`[data-toss=${which}]`);
    await page.waitForFunction(() => window.byHand.waiting.size > 0);
    let [least, most, read] = [1, -1, 0];
    for (let i = 0; i < 60; i += 1) {
      await page.evaluate((now) => { for (let k = 1; k <= 10; k += 1) window.byHand.step(now + 70 * k); }, now);
      now += 700;
      const { turned, titles } = await shows();
      // On the screen y points down: from the way across to the way down is a right-handed turn, and in a mirror the other.
      const mirrored = titles.filter(([across, down]) => across[0] * down[1] <= across[1] * down[0]);
      wants(`${which}: no title is mirrored: ${JSON.stringify(mirrored)}`, mirrored.length === 0);
      read += titles.length;
      [least, most] = [Math.min(least, turned[axis][axis]), Math.max(most, turned[axis][axis])];
      const size = Math.hypot(...turned[axis]);
      wants(`${which}: what is drawn is turned, not stretched: ${size}`, Math.abs(size - 1) < 1e-9);
    }
    wants(`${which}: a title is seen`, read > 0);
    wants(`tossed ${which} its axis points along itself from ${least} to ${most}`, flips ? least < -0.95 && most > 0.95 : least > 0.95);
  }
  await page.click(play);
  const { t } = await shows();
  await pass(page, 3, 50);
  wants("paused, it rests", (await shows()).t === t && (await page.textContent(play)) === "Play");
  await page.evaluate(() => window.byHand.end());
  const box = await canvas.boundingBox();
  const at = (x, y) => [box.x + x * box.width, box.y + y * box.height];
  const before = await canvas.evaluate((canvas) => canvas.toDataURL());
  const scrolled = await finger(page, at(0.5, 0.5), Array.from({ length: 20 }, (_, i) => at(0.5 + 0.01 * i, 0.5 - 0.02 * i)));
  wants(`under a finger the page does not scroll: ${scrolled} px`, scrolled === 0);
  wants("and the book is seen from elsewhere", (await canvas.evaluate((canvas) => canvas.toDataURL())) !== before);
}

/** Where motion is welcome the book tumbles as soon as it is seen, and stops at a press. */
export async function tossPlay(page, wants) {
  const t = () => page.locator("#live-toss canvas").evaluate((canvas) => canvas.shows.t);
  await page.waitForFunction(() => document.querySelector("#live-toss canvas").shows.t > 0.05)
    .catch(() => wants("it tumbles by itself", false));
  await page.click("#toss-play");
  const stood = await t();
  await frames(page, 12);
  wants("paused, it rests", (await t()) === stood);
}
