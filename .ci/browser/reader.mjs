// Readers who use the book otherwise than with a mouse and scripts.
import { readFile } from "node:fs/promises";
import { asInEnglish } from "./widgets/controls.mjs";
import { finger } from "./widgets/hands.mjs";

/** By keyboard alone: past the controls, and each control itself. */
export async function keyboard(page, base, fault) {
  const where = `keyboard, ${base.slice(0, 4)}`;
  const wants = (what, holds) => holds || fault(where, what);
  const focused = (selector) =>
    page.evaluate((s) => document.activeElement?.matches(s) ?? false, selector);
  await page.goto(base + "index.html");

  await page.keyboard.press("Tab");
  wants("the first stop is the skip link", await focused(".skip"));
  wants("the skip link shows itself", await page.locator(".skip").evaluate((e) => e.getBoundingClientRect().top >= 0));
  await page.keyboard.press("Enter");
  wants("the skip link leads to the text", await focused("main"));

  async function tabTo(selector) {
    await page.goto(base + "index.html");
    for (let i = 0; i < 80; i += 1) {
      await page.keyboard.press("Tab");
      if (await focused(selector)) return true;
    }
    fault(where, `Tab does not reach ${selector}`);
    return false;
  }

  if (await tabTo("#mdbook-sidebar-toggle")) {
    const shown = () => page.getAttribute("#mdbook-sidebar-toggle", "aria-expanded");
    const before = await shown();
    await page.keyboard.press("Enter");
    wants("Enter on the menu button toggles the contents", (await shown()) !== before);
    await page.keyboard.press(" ");
    wants("Space on the menu button toggles them back", (await shown()) === before);
    const ring = await page.evaluate(() => getComputedStyle(document.activeElement).outlineStyle);
    wants("the focus is visible", ring !== "none");
  }
  if (await tabTo("#mdbook-theme-toggle")) {
    await page.keyboard.press("Enter");
    wants("Enter opens the themes", await page.isVisible("#mdbook-theme-list"));
    await page.keyboard.press("End");
    await page.keyboard.press("Enter");
    wants("a theme can be chosen", await page.evaluate(() => document.documentElement.classList.contains("ayu")));
    await page.keyboard.press("Escape");
    wants("Escape closes the themes", !(await page.isVisible("#mdbook-theme-list")));
  }
  if (await tabTo("#mdbook-search-toggle")) {
    await page.keyboard.press("Enter");
    wants("Enter opens the search", await page.isVisible("#mdbook-searchbar"));
    wants("and the search has the focus", await focused("#mdbook-searchbar"));
  }
  await page.context().close();
}

/** Programs are folded; one opens by itself, the button opens all, here and on the next page, and folds them again. */
export async function codeFolds(page, base, fault) {
  const where = `code, ${base.slice(0, 4)}`;
  const wants = (what, holds) => holds || fault(where, what);
  const seen = () =>
    page.evaluate(() => [...document.querySelectorAll("main pre > .language-rust")].filter((e) => !e.closest(".fold:not(.program)") && e.checkVisibility()).length);
  await page.goto(base + "two-arrows.html");
  wants(`no program stands open: ${await seen()}`, (await seen()) === 0);
  const all = await page.locator(".program").count();
  wants("there is code to fold", all > 1);
  await page.locator(".program > summary").first().click();
  wants("one opens by itself", (await seen()) === 1);
  await page.focus("#code-toggle");
  await page.keyboard.press("Enter");
  wants("the button opens all programs", (await seen()) === all);
  wants("and says so", (await page.getAttribute("#code-toggle", "aria-pressed")) === "true");
  await page.goto(base + "eulers-equations.html");
  wants("the next page remembers", (await seen()) > 0 || base.startsWith("file"));
  await page.goto(base + "two-arrows.html");
  if ((await page.getAttribute("#code-toggle", "aria-pressed")) === "false") await page.click("#code-toggle");
  await page.click("#code-toggle");
  wants("the button folds all again", (await seen()) === 0);
  await page.context().close();
}

