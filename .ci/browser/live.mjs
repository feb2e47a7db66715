// Every widget on every page: it loads when it comes into view, shows what the chapter says, and survives what readers do.
import { readFile } from "node:fs/promises";
import path from "node:path";
import { foreignLetters, withFonts } from "./fonts.mjs";
import { axle } from "./widgets/axle.mjs";
import { coin, coinPlay } from "./widgets/coin.mjs";
import { atTime, playsOn, turnsAndPlays } from "./widgets/controls.mjs";
import { engines } from "./widgets/engines.mjs";
import { frames, thumbs } from "./widgets/hands.mjs";
import { judge } from "./widgets/judge.mjs";
import { masses } from "./widgets/masses.mjs";
import { pitfalls, pitfallsPlay } from "./widgets/pitfalls.mjs";
import { racket } from "./widgets/racket.mjs";
import { steps } from "./widgets/steps.mjs";
import { top, topPlay } from "./widgets/top.mjs";
import { toss, tossPlay, tosses, tossesPlay } from "./widgets/toss.mjs";
import { tumble, tumblePlay } from "./widgets/tumble.mjs";
import { trading, turning } from "./widgets/turning.mjs";
import { twoArrows } from "./widgets/two-arrows.mjs";
import { why, whyPlay } from "./widgets/why.mjs";
import { yourBody } from "./widgets/your-body.mjs";
import { yourBox } from "./widgets/your-box.mjs";

const THEMES = ["light", "rust", "coal", "navy", "ayu"];
/** Of all rules, those whose answer a theme can change. */
export const OF_THEME = ["color-contrast", "link-in-text-block"];

/** Pages and their widgets. */
async function placed(folder, pages) {
  const all = [];
  for (const name of pages) {
    const html = await readFile(path.join(folder, name), "utf8");
    const widgets = [...html.matchAll(/data-live="([a-z-]+)"/g)].map(([, widget]) => widget);
    if (widgets.length > 0) all.push({ name, widgets });
  }
  return all;
}

const TESTS = { axle, coin, engines, masses, racket, toss, tosses, "two-arrows": twoArrows, "your-body": yourBody, "your-box": yourBox, top, tumble, judge, pitfalls, steps, trading, turning, why };

const PLAYS = {
  coin: coinPlay, toss: tossPlay, tosses: tossesPlay, top: topPlay, tumble: tumblePlay, pitfalls: pitfallsPlay, why: whyPlay,
  ...Object.fromEntries(["axle", "engines", "masses", "racket", "two-arrows", "your-box"].map((widget) => [widget, playsOn(widget)])),
  ...Object.fromEntries(["trading", "turning"].map((widget) => [widget, (page, wants) => turnsAndPlays(page, wants, widget, atTime(page, widget))])),
};

/** What hangs out of its drawing or its frame. */
function cutOff(widget) {
  const stage = document.querySelector(`#live-${widget} .live-stage`);
  const found = [];
  if (stage.scrollWidth > stage.clientWidth) found.push({ what: `the frame is ${stage.scrollWidth} px wide inside ${stage.clientWidth}` });
  for (const svg of stage.querySelectorAll("svg")) {
    const frame = svg.getBoundingClientRect();
    for (const text of svg.querySelectorAll("text")) {
      const box = text.getBoundingClientRect();
      if (box.left < frame.left - 1 || box.right > frame.right + 1 || box.top < frame.top - 1 || box.bottom > frame.bottom + 1) {
        text.dataset.fault = found.length + 1;
        found.push({ what: `"${text.textContent}" is cut off`, marked: text.dataset.fault });
      }
    }
  }
  return found;
}

