// Opens every page of the built book, as a file and from a local server, and fails on whatever a reader
// would stumble over: a request to any other place, a word on the console, a page that scrolls
// sideways, a control the keyboard cannot reach, a rule of accessibility broken.
//
//     node check.mjs [PAGES] [--shots DIR] [--live] [--figures]
//
// With --live it looks at the widgets alone, of which ONLY=NAME takes one; with --figures at the figures on a phone and opened large.

import { readFile, readdir, mkdir } from "node:fs/promises";
import { createRequire } from "node:module";
import path from "node:path";
import { pathToFileURL, fileURLToPath } from "node:url";
import { chromium } from "playwright-core";
import { figures } from "./figures.mjs";
import { live } from "./live.mjs";
import { codeFolds, keyboard, search, withoutScripts } from "./reader.mjs";
import { serve } from "./serve.mjs";

const THEMES = ["light", "rust", "coal", "navy", "ayu"];
const WIDTHS = [320, 800, 1400];
const HERE = path.dirname(fileURLToPath(import.meta.url));

const words = process.argv.slice(2);
const at = words.indexOf("--shots");
const shots = at >= 0 ? path.resolve(words.splice(at, 2)[1]) : null;
const asks = (word) => words.includes(word) && words.splice(words.indexOf(word), 1).length > 0;
const onlyWidgets = asks("--live");
const onlyFigures = asks("--figures");
const onlyLive = onlyWidgets || onlyFigures;
const folder = path.resolve(words[0] ?? path.join(HERE, "../../book/html"));
const names = (await readdir(folder)).filter((name) => name.endsWith(".html")).sort();
const pages = names.filter((name) => name !== "toc.html"); // that one is a frame of the others
if (pages.length < 3) throw new Error(`no book in ${folder}: build it first`);
if (shots) await mkdir(shots, { recursive: true });

const faults = new Set();
const fault = (where, what) => faults.add(`${where}: ${what}`);

const server = await serve(folder);
const bases = { file: pathToFileURL(folder).href + "/", http: server.base };
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
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
  const page = await context.newPage();
  const tell = (what) => fault(page.url().replace(base, ""), what);
  page.on("request", (request) => {
    const url = request.url();
    if (!url.startsWith(base) && !/^(data|blob):/.test(url)) tell(`asks for ${url}`);
  });
  page.on("requestfailed", (request) => {
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
    found.push(`the page scrolls sideways (${document.documentElement.scrollWidth} px)`);
  }
  const boxes = ".math-display, .fig-frame, .table-wrapper, pre";
  for (const element of document.querySelectorAll("main *")) {
    if (element.closest(boxes) && !element.matches(boxes)) continue;
    const box = element.getBoundingClientRect();
    if (box.width > 0 && (box.right > width + 1 || box.left < -1)) {
      found.push(`<${element.localName}> is cut off: ${element.textContent.trim().slice(0, 60)}`);
    }
  }
  return found.slice(0, 5);
}

const axe = await readFile(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
async function rules(page, where) {
  await page.evaluate(axe);
  const { violations } = await page.evaluate(() => globalThis.axe.run(document, { preload: false }));
  for (const rule of violations) {
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

let looks = 0;
for (const name of onlyLive ? [] : pages) {
  for (const base of Object.values(bases)) {
    const page = await open(base);
    await page.goto(base + name);
    await page.waitForLoadState("networkidle");
    await page.context().close();
  }
  for (const theme of THEMES) {
    const page = await open(bases.file, { theme, reducedMotion: "reduce" });
    for (const width of WIDTHS) {
      const where = `${name}, ${theme}, ${width} px`;
      await page.setViewportSize({ width, height: 900 });
      await page.goto(bases.file + name); // anew: mdBook opens the contents by the width it starts with
      await page.evaluate(() => document.fonts.ready);
      await page.evaluate(unfold);
      for (const what of await page.evaluate(tooWide)) fault(where, what);
      if (width === WIDTHS[0]) {
        for (const what of await page.evaluate(drawingColours)) fault(`${name}, ${theme}`, what);
      }
      // The print page repeats the others: its words are checked where they stand.
      if (name !== "print.html" && (width === 1400 || theme === "light")) await rules(page, where);
      if (shots && name !== "print.html" && ["light", "navy"].includes(theme)) {
        const file = `${path.basename(name, ".html")}-${theme}-${width}.png`;
        await page.screenshot({ path: path.join(shots, file), fullPage: true });
      }
      looks += 1;
    }
    await page.context().close();
  }
}

const drawings = onlyWidgets ? 0 : await figures({ open, base: bases.file, pages, fault });
if (onlyFigures) pages.length = 0;
const widgets = await live({ open, bases, folder, pages, axe, fault, shots });

for (const base of onlyLive ? [] : Object.values(bases)) {
  await keyboard(await open(base), base, fault);
  await search(await open(base), base, fault);
  await codeFolds(await open(base), base, fault);
}
if (!onlyLive) await withoutScripts(open, bases.file, pages, fault);

await browser.close();
server.close();
for (const line of faults) console.error(line);
if (faults.size > 0) {
  console.error(`browser: ${faults.size} faults`);
  process.exit(1);
}
console.log(`browser: ${pages.length} pages from disk and from a server, ${looks} looks, ${drawings} drawings opened, ${widgets} widgets tried, no fault`);