/** What a reader would type is found, leads to its page, and shows no words that the page does not. */
export async function search(page, base, fault) {
  const where = `search, ${base.slice(0, 4)}`;
  const words = [["book", /highlight=book/], ["gyroscopic", /eulers|pitfalls|stepping|break|glossary/], ["R I R^T", /body-and-world/], ["tennis racket", /index|introduction|dzhanibekov|toss/], ["separatrix", /dzhanibekov/], ["coin", /coin/],
    ["inertia tensor", /matrix-mass/], ["polhode", /dzhanibekov/], ["quaternion", /notation/], ["momentum", /matrix-mass/], ["parallel axis", /principal-axes/], ["theta function", /closed-form/], ["energy", /eulers/], ["gap", /two-arrows/], ["slip", /eulers/], ["flip", /dzhanibekov|toss/], ["torque", /eulers/],
    ["precession", /a-top/], ["nutation", /a-top/], ["principal axes", /principal-axes/], ["moment of inertia", /matrix-mass/], ["Coriolis", /why/], ["hammer", /principal-axes/], ["Feynman", /coin/], ["middle axis", /why/],
    ["stable", /eulers/], ["phone", /your-own/], ["logarithm", /dzhanibekov/], ["rotation matrix", /body-and-world/]];
  // Of a server the first alone: its index is the same.
  for (const [k, [typed, leads]] of words.slice(0, base.startsWith("file") ? words.length : 4).entries()) {
    const bar = page.locator("#mdbook-searchbar");
    const hits = page.locator("#mdbook-searchresults li a");
    const follows = k < 2; // of the others it is enough to read where they lead
    if (k < 3) {
      await page.goto(base + "index.html");
      await page.keyboard.press("/");
    } else {
      await bar.fill("");
      await bar.press("Backspace"); // it listens to keys
      await hits.first().waitFor({ state: "detached" });
    }
    await bar.pressSequentially(typed);
    try {
      await hits.first().waitFor({ timeout: 60000 });
      const shown = await page.textContent("#mdbook-searchresults");
      if (/With JavaScript|A table of squares|Small plots, one for each|\bassert(_eq)?!|use tumbling|Checked by/.test(shown)) fault(where, `for \`${typed}\` it shows what no page shows`);
      if (!follows) {
        await page.waitForFunction((typed) => document.querySelector("#mdbook-searchresults-header").textContent.includes(`'${typed}'`), typed);
        const [file] = (await hits.first().getAttribute("href")).split(/[?#]/); // the words stand behind it
        if (!leads.test(file)) throw new Error();
        continue;
      }
      await hits.first().click();
      await page.waitForURL(leads);
    } catch {
      fault(where, `\`${typed}\` is not found, or what is found leads elsewhere: ${page.url()}`);
    }
  }
  await page.context().close();
}

/** Text, figures and formulas of an open page are there without scripts too. */
export async function withoutScripts(open, base, page, fault) {
  const count = () => {
    // The answers of questions wait only where there are scripts.
    const seen = (selector) =>
      [...document.querySelectorAll(selector)].filter((e) => e.getBoundingClientRect().width > 0 && !e.closest(".question, .question + .fig")).length;
    const lettersOf = (element) => element.innerText.replace(/\s/g, "").length;
    const awake = [...document.querySelectorAll("main .live-stage")].filter((stage) => stage.clientHeight > 0);
    return {
      // But for those of widgets that are awake.
      letters: lettersOf(document.querySelector("main")) - awake.reduce((sum, stage) => sum + lettersOf(stage), 0),
      figures: seen("main .fig svg"),
      formulas: seen("main math"),
      wide: document.documentElement.scrollWidth > document.documentElement.clientWidth,
    };
  };
  const expected = await page.evaluate(count);
  const bare = await open(base, { javaScriptEnabled: false, viewport: { width: 320, height: 900 } });
  await bare.goto(page.url());
  const got = await bare.evaluate(count);
  if (got.letters < 0.9 * expected.letters || got.figures !== expected.figures || got.formulas !== expected.formulas || got.wide) {
    fault(`${page.url().split("/").at(-1)} without scripts`, `shows ${JSON.stringify(got)}, with scripts ${JSON.stringify(expected)}`);
  }
  await bare.context().close();
}

/**
 * Every question of the first ten chapters: its answer waits, comes with a choice by mouse, key or finger, and says whether the choice was
 * right; a slider goes where it is dragged. Without scripts, and for print, all answers stand there.
 */
export async function questions(open, base, pages, fault) {
  let seen = 0;
  for (const name of pages.filter((name) => !["print.html", "index.html"].includes(name))) {
    if (!(await readFile(new URL(name, base), "utf8")).includes('class="question')) continue;
    const page = await open(base, { hasTouch: true });
    await page.goto(base + name);
    const boxes = page.locator(".question");
    for (let k = 0; k < await boxes.count(); k += 1, seen += 1) {
      const box = boxes.nth(k);
      const wants = (what, holds) => holds || fault(`${name}, question ${k + 1}`, what);
      const answer = box.locator("em").last();
      wants("its answer waits", !(await answer.isVisible()));
      const right = (await answer.textContent()).trim();
      await box.scrollIntoViewIfNeeded(); // so that what stands below it is awake
      const below = await box.evaluate((box) => [...document.querySelectorAll("main :is(h2, p, li, dd, pre, figcaption, svg text)")].filter((e) => {
        const down = e.getBoundingClientRect().top - box.getBoundingClientRect().bottom;
        return down >= 0 && down < 720 && !e.closest(".question") && e.checkVisibility(); // within a screen
      }).map((e) => e.innerText).join(" "));
      wants(`within a screen below it stands its answer, "${right}"`, !below.toLowerCase().includes(right.toLowerCase()));
      const address = page.url();
      const options = box.locator("ul button");
      if (await options.count() > 0) {
        const texts = await options.allTextContents();
        const wrong = options.nth(texts.findIndex((text) => text.trim() !== right));
        if (seen % 3 === 0) await wrong.click();
        else if (seen % 3 === 1) await wrong.tap();
        else {
          await wrong.focus();
          await page.keyboard.press("Enter");
        }
        const verdict = asInEnglish(await box.locator("[role=status]").textContent());
        wants(`a wrong choice is called wrong: ${verdict}`, /^\s*No\. /.test(verdict));
        wants("the right one is marked", (await box.locator(".question-right").textContent()).trim() === right && (await box.locator(".question-wrong").count()) === 1);
      } else {
        const slider = box.locator("input");
        const read = async () => parseFloat(asInEnglish(await box.locator("output").textContent()));
        await slider.scrollIntoViewIfNeeded();
        // How a control was last used sets how large it is, which moves what stands below: used once like this, it stays.
        const first = await slider.boundingBox();
        await finger(page, [first.x + 4, first.y + 4], [[first.x + 6, first.y + 4]]);
        const { x, y, width, height } = await slider.boundingBox();
        const at = (part) => [x + part * width, y + height / 2];
        await finger(page, at(0.2), Array.from({ length: 15 }, (_, i) => at(0.2 + 0.04 * i)));
        // A font that arrives moves the page a little; a page that scrolls goes further.
        const scrolled = Math.abs((await slider.boundingBox()).y - y);
        const most = Number(await slider.getAttribute("max"));
        wants(`dragged by a finger it stands at ${await read()} of ${most}, and has moved away by ${scrolled} px`, Math.abs((await read()) / most - 0.76) < 0.05 && scrolled < 10);
        await slider.focus();
        const before = await read();
        await page.keyboard.press("ArrowRight");
        wants("an arrow key moves it and turns no page", (await read()) > before && page.url() === address);
        await box.locator("button").click();
        const mark = await box.locator(".question-mark").evaluate((mark) => Number(mark.style.getPropertyValue("--at")));
        wants(`the mark stands at ${mark}, the answer is ${right}`, Math.abs(mark * most - parseFloat(asInEnglish(right))) < 1e-9);
      }
      wants("then the answer is there", await answer.isVisible());
      wants("and the page is", page.url() === address);
    }
    await page.context().close();
  }
  if (seen < 20) fault("questions", `there are ${seen} only`);
  for (const [name, options] of [["toss-a-book.html", { javaScriptEnabled: false }], ["print.html", {}]]) {
    const page = await open(base, options);
    await page.goto(base + name);
    const all = page.locator(".question em");
    const count = await all.count();
    for (let k = 0; k < count; k += 1) if (!(await all.nth(k).isVisible())) fault(name, "an answer is hidden where nothing can be chosen");
    if (count === 0) fault(name, "it has no question");
    await page.context().close();
  }
}
