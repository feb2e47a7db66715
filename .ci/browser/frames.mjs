// How much work a frame of each moving widget costs the page's main thread: script, style, layout, paint, and, as there is no
// graphics card here, the drawing of every canvas too. From the browser's own trace, in processor time, so that neighbours
// on the machine do not count.
//
//     node frames.mjs [PAGES]        prints the table of book/widgets/README.md; SLOWED=0 or 1 half of its columns, ONLY=coin those rows

import { readFile, readdir } from "node:fs/promises";
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
/** Moves a slider to and fro, as fast as any hand; a step that it is at already is no news, as in a browser. */
const moved = (selector) => (page) => page.evaluate((selector) => {
  const input = document.querySelector(selector);
  const [from, to] = input.max ? [Number(input.min), Number(input.max)] : [1, 4]; // a field for any number has no end
  const frame = (now) => {
    const before = input.value;
    input.value = from + (to - from) * (0.5 + 0.5 * Math.sin(now / 300));
    if (input.value !== before) input.dispatchEvent(new Event("input", { bubbles: true }));
    requestAnimationFrame(frame);
  };
  requestAnimationFrame(frame);
}, selector);
const body = (value) => (page) => page.selectOption("#tumble-body", value);
/** What is played or moved otherwise than by the button Play. */
const OTHERWISE = {
  tumble: ["the box", "the book", "the phone", "the racket", "the wing nut"].map((name, i) => ({ says: name, first: body(String(i)) })),
  pitfalls: [{ says: "played", first: (page) => page.click('[data-start="3"]') }],
  toss: [{ says: "playing of itself", go: () => {} }],
  tosses: [{ says: "played" }, { says: "the error changed", go: moved("#tosses-slip") }],
  "two-arrows": [{ says: "let go" }, { says: "turned", go: moved("#two-arrows-spin") }],
  "your-box": [{ says: "let go" }, { says: "an edge changed", go: moved("#your-box-a") }],
  why: [{ says: "let go" }, { says: "the sphere grows", go: moved("#why-size") }],
  coin: [{ says: "played" }, { says: "the tilt changed", go: moved("#coin-tilt") }],
  steps: [{ says: "the step changed", go: moved("#steps-step") }],
  top: [{ says: "let go" }, { says: "pushed round", first: (page) => page.click("#live-top summary"), go: moved("#top-push") }],
  judge: [], // nothing of it moves
};

/** Every widget of every page, each once. */
async function moving() {
  const rows = new Map();
  for (const on of (await readdir(folder)).filter((name) => name.endsWith(".html") && !["index.html", "print.html"].includes(name)).sort()) {
    for (const [, widget] of (await readFile(path.join(folder, on), "utf8")).matchAll(/id="live-[a-z-]+" data-live="([a-z-]+)"/g)) {
      const kinds = OTHERWISE[widget] ?? [{ says: "played" }];
      rows.set(widget, kinds.map(({ says, first, go }) => ({ says: `${widget}, ${says}`, on, widget, first, go: go ?? played(widget) })));
    }
  }
  return [...rows.values()].flat();
}

/** Milliseconds of the main thread from each animation frame to the next. */
function works(events) {
  const frames = events.filter((e) => e.name === "FireAnimationFrame");
  const main = frames.at(0)?.tid;
  const own = (e) => e.tid === main && e.pid === frames[0].pid;
  const starts = [...new Set(frames.map((e) => e.ts))].sort((a, b) => a - b);
  const tasks = events.filter((e) => own(e) && e.name === "RunTask" && e.ph === "X");
  const found = starts.slice(1).map((to, i) => tasks.filter((e) => e.ts + e.dur > starts[i] && e.ts + e.dur <= to)
    .reduce((sum, e) => sum + e.tdur / 1000, 0)).sort((a, b) => a - b);
  // Of these the page's own scripts: a slider is moved inside a frame here.
  const script = starts.slice(1).map((to, i) => events.filter((e) => own(e) && e.ph === "X" && e.name === "FireAnimationFrame"
    && e.ts >= starts[i] && e.ts < to).reduce((sum, e) => sum + e.tdur / 1000, 0)).sort((a, b) => a - b);
  const layouts = events.filter((e) => own(e) && e.name === "Layout" && e.ts > starts[2]).length / starts.length;
  const at = (part, all = found) => all[Math.min(all.length - 1, Math.floor(part * all.length))];
  const seconds = (starts.at(-1) - starts[0]) / 1e6;
  return { count: found.length, middle: at(0.5), most: at(0.95), script: at(0.95, script), layouts, rate: (starts.length - 1) / seconds };
}

const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking"],
});
const only = process.env.ONLY; // part of a row's name
const screens = SCREENS.filter(({ slower }) => process.env.SLOWED === undefined || (slower > 1) === (process.env.SLOWED === "1"));
console.log(`| ms of work in a frame: median, 95th percentile (of scripts) | ${screens.map(({ says }) => says).join(" | ")} |`);
console.log(`|---|${screens.map(() => "---:").join("|")}|`);
for (const { says, on, widget, first, go } of (await moving()).filter((it) => !only || it.says.includes(only))) {
  const row = [];
  for (const { width, deviceScaleFactor, slower } of screens) {
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
    const { count, middle, most, script, layouts, rate } = works(events);
    row.push(count < 10 ? `only ${count} frames` : `${middle.toFixed(1)}, ${most.toFixed(1)} (${script.toFixed(1)})`);
    console.error(`${says}, ${width} px, ratio ${deviceScaleFactor}, slowed ${slower}: ${count} frames, ${rate.toFixed(0)} a second, ${layouts.toFixed(1)} layouts a frame`);
    await page.close();
  }
  console.log(`| ${says} | ${row.join(" | ")} |`);
}
await browser.close();
