// Opens every page of the built book, as a file and from a local server, and fails on whatever a reader
// would stumble over: a request to any other place, a word on the console, a page that scrolls
// sideways, a letter in a font that is not the book's, a control the keyboard cannot reach, a rule of accessibility broken.
//
//     node check.mjs [--pages FOLDER] [--shots DIR] [--at-once N] [NAME ...]
//
// With names, only the jobs that have one of them in their own: `tumble`, `page two-arrows`, `figures`. N jobs run at once, two if not said.

import { existsSync } from "node:fs";
import { readFile, readdir, mkdir } from "node:fs/promises";
import { createRequire } from "node:module";
import path from "node:path";
import { pathToFileURL, fileURLToPath } from "node:url";
import { parseArgs } from "node:util";
import { chromium } from "playwright-core";
import { figures } from "./figures.mjs";
import { foreignLetters, watchCanvases, withFonts } from "./fonts.mjs";
import { OF_THEME, comesToRest, liveJobs } from "./live.mjs";
import { codeFolds, keyboard, questions, search, withoutScripts } from "./reader.mjs";
import { serve } from "./serve.mjs";

const THEMES = ["light", "rust", "coal", "navy", "ayu"];
const WIDTHS = [320, 800, 1400];
// Of all rules, those whose answer a narrower window can change. Colours, which
// take longest, are looked at in the widest and the narrowest.
const OF_WIDTH = ["scrollable-region-focusable", "target-size", "aria-hidden-focus", "link-name", "button-name", "label", "bypass"];
const HERE = path.dirname(fileURLToPath(import.meta.url));

const { values, positionals: words } = parseArgs({
  allowPositionals: true,
  options: { pages: { type: "string", default: path.join(HERE, "../../book/html") }, shots: { type: "string" }, "at-once": { type: "string", default: "2" } },
});
const shots = values.shots ? path.resolve(values.shots) : null;
const atOnce = Number(values["at-once"]);
const folder = path.resolve(values.pages);
const names = (await readdir(folder)).filter((name) => name.endsWith(".html")).sort();
const pages = names.filter((name) => !/^toc\b/.test(name)); // these are frames of the others
if (pages.length < 3) throw new Error(`no book in ${folder}: build it first`);
if (shots) await mkdir(shots, { recursive: true });

const faults = new Set();
const fault = (where, what) => {
  const line = `${where}: ${what}`;
  if (!faults.has(line)) console.error(`FAULT: ${line}`);
  faults.add(line);
};

const server = await serve(folder);
const bases = { file: pathToFileURL(folder).href + "/", http: server.base };
// The program without windows of its own takes two thirds of the other's time.
const program = process.env.CHROMIUM ?? (existsSync("/usr/bin/chromium-headless-shell") ? "/usr/bin/chromium-headless-shell" : "/usr/bin/chromium");
const browser = await chromium.launch({
  executablePath: program,
  args: [
    "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-sync",
    "--disable-background-networking", "--disable-component-update",
  ],
});

/** A window that tells on its page: requests elsewhere, failures, words on the console. */
async function open(base, options = {}) {
  const { theme, ...rest } = options;
  const context = await browser.newContext({ viewport: { width: 1400, height: 900 }, ...rest });
  if (theme) {
    await context.addInitScript((t) => localStorage.setItem("mdbook-theme", t), theme);
  }
  await context.addInitScript(watchCanvases);
  const page = await context.newPage();
  const tell = (what) => fault(page.url().replace(base, ""), what);
  // Waits until nothing has been loaded for half a second. The browser's own word on that does not come for the page for print.
  let [loading, last] = [0, performance.now()];
  const ended = () => { loading -= 1; last = performance.now(); };
  page.on("requestfinished", ended);
  page.quiet = async () => {
    const begun = performance.now();
    while (loading > 0 || performance.now() - last < 500) {
      if (performance.now() - begun > 30000) return tell("is still loading after 30 s");
      await new Promise((next) => setTimeout(next, 50));
    }
  };
  page.on("request", (request) => {
    loading += 1;
    const url = request.url();
    if (!url.startsWith(base) && !/^(data|blob):/.test(url)) tell(`asks for ${url}`);
  });
  page.on("requestfailed", (request) => {
    ended();
    const why = request.failure()?.errorText;
    // Leaving a page ends what it was still loading; that is no fault of the page.
    if (why !== "net::ERR_ABORTED") tell(`cannot load ${request.url()} (${why})`);
  });
  page.on("response", (r) => r.status() >= 400 && tell(`got ${r.status()} for ${r.url()}`));
  page.on("console", (message) => tell(`console: ${message.text()}`));
  page.on("pageerror", (error) => tell(`script error: ${error.message}`));
  return page;
}

