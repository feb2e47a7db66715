// The book of the first screen.
import { asInEnglish, set, shown } from "./controls.mjs";
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
    let [least, most, read, turnings, side] = [1, -1, 0, 0, 1];
    for (let i = 0; i < 60; i += 1) {
      await page.evaluate((now) => { for (let k = 1; k <= 10; k += 1) window.byHand.step(now + 70 * k); }, now);
      now += 700;
      const { turned, titles, flips: counted } = await shows();
      // Its axis points the other way after each flip: so often it must be counted, but for what is on its way.
      if (Math.abs(turned[axis][axis]) > 0.7 && Math.sign(turned[axis][axis]) !== side) [turnings, side] = [turnings + 1, -side];
      const text = await page.textContent("#live-toss .toss-count");
      if (Math.abs(turned[axis][axis]) > 0.7) wants(`${which}: it has turned over ${turnings} times, and counts "${text}"`, counted === turnings && text === (turnings > 0 ? `Flip ${turnings}` : ""));
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
  const looks = () => canvas.evaluate((canvas) => canvas.toDataURL());
  const before = await looks();
  const scrolled = await finger(page, at(0.4, 0.5), Array.from({ length: 20 }, (_, i) => at(0.4 + 0.02 * i, 0.5 + 0.004 * i)));
  wants(`under a finger that goes across the page does not scroll: ${scrolled} px`, scrolled === 0);
  wants("and the book is seen from elsewhere", (await looks()) !== before);
  // The window's height may change alone, as on a phone whose address bar comes and goes.
  const { width, height } = page.viewportSize();
  await page.setViewportSize({ width, height: 600 });
  await frames(page);
  const dots = await canvas.evaluate((canvas) => [canvas.width / canvas.clientWidth, canvas.height / canvas.clientHeight]);
  wants(`in a lower window the book is not stretched: ${dots} dots a pixel`, Math.abs(dots[0] - dots[1]) < 0.01);
  await page.setViewportSize({ width, height });
  await frames(page);
  await page.evaluate(() => scrollTo(0, 0));
  const high = await canvas.boundingBox();
  const past = await finger(page, [high.x + 0.5 * high.width, high.y + 0.8 * high.height], Array.from({ length: 20 }, (_, i) => [high.x + 0.5 * high.width, high.y + 0.8 * high.height - 12 * i]));
  wants(`a thumb that goes up scrolls the page past it: ${past} px`, past > 50);
  // Life's own pace, and slower.
  await set(page, "#toss-slow", 1);
  wants("as fast as in life it says so", (await shown(page, "toss", "slow")) === "as in life");
  await set(page, "#toss-slow", 4);
  wants("and four times slower too", (await shown(page, "toss", "slow")) === "4 times slower");
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

/** Three books and one error of the hand: one flips, as often as was said, and later the smaller the error is; the others do not. */
export async function tosses(page, wants) {
  const text = asInEnglish((await page.textContent("main")).replace(/\s+/g, " "));
  const [, beat] = text.match(/every (1\.\d\d s)/) ?? [];
  await set(page, "#tosses-slip", Math.log10(0.05));
  wants(`off by a twentieth it flips every ${await shown(page, "tosses", "beat")}, as the chapter says`, (await shown(page, "tosses", "beat")) === beat);
  const first = async () => parseFloat(await shown(page, "tosses", "first"));
  const firsts = [];
  for (const power of [-2, -4, -6, -8]) {
    await set(page, "#tosses-slip", power);
    firsts.push(await first());
  }
  const later = firsts.slice(1).map((time, i) => time - firsts[i]);
  wants(`each error a hundred times smaller waits as long again: ${later}`, later.every((step) => step > 0.2 && Math.abs(step - later[0]) < 0.03));
  const flips = async () => (await page.locator("#live-tosses [data-counts]").allTextContents()).map(asInEnglish);
  await set(page, "#tosses-slip", -2);
  const due = await first();
  let seen = 0;
  for (let i = 0; i < 120 && seen === 0; i += 1) {
    await page.click("#tosses-play");
    if ((await flips())[0] === "Flip 1") seen = parseFloat(await shown(page, "tosses", "time"));
  }
  wants(`it flips at ${seen} s, as said: ${due}`, seen >= due - 0.006 && seen < due + 0.03);
  wants(`and it alone: ${await flips()}`, (await flips()).join() === "Flip 1,no flip,no flip");
  for (const which of ["across", "spine", "through"]) {
    const { titles, turned } = await page.locator(`#live-tosses [data-toss=${which}]`).evaluate((canvas) => canvas.shows);
    wants(`${which}: no title is mirrored`, titles.every(([across, down]) => across[0] * down[1] > across[1] * down[0]));
    wants(`${which}: it is turned, not stretched`, Math.abs(Math.hypot(...turned[0]) - 1) < 1e-9);
  }
  await page.click("#tosses-back");
  wants("again, it has not flipped", (await flips()).join() === "no flip,no flip,no flip" && (await shown(page, "tosses", "time")) === "0.00 s");
  const canvas = page.locator("#live-tosses canvas").first();
  await canvas.scrollIntoViewIfNeeded();
  const box = await canvas.boundingBox();
  const turn = () => canvas.evaluate((canvas) => canvas.shows.turn);
  const before = await turn();
  const scrolled = await finger(page, [box.x + 10, box.y + 90], Array.from({ length: 20 }, (_, i) => [box.x + 10 + 3 * i, box.y + 90]));
  wants(`a finger looks round, and the page stays: ${scrolled} px`, scrolled === 0 && Math.abs((await turn()) - before) > 20);
}

export async function tossesPlay(page, wants) {
  const time = () => shown(page, "tosses", "time");
  await page.click("#tosses-play");
  await page.waitForFunction(() => document.querySelector("#live-tosses [data-shows=time]").textContent !== "0.00 s").catch(() => wants("played, it goes on", false));
  await page.click("#tosses-play");
  const stood = await time();
  await frames(page, 12);
  wants("paused, it rests", (await time()) === stood);
}
