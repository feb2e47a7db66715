// How much work a frame of each moving widget costs the page's main thread: script, style, layout, paint, and, as there is no
// graphics card here, the drawing of every canvas too. From the browser's own trace, in processor time, so that neighbours
// on the machine do not count.
//
//     node frames.mjs [PAGES]        prints the table of book/widgets/README.md

import path from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

const folder = path.resolve(process.argv[2] ?? fileURLToPath(new URL("../../book/html", import.meta.url)));
const base = pathToFileURL(folder).href;
const SCREENS = [
  { says: "1400 px, ratio 1", width: 1400, deviceScaleFactor: 1, slower: 1 },
  { says: "1400 px, ratio 2", width: 1400, deviceScaleFactor: 2, slower: 1 },
  { says: "390 px, ratio 3", width: 390, deviceScaleFactor: 3, slower: 1 },
  { says: "1400 px, ratio 2, slowed 4 times", width: 1400, deviceScaleFactor: 2, slower: 4 },
  { says: "390 px, ratio 3, slowed 4 times", width: 390, deviceScaleFactor: 3, slower: 4 },
];

/** Plays a widget for some seconds of the motion. */
const played = (widget) => (page) => page.click(`#${widget}-play`);
/** Moves a slider to and fro at every frame, as fast as any hand. */
const moved = (selector) => (page) => page.evaluate((selector) => {
  const input = document.querySelector(selector);
  const [from, to] = [Number(input.min), Number(input.max)];
  const frame = (now) => {
    input.value = from + (to - from) * (0.5 + 0.5 * Math.sin(now / 300));
    input.dispatchEvent(new Event("input", { bubbles: true }));
    requestAnimationFrame(frame);
  };
  requestAnimationFrame(frame);
}, selector);
const body = (value) => (page) => page.selectOption("#tumble-body", value);
const MOVING = [
  ...["the box", "the book", "the phone", "the racket", "the wing nut"].map((name, i) =>
    ({ says: `tumble, ${name}`, on: "dzhanibekov.html", widget: "tumble", first: body(String(i)), go: played("tumble") })),
  { says: "top, let go", on: "a-top.html", widget: "top", go: played("top") },
  { says: "pitfalls", on: "three-pitfalls.html", widget: "pitfalls", first: (page) => page.click('[data-start="3"]'), go: played("pitfalls") },
  { says: "two arrows, turned", on: "two-arrows.html", widget: "two-arrows", go: moved("#two-arrows-spin") },
  { says: "your box, an edge changed", on: "worked-example.html", widget: "your-box", go: moved("#your-box-a") },
  { says: "steps, the step changed", on: "stepping-through-time.html", widget: "steps", go: moved("#steps-step") },
];

/** Milliseconds of the main thread from each animation frame to the next. */
function works(events) {
  const frames = events.filter((e) => e.name === "FireAnimationFrame");
  const main = frames.at(0)?.tid;
  const own = (e) => e.tid === main && e.pid === frames[0].pid;
  const starts = [...new Set(frames.map((e) => e.ts))].sort((a, b) => a - b);
  const tasks = events.filter((e) => own(e) && e.name === "RunTask" && e.ph === "X");
  const found = starts.slice(1).map((to, i) => tasks.filter((e) => e.ts + e.dur > starts[i] && e.ts + e.dur <= to)
    .reduce((sum, e) => sum + e.tdur / 1000, 0)).sort((a, b) => a - b);
  const layouts = events.filter((e) => own(e) && e.name === "Layout" && e.ts > starts[2]).length / starts.length;
  const at = (part) => found[Math.min(found.length - 1, Math.floor(part * found.length))];
  const seconds = (starts.at(-1) - starts[0]) / 1e6;
  return { count: found.length, middle: at(0.5), most: at(0.95), layouts, rate: (starts.length - 1) / seconds };
}

const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking"],
});
const only = process.env.ONLY;
console.log(`| ms of work in a frame: median, 95th percentile | ${SCREENS.map(({ says }) => says).join(" | ")} |`);
console.log(`|---|${SCREENS.map(() => "---:").join("|")}|`);
for (const { says, on, widget, first, go } of MOVING.filter((it) => !only || it.says.includes(only))) {
  const row = [];
  for (const { width, deviceScaleFactor, slower } of SCREENS) {
    const page = await browser.newPage({ viewport: { width, height: 844 }, deviceScaleFactor, reducedMotion: "no-preference" });
    await page.goto(`${base}/${on}`);
    await page.locator(`#live-${widget}`).scrollIntoViewIfNeeded();
    await page.waitForFunction((w) => document.querySelector(`#live-${w}`).dataset.state === "live", widget);
    await first?.(page);
    const session = await page.context().newCDPSession(page);
    await session.send("Emulation.setCPUThrottlingRate", { rate: slower });
    await go(page);
    await page.locator(`#live-${widget} .live-drawing`).first().scrollIntoViewIfNeeded();
    await page.waitForTimeout(1500);
    const events = [];
    session.on("Tracing.dataCollected", ({ value }) => events.push(...value));
    await session.send("Tracing.start", { transferMode: "ReportEvents", traceConfig: { includedCategories: ["devtools.timeline", "disabled-by-default-devtools.timeline"] } });
    await page.waitForTimeout(2000);
    const done = new Promise((resolve) => session.once("Tracing.tracingComplete", resolve));
    await session.send("Tracing.end");
    await done;
    const { count, middle, most, layouts, rate } = works(events);
    row.push(count < 10 ? `only ${count} frames` : `${middle.toFixed(1)}, ${most.toFixed(1)}`);
    console.error(`${says}, ${width} px, ratio ${deviceScaleFactor}, slowed ${slower}: ${count} frames, ${rate.toFixed(0)} a second, ${layouts.toFixed(1)} layouts a frame`);
    await page.close();
  }
  console.log(`| ${says} | ${row.join(" | ")} |`);
}
await browser.close();