/** What is wider than the window although nothing lets one scroll to it. */
function tooWide() {
  const found = [];
  const width = document.documentElement.clientWidth;
  if (document.documentElement.scrollWidth > width) {
    found.push({ what: `the page scrolls sideways (${document.documentElement.scrollWidth} px)` });
  }
  const boxes = ".math-display, .fig-frame, .table-wrapper, pre";
  for (const element of document.querySelectorAll("main *")) {
    if (element.closest(boxes) && !element.matches(boxes)) continue;
    const box = element.getBoundingClientRect();
    if (box.width > 0 && (box.right > width + 1 || box.left < -1)) {
      element.dataset.fault = found.length + 1;
      found.push({ what: `<${element.localName}> is cut off: ${element.textContent.trim().slice(0, 60)}`, marked: element.dataset.fault });
    }
  }
  return found.slice(0, 5);
}

const axe = await readFile(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
/**
 * The rules that a page, or a part of it, breaks: of all rules or of those named. What holds is not listed, since
 * the list costs time.
 */
async function violations(page, part, only) {
  if (!(await page.evaluate(() => "axe" in globalThis))) await page.evaluate(axe);
  const options = { preload: false, resultTypes: ["violations"], ...(only && { runOnly: only }) };
  return page.evaluate(async ([part, options]) => (await globalThis.axe.run(part ?? document, options)).violations, [part, options]);
}

/** Holds a page to all rules of accessibility, or to those named. */
async function rules(page, where, only) {
  for (const rule of await violations(page, null, only)) {
    // A heading of a column that is a formula is not empty: axe does not read MathML, readers' tools do.
    const says = (node) => !(rule.id === "empty-table-header" && node.html.includes("<math"));
    for (const node of rule.nodes.filter(says).slice(0, 3)) {
      const why = node.any.concat(node.all, node.none).map((check) => check.message).join("; ");
      fault(where, `${rule.impact}: ${rule.id}: ${node.target.join(" ")}: ${why.slice(0, 200)}`);
    }
  }
}

/** Opens every fold: what is hidden in one is looked at by no rule, and has no width. */
function unfold() {
  for (const fold of document.querySelectorAll("main details:not([open])")) fold.open = true;
}

/** The colours of the drawings against the page: no rule above looks into a drawing. */
function drawingColours() {
  const dot = document.createElement("canvas").getContext("2d", { willReadFrequently: true });
  const light = (colour) => {
    dot.fillStyle = colour;
    dot.fillRect(0, 0, 1, 1);
    const [r, g, b] = [...dot.getImageData(0, 0, 1, 1).data].map((c) =>
      c / 255 <= 0.04045 ? c / 255 / 12.92 : ((c / 255 + 0.055) / 1.055) ** 2.4);
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  const probe = document.body.appendChild(document.createElement("span"));
  const colour = (name) => {
    probe.style.color = "";
    probe.style.color = `var(${name}, transparent)`;
    return getComputedStyle(probe).color;
  };
  const page = light(getComputedStyle(document.documentElement).backgroundColor);
  const least = { "--fig-paper": 0, "--fig-surface": 0, "--fig-faint": 3 };
  const meant = ["omega", "momentum", "axis-min", "axis-mid", "axis-max", "separatrix", "wrong"];
  const found = [];
  for (const name of [...meant.map((word) => `--fig-${word}`), ...Object.keys(least)]) {
    const got = colour(name);
    const [low, high] = [light(got), page].sort((a, b) => a - b);
    const contrast = (high + 0.05) / (low + 0.05);
    if (got === "rgba(0, 0, 0, 0)") found.push(`${name} has no colour`);
    else if (contrast < (least[name] ?? 4.5)) found.push(`${name} stands out by ${contrast.toFixed(2)} only`);
  }
  const asked = new Set(document.querySelector("main").innerHTML.match(/--fig-[a-z-]+/g));
  const style = getComputedStyle(document.documentElement);
  for (const name of asked) {
    if (style.getPropertyValue(name) === "") found.push(`${name} is asked for by a drawing, but not in palette.css`);
  }
  probe.remove();
  return found;
}

/** Loads a page from the server, to its rest, and then without scripts; from disk it is loaded below. */
async function loads(name) {
  const page = await open(bases.http);
  await page.goto(bases.http + name);
  if (name !== "print.html") await comesToRest(page, "no-preference", fault);
  await page.quiet();
  await withoutScripts(open, bases.http, page, fault);
  await page.context().close();
}

/**
 * A page at every width in the light theme, by all rules at the widest and at the others by those that a width can change; then in the other themes for
 * what only they can show: colours. A theme moves nothing, so a width is looked at once. Of the text's colours, which are alike on all pages,
 * each page takes the dark theme and in turn one of the other three.
 */
async function looks(name) {
  const page = await open(bases.file, { theme: "light", reducedMotion: "reduce" });
  // The page for print repeats the others: its words and drawings are checked where they stand, and its widths but for the narrowest.
  const own = name !== "print.html";
  const shoot = async (theme, width) => {
    if (!shots || !own || !["light", "navy"].includes(theme)) return;
    await page.screenshot({ path: path.join(shots, `${path.basename(name, ".html")}-${theme}-${width}.png`), fullPage: true });
  };
  for (const width of own ? WIDTHS : WIDTHS.slice(0, 1)) {
    await page.setViewportSize({ width, height: 900 });
    await page.goto(bases.file + name); // anew: mdBook opens the contents by the width it starts with
    if (own && width === WIDTHS[0]) await comesToRest(page, "reduce", fault);
    await page.evaluate(() => document.fonts.ready);
    await page.evaluate(unfold);
    for (const what of await withFonts(page, await page.evaluate(tooWide))) fault(`${name}, ${width} px`, what);
    if (width === WIDTHS[0]) for (const what of await foreignLetters(page)) fault(name, what);
    const colours = width === WIDTHS[0] ? ["color-contrast"] : [];
    if (own) await rules(page, `${name}, light, ${width} px`, width === WIDTHS.at(-1) ? null : [...OF_WIDTH, ...colours]);
    await shoot("light", width);
  }
  for (const theme of own ? THEMES : []) {
    await page.evaluate((theme) => document.querySelector(`#mdbook-theme-list #mdbook-theme-${theme}`).click(), theme);
    await page.evaluate(() => document.getAnimations().forEach((glide) => glide.finish()));
    for (const what of await page.evaluate(drawingColours)) fault(`${name}, ${theme}`, what);
    if (theme === "navy" || theme === ["rust", "coal", "ayu"][pages.indexOf(name) % 3]) await rules(page, `${name}, ${theme}`, OF_THEME);
    await shoot(theme, WIDTHS.at(-1));
  }
  await page.context().close();
}

const tools = { open, bases, folder, pages, violations, fault, shots };
const jobs = [
  // The longest first, so that none is left alone at the end.
  ...await liveJobs(tools),
  { name: "figures", run: () => figures({ open, base: bases.file, pages, fault }) },
  { name: "questions", run: () => questions(open, bases.file, pages, fault) },
  ...Object.entries(bases).flatMap(([kind, base]) => [
    { name: `keyboard, ${kind}`, run: async () => keyboard(await open(base), base, fault) },
    { name: `search, ${kind}`, run: async () => search(await open(base), base, fault) },
    { name: `code folds, ${kind}`, run: async () => codeFolds(await open(base), base, fault) },
  ]),
  ...pages.map((name) => ({ name: `page ${name}`, run: async () => {
    await loads(name);
    await looks(name);
  } })),
].filter(({ name }) => words.length === 0 || words.some((word) => name.includes(word)));
if (jobs.length === 0) throw new Error(`no job's name has ${words.join(" or ")} in it`);

/** Does jobs, `atOnce` side by side: those during which a fault was found. */
async function work(jobs, atOnce) {
  const suspects = [];
  let next = 0;
  const hand = async () => {
    while (next < jobs.length) {
      const job = jobs[next++];
      const [begun, before] = [performance.now(), faults.size];
      try {
        await job.run();
      } catch (why) {
        fault(job.name, why.message);
      }
      if (faults.size > before) suspects.push(job);
      console.log(`${((performance.now() - begun) / 1000).toFixed(1).padStart(6)} s  ${job.name}`);
    }
  };
  await Promise.all(Array.from({ length: atOnce }, hand));
  return suspects;
}
const suspects = await work(jobs, atOnce);
// Once more, with nothing running beside them: a page is not at fault where the machine was busy.
if (suspects.length > 0) {
  console.log(`again, one by one: ${suspects.length} jobs`);
  faults.clear();
  await work(suspects, 1);
}

await browser.close();
server.close();
if (faults.size > 0) {
  console.error(`browser: ${faults.size} faults\n${[...faults].join("\n")}`);
  process.exit(1);
}
console.log(`browser: ${jobs.length} jobs, ${pages.length} pages, no fault`);
