// Four engines, three of them wrong.
import { broken, said, set, shown } from "./controls.mjs";
import { frames } from "./hands.mjs";
import { pitfallsDrawn } from "./pitfalls.drawn.mjs";

export async function pitfalls(page, wants) {
  const of = (which, what) => page.locator("#live-pitfalls .live-engine").nth(which).locator(`[data-of=${what}]`).textContent();
  const start = (which) => page.click(`#live-pitfalls [data-start="${which}"]`);
  const end = () => page.click("#pitfalls-end");
  const text = (await page.textContent("main")).replace(/\s+/g, " ");

  // All in one screen, and it keeps its size whatever its numbers are.
  const before = page.viewportSize();
  await page.setViewportSize({ width: 1280, height: 720 });
  const tall = () => page.locator("#live-pitfalls .live-stage").evaluate((stage) => stage.querySelector(".live-engines").getBoundingClientRect().bottom - stage.getBoundingClientRect().top);
  await start(1);
  const high = await tall();
  wants(`at 1280 by 720 the four bodies are seen at once: ${high} px`, high < 620);
  for (const which of [1, 2, 3]) {
    await start(which);
    for (let i = 0; i < 3; i += 1) {
      wants(`pitfall ${which}: nothing moves up or down: ${await tall()}, not ${high}`, Math.abs((await tall()) - high) < 0.5);
      if (i < 2) await page.click("#pitfalls-play");
    }
    await end();
    wants(`pitfall ${which}, at the end: nothing moves up or down: ${await tall()}, not ${high}`, Math.abs((await tall()) - high) < 0.5);
  }
  await page.setViewportSize(before);

  // The chapter's numbers, taken from its sentences.
  const [, low, most] = text.match(/its energy falls to (\d+) % and rises to (\d+) %/);
  await start(1);
  await end();
  wants(`with the frozen tensor the energy goes from ${low} to ${most}: ${await of(1, "energy")}`,
    (await of(1, "energy")) === `−${100 - low}/+${most - 100} %`);
  wants(`the right engine keeps it: ${await of(0, "energy")}`, (await of(0, "energy")) === "kept" && (await of(0, "angle")) === "kept");
  const [, gap, energy] = text.match(/its spin is ([\d.]+°) off, the gap you know, and its energy is (\d+) %/);
  await start(2);
  wants(`momentum for spin starts with ${energy} %: ${await of(2, "energy")}`, (await of(2, "energy")) === `+${energy - 100} %`);
  wants(...await said(page, "pitfalls", new RegExp(`2 Momentum for spin: [^:]*Its spin began ${gap} off`)));
  await set(page, "#pitfalls-body", 7);
  wants(`a ball forgives it: ${await of(2, "energy")}`, (await of(2, "energy")) === "kept");
  wants(...await said(page, "pitfalls", /2 Momentum for spin: [^:]*Its spin began 0.0° off/));
  const [, flips, first, none] = text.match(/should flip (\d+) times, the first time after ([\d.]+ s).*?it flips (\d+) times/);
  await start(3);
  await end();
  wants(`right is ${flips} flips: ${await of(0, "flips")}`, (await of(0, "flips")) === `${flips} of ${flips}`);
  wants(`without the term there are ${none}: ${await of(3, "flips")}`, (await of(3, "flips")) === `${none} of ${flips}`);
  wants(`nor with momentum for spin: ${await of(2, "flips")}`, (await of(2, "flips")) === `0 of ${flips}`);
  wants(...await said(page, "pitfalls", new RegExp(`Right: [^:]*${flips} flips, the first after ${first}[^]*Right would be ${flips} flips`)));

  await pitfallsPlay(page, wants);

  // All ends of all controls.
  for (const body of [7, 2, 1, 0]) {
    for (const [spin, push, step] of [[0, 0, 9], [9, 11, 9], [9, 0, 9], [0, 11, 4], [9, 11, 3]]) {
      await set(page, "#pitfalls-body", body);
      await set(page, "#pitfalls-spin", spin);
      await set(page, "#pitfalls-push", push);
      await set(page, "#pitfalls-step", step);
      await set(page, "#pitfalls-until", 3);
      await page.click("#pitfalls-end");
      wants(`body ${body}, spin ${spin}, push ${push}, step ${step}: everything has a number and a place`, !(await broken(page, "pitfalls")));
    }
  }
  wants("a screen reader gets the step", /s$/.test(await page.getAttribute("#pitfalls-step", "aria-valuetext")));
  await pitfallsDrawn(page, wants, set);

  // Asleep it has the room that it takes awake: what a link leads to below it stays where it is.
  const wide = page.viewportSize();
  for (const width of [390, wide.width]) {
    await page.setViewportSize({ ...wide, width });
    await page.evaluate(() => scrollTo(0, 0));
    await page.reload();
    const high = () => page.locator("#live-pitfalls").evaluate((box) => box.clientHeight);
    const asleep = await high();
    await page.locator("#live-pitfalls").scrollIntoViewIfNeeded();
    await page.waitForFunction(() => document.querySelector("#live-pitfalls").dataset.state === "live");
    await frames(page);
    wants(`${width} px: it is ${asleep} px high asleep, ${await high()} awake`, Math.abs((await high()) - asleep) < 40);
  }
  await start(3);
  await end();
}

/** Played, or where less motion is preferred, moved on by tenths; paused, and back. */
export async function pitfallsPlay(page, wants) {
  await page.click("#pitfalls-reset");
  wants("back at the start", (await shown(page, "pitfalls", "time")).startsWith("0.0 s"));
  const drawn = () => page.locator("#live-pitfalls svg .live-tip").first().getAttribute("cx");
  const before = await drawn();
  const reduced = await page.evaluate(() => matchMedia("(prefers-reduced-motion: reduce)").matches);
  await page.locator("#pitfalls-play").focus();
  await page.keyboard.press("Enter");
  await page.waitForFunction((before) => Number(document.querySelector("#live-pitfalls svg .live-tip").getAttribute("cx")) > before, Number(before))
    .catch(() => wants("played, it goes on", false));
  const then = await drawn();
  if (reduced) {
    await frames(page, 12);
    wants("by itself nothing moves", (await drawn()) === then);
    wants("a tenth at a time", (await shown(page, "pitfalls", "time")).startsWith("2.0 s"));
  } else {
    await page.keyboard.press("Enter");
    const stood = await drawn();
    await frames(page, 12);
    wants("paused, it stands", (await drawn()) === stood && (await page.textContent("#pitfalls-play")) === "Play");
  }
}