/** A module that came damaged, or a browser that cannot unpack it: the page says so, and neither asks for scripts, which run, nor lets anything be tried. */
async function lacking(page, address, widget, wants, how, advice) {
  await page.goto(address);
  const box = page.locator(`#live-${widget}`);
  await box.scrollIntoViewIfNeeded();
  await page.waitForFunction((w) => document.querySelector(`#live-${w}`).dataset.state, widget, { timeout: 60000 }).catch(() => {});
  const state = await box.getAttribute("data-state");
  wants(`${how}, it does not come to life: ${state}`, /^failed/.test(state));
  const says = await box.innerText();
  wants(`${how}, it says so: ${says.slice(0, 200)}`, says.includes("could not be loaded") && says.includes(advice) && !says.includes("With JavaScript"));
  wants(`${how}, it offers nothing to try`, !(await box.locator(".live-stage").isVisible()));
  await page.context().close();
}
async function damaged({ open, bases }, address, widget, wants) {
  const page = await open(bases.http);
  await page.route("**/*.wasm.js", (route) => {
    const module = path.basename(route.request().url(), ".wasm.js");
    return route.fulfill({ contentType: "text/javascript", body: `tumblingLive.carry("${module}", "${btoa("\0asm\x01\0\0\0damaged")}");` });
  });
  await lacking(page, address, widget, wants, "damaged", "Load the page again");
  const old = await open(bases.http);
  await old.addInitScript(() => { delete globalThis.DecompressionStream; });
  await lacking(old, address, widget, wants, "in an old browser", "It needs a newer browser");
}

/** What moves by itself on a page is at rest before five seconds are over (WCAG 2.2.2), and does not move where less motion is preferred. */
export async function comesToRest(page, reducedMotion, fault) {
  const name = page.url().split("/").at(-1);
  const ends = await page.evaluate(() => document.getAnimations().map((glide) => glide.effect.getComputedTiming().endTime));
  const most = reducedMotion === "reduce" ? 50 : 4500;
  if (ends.some((end) => !(end <= most))) fault(`${name}, ${reducedMotion}`, `it moves by itself for ${Math.max(...ends)} ms`);
  if (reducedMotion !== "reduce" && name === "about.html" && ends.length === 0) fault(name, "its cover does not draw itself, as the text says");
}

/** Without scripts the stills stand in for the widgets. */
async function stills({ open, bases, fault }, name, widgets) {
  const page = await open(bases.file, { javaScriptEnabled: false });
  await page.goto(bases.file + name);
  for (const widget of widgets) {
    const still = await page.locator(`[data-live=${widget}] > .live-still`).isVisible();
    if (!still || await page.locator(`#live-${widget} .live-stage`).isVisible()) fault(`${name} without scripts`, `${widget} does not stand still`);
  }
  await page.context().close();
}

/** The page for print shows no widget at work. */
async function printed({ open, bases, fault }, name) {
  const page = await open(bases.file);
  await page.goto(bases.file + name);
  const visible = await page.locator(".live-stage:visible").count();
  if (visible > 0) fault(name, `${visible} widgets are live where all keeps still`);
  await page.context().close();
}

/** Opens a page and brings one of its widgets to life; null if it does not come. */
async function enlivened({ open }, base, name, widget, widgets, reducedMotion, wants) {
  const page = await open(base, { reducedMotion });
  const asked = [];
  page.on("request", (request) => asked.push(path.basename(request.url())));
  await page.goto(base + name);
  const box = page.locator(`#live-${widget}`);
  const far = await box.evaluate((e) => e.getBoundingClientRect().top > innerHeight + 300);
  const modules = (await box.getAttribute("data-modules")).split(" ");
  wants("it waits until it comes into view", !far || !asked.includes(`${widget}.js`)); // its modules may have come for another
  await box.scrollIntoViewIfNeeded();
  try {
    await page.waitForFunction((w) => document.querySelector(`#live-${w}`).dataset.state === "live", widget, { timeout: 60000 });
  } catch {
    wants(`it comes to life, not: ${await box.getAttribute("data-state")}`, false);
    return null;
  }
  const others = asked.filter((file) => file.endsWith(".wasm.js") && ![...widgets, ...modules].some((w) => file === `${w}.wasm.js`));
  wants(`it loads no other module than the page's: ${others}`, others.length === 0);
  await page.evaluate(() => document.fonts.ready); // with which drawings are drawn anew
  await frames(page);
  // But for what is read aloud, which waits until a hand is still.
  const looks = () => box.evaluate((e) => {
    const copy = e.cloneNode(true);
    copy.querySelectorAll(".live-said").forEach((said) => said.remove());
    return copy.innerHTML;
  });
  const before = await looks();
  await frames(page, 12);
  wants("nothing moves until asked", before === (await looks()));
  return page;
}

