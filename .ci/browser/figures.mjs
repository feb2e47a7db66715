// Figures and formulas on a phone, and figures opened large: all of a drawing can be brought into view, its letters can be
// read, and it has the colours of its page.
import { withFonts } from "./fonts.mjs";

/** Whose letters no scrolling brings into view. Bounds come from every box around that cuts off what sticks out of it. */
function outOfReach() {
  const found = [];
  /** The part of the page in which something may be seen, by the boxes around it. */
  const around = (element) => {
    let [left, right] = [0, document.documentElement.clientWidth];
    for (let box = element.parentElement; box; box = box.parentElement) {
      if (getComputedStyle(box).overflowX === "visible") continue;
      const { left: at } = box.getBoundingClientRect();
      left = Math.max(left, at + box.clientLeft);
      right = Math.min(right, at + box.clientLeft + box.clientWidth);
    }
    return [left, right];
  };
  for (const frame of document.querySelectorAll("main .fig-frame")) {
    const name = frame.closest(".fig").id;
    const [left, right] = around(frame);
    const box = frame.getBoundingClientRect();
    if (box.width === 0) continue;
    if (box.left < left - 1 || box.right > right + 1) {
      found.push({ what: `${name}: its frame from ${box.left} to ${box.right} is seen from ${left} to ${right} only` });
    }
    // Where all its own room is, scrolled to either end.
    const [from, to] = [box.left + frame.clientLeft - frame.scrollLeft, box.left + frame.clientLeft - frame.scrollLeft + frame.scrollWidth];
    if (frame.scrollWidth > frame.clientWidth + 1 && !/auto|scroll/.test(getComputedStyle(frame).overflowX)) found.push({ what: `${name} does not scroll` });
    const drawing = frame.querySelector("svg").getBoundingClientRect();
    for (const text of frame.querySelectorAll("text")) {
      const { left: at, right: end, width } = text.getBoundingClientRect();
      if (width === 0) continue;
      if (at < Math.max(from, drawing.left) - 1 || end > Math.min(to, drawing.right) + 1) {
        text.dataset.fault = found.length + 1;
        found.push({ what: `${name}: "${text.textContent}" is cut off`, marked: text.dataset.fault });
      }
    }
  }
  for (const stage of document.querySelectorAll("main .live-stage")) {
    const [left, right] = around(stage);
    const box = stage.getBoundingClientRect();
    if (box.width > 0 && (box.left < left - 1 || box.right > right + 1)) found.push({ what: "a widget's frame is cut off" });
  }
  return found;
}

/** Drawings with letters below 11 px, and formulas that scroll and do not say so. */
function unread() {
  const found = [];
  for (const svg of document.querySelectorAll("main .fig-frame > svg")) {
    const scale = svg.getBoundingClientRect().width / svg.viewBox.baseVal.width;
    const least = Math.min(...[...svg.querySelectorAll("text")].map((text) => scale * parseFloat(getComputedStyle(text).fontSize)));
    if (scale > 0 && least < 10.995) found.push(`${svg.closest(".fig").id} has letters of ${least.toFixed(1)} px`);
  }
  for (const formula of document.querySelectorAll("main .math-display")) {
    const says = getComputedStyle(formula, "::before").content;
    if (formula.scrollWidth > formula.clientWidth + 1 && !says.includes("Scroll")) found.push(`scrolls without a cue: ${formula.textContent}`);
  }
  return found;
}

/** A figure that answers a question waits for it: as if all were answered. */
const answered = (page) => page.evaluate(() => { for (const question of document.querySelectorAll(".question")) question.dataset.state = "told"; });

/** From each theme, a drawing opened over its page and by its address. */
async function themed({ open, base, fault }) {
  const colours = (element) => [getComputedStyle(element).color, getComputedStyle(document.documentElement).backgroundColor].join(" on ");
  for (const theme of ["light", "rust", "coal", "navy", "ayu"]) {
    const page = await open(base, { theme, colorScheme: ["light", "rust"].includes(theme) ? "dark" : "light" });
    const wants = (what, holds) => holds || fault(`figure opened large, ${theme}`, what);
    await page.goto(`${base}two-arrows.html`);
    await answered(page);
    const expected = await page.locator("body").evaluate(colours);
    const link = page.locator("a.fig-large").first();
    const address = await link.evaluate((a) => a.href);
    await link.click();
    const drawing = page.locator("dialog svg");
    wants("it opens over the page", await drawing.isVisible());
    wants("in the page's colours", (await drawing.evaluate(colours)) === expected);
    await page.keyboard.press("Escape");
    await page.locator("dialog").waitFor({ state: "detached" });
    wants("it is back in its place", (await page.locator("#fig-two-arrows .fig-frame > svg").count()) === 1);
    await page.goto(address);
    const got = await page.locator(":root").evaluate(colours);
    wants(`by its address it is ${got}, the page ${expected}`, got === expected);
    await page.context().close();
  }
}

/** Every page's figures at the width of a phone; and each drawing opened by its link. */
export async function figures({ open, base, pages, fault }) {
  await themed({ open, base, fault });
  const page = await open(base, { viewport: { width: 390, height: 844 } });
  const large = new Set();
  for (const name of pages.filter((name) => name !== "print.html")) {
    await page.goto(base + name);
    await answered(page);
    await page.evaluate(() => document.fonts.ready);
    for (const what of await withFonts(page, await page.evaluate(outOfReach))) fault(`${name}, 390 px`, what);
    await page.evaluate(() => { for (const fold of document.querySelectorAll("main details")) fold.open = true; });
    for (const what of await page.evaluate(unread)) fault(`${name}, 390 px`, what);
    for (const link of await page.locator("a.fig-large").evaluateAll((all) => all.map((a) => a.href.split("#")[0]))) large.add(link);
  }
  await page.context().close();
  for (const [width, height] of [[1400, 900], [390, 844]]) {
    const alone = await open(base, { viewport: { width, height }, colorScheme: "dark" });
    for (const link of large) {
      await alone.goto(link);
      const seen = await alone.evaluate(() => {
        const svg = document.documentElement;
        const box = svg.getBBox();
        const to = svg.getScreenCTM();
        const { width, height } = svg.viewBox.baseVal;
        const { x, y } = svg.viewBox.baseVal;
        return {
          left: to.a * x + to.e, top: to.d * y + to.f, width: to.a * width, height: to.d * height, drawn: box.width > 0,
          ink: getComputedStyle(svg).color, wide: innerWidth, high: innerHeight,
        };
      });
      const file = link.split("/").at(-1);
      const full = Math.max(seen.width / seen.wide, seen.height / seen.high);
      if (!seen.drawn || !(full > 0.97 && full < 1.01)) fault(`${file} opened, ${width} px`, `it takes ${(100 * full).toFixed(0)} % of the window`);
      if (Math.abs(2 * seen.left + seen.width - seen.wide) > 3 || Math.abs(2 * seen.top + seen.height - seen.high) > 3) {
        fault(`${file} opened, ${width} px`, `it is not in the middle: ${JSON.stringify(seen)}`);
      }
      if (seen.ink !== "rgb(230, 237, 243)") fault(`${file} opened, ${width} px`, `by night its ink is ${seen.ink}`);
    }
    await alone.context().close();
  }
  return large.size;
}