/** A widget in five themes and three widths, once it has been tried. */
async function looks({ violations, fault, shots }, page, widget, where) {
  const box = page.locator(`#live-${widget}`);
  await page.evaluate(() => {
    const contents = document.querySelector("#mdbook-sidebar-toggle-anchor");
    if (contents.checked) contents.click(); // they take the room of the text in a narrow window
  });
  for (const width of [320, 800, 1400]) {
    await page.setViewportSize({ width, height: 900 });
    await frames(page);
    for (const what of await withFonts(page, await page.evaluate(cutOff, widget))) fault(`${where}, ${width} px`, what);
    if (width === 320) for (const what of await foreignLetters(page, `#live-${widget}`)) fault(where, what);
    for (const theme of width === 800 ? THEMES : shots ? ["light", "navy"] : []) {
      await page.evaluate(([themes, theme]) => {
        document.documentElement.classList.remove(...themes);
        document.documentElement.classList.add(theme);
      }, [THEMES, theme]);
      // Colours glide from theme to theme: to their end at once, however slow the machine.
      await page.evaluate(() => document.getAnimations().forEach((glide) => glide.finish()));
      if (width === 800) {
        for (const rule of await violations(page, `#live-${widget}`, theme === THEMES[0] ? undefined : OF_THEME)) {
          fault(`${where}, ${theme}`, `${rule.impact}: ${rule.id}: ${rule.nodes[0].target.join(" ")}: ${rule.nodes[0].failureSummary}`);
        }
      }
      if (shots) await box.screenshot({ path: path.join(shots, `live-${widget}-${theme}-${width}.png`) });
    }
  }
}

/**
 * The widgets' jobs: each is tried wholly from disk, where less motion is preferred; from a server, where it is not, it is looked at for what
 * only that can show: that it loads, that it plays of itself, and what a damaged module says.
 */
export async function liveJobs(tools) {
  const { open, bases, folder, pages, fault } = tools;
  const jobs = [];
  for (const { name, widgets } of await placed(folder, pages.filter((name) => name !== "index.html"))) { // that one is the introduction again
    if (name === "print.html") {
      jobs.push({ name: "live print", run: () => printed(tools, name) });
      continue;
    }
    jobs.push({ name: `live ${name} without scripts`, run: () => stills(tools, name, widgets) });
    for (const widget of widgets) {
      const wants = (kind) => (what, holds) => holds || fault(`${name}, ${widget}, ${kind}`, what);
      if (!TESTS[widget]) fault(name, `there is no test for the widget ${widget}`);
      jobs.push({
        name: `live ${widget} from disk`,
        run: async () => {
          const page = await enlivened(tools, bases.file, name, widget, widgets, "reduce", wants("file"));
          if (!page) return;
          await TESTS[widget]?.(page, wants("file"));
          await looks(tools, page, widget, `${name}, ${widget}`);
          await page.context().close();
        },
      });
      jobs.push({
        name: `live ${widget} from a server`,
        run: async () => {
          const page = await enlivened(tools, bases.http, name, widget, widgets, "no-preference", wants("http"));
          if (!page) return;
          await PLAYS[widget]?.(page, wants("http"));
          await thumbs(page, widget, wants("http"));
          await page.context().close();
          await damaged(tools, bases.http + name, widget, wants("http"));
        },
      });
    }
  }
  return jobs;
}
