// Every widget on every page: it loads when it comes into view, shows what the chapter says, and survives what readers do.

import { readFile } from "node:fs/promises";
import path from "node:path";
import { fileURLToPath } from "node:url";

const THEMES = ["light", "rust", "coal", "navy", "ayu"];

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

/** Sets a control as a reader does who moves it. */
const set = (page, selector, value) =>
  page.locator(selector).evaluate((element, value) => {
    element.value = value;
    element.dispatchEvent(new Event("input", { bubbles: true }));
    element.dispatchEvent(new Event("change", { bubbles: true }));
  }, String(value));
const shown = (page, widget, what) => page.locator(`#live-${widget} [data-shows=${what}]`).textContent();

async function twoArrows(page, wants) {
  const spin = "#two-arrows-spin";
  const numbers = () => Promise.all(["spin", "momentum", "gap"].map((what) => shown(page, "two-arrows", what)));

  // The chapter's own table, and the worked example.
  const rows = await page.locator("main table").first().locator("tbody tr").evaluateAll((rows) =>
    rows.map((row) => [...row.cells].map((cell) => cell.textContent.trim())));
  wants("the chapter has a table of angles", rows.length >= 5);
  for (const [angle, momentum, gap] of rows) {
    await set(page, spin, parseFloat(angle));
    const got = await numbers();
    wants(`at ${angle} it shows ${got}, the chapter ${momentum} and ${gap}`,
      parseFloat(got[0]) === parseFloat(angle) && got[1] === momentum && got[2] === gap);
  }
  await set(page, "#two-arrows-body", 1);
  await set(page, "#two-arrows-between", 1);
  await set(page, spin, 45);
  wants(`the worked example's box shows ${await numbers()}`, String(await numbers()) === "45.0°,52.4°,7.4°");

  // Both ends, all bodies.
  for (const body of [5, 4, 3, 2, 1, 0]) {
    for (const between of [2, 1, 0]) {
      await set(page, "#two-arrows-body", body);
      await set(page, "#two-arrows-between", between);
      for (const [end, angle] of [["-1e9", "0.0°"], ["1e9", "90.0°"]]) {
        await set(page, spin, end);
        wants(`body ${body}, axes ${between}: the arrows coincide at ${angle}, not ${await numbers()}`,
          String(await numbers()) === `${angle},${angle},0.0°`);
      }
      const broken = await page.locator("#live-two-arrows svg").evaluate((svg) => /NaN|Infinity|undefined/.test(svg.outerHTML));
      wants(`body ${body}, axes ${between}: every part of the drawing has a place`, !broken);
    }
  }

  // By keyboard, without turning the page.
  const address = page.url();
  await set(page, spin, 30);
  await page.locator(spin).focus();
  await page.keyboard.press("ArrowRight");
  wants("an arrow key turns the spin", (await numbers())[0] === "30.5°");
  await page.keyboard.press("End");
  wants("End turns it all the way", (await numbers())[0] === "90.0°");
  await page.keyboard.press("s");
  wants("keys stay with the widget", page.url() === address && !(await page.isVisible("#mdbook-searchbar")));
  wants("a screen reader is told", /gap/.test(await page.getAttribute(spin, "aria-valuetext")));
  await page.waitForTimeout(800);
  wants("and, at rest, in words", /Gap 0\.0°/.test(await page.textContent("#live-two-arrows .live-said")));

  // Dragged fast, far out of the drawing and back.
  await set(page, spin, 30);
  await page.locator("#live-two-arrows .live-handle").scrollIntoViewIfNeeded();
  const handle = await page.locator("#live-two-arrows .live-handle").boundingBox();
  const drawing = await page.locator("#live-two-arrows svg").boundingBox();
  await page.mouse.move(handle.x + handle.width / 2, handle.y + handle.height / 2);
  await page.mouse.down();
  for (let i = 0; i < 60; i += 1) {
    await page.mouse.move(drawing.x + drawing.width * (0.5 + 0.7 * Math.sin(1.7 * i)), drawing.y + drawing.height * (0.4 + 0.6 * Math.cos(2.3 * i)));
  }
  await page.mouse.move(drawing.x + 0.36 * drawing.width, drawing.y - 5);
  wants(`dragged straight up the spin stands at ${await numbers()}`, parseFloat((await numbers())[0]) >= 89);
  await page.mouse.up();
  const after = String(await numbers());
  await page.mouse.move(drawing.x + drawing.width, drawing.y + drawing.height);
  wants("let go, it stays", String(await numbers()) === after);
  await set(page, spin, 30);
}

async function yourBox(page, wants) {
  const wrong = "#live-your-box .live-wrong";
  wants("it begins with the chapter's box", (await shown(page, "your-box", "moments")) === "0.833, 1.083, 0.417");
  wants("its momentum is the chapter's", (await shown(page, "your-box", "momentum")) === "0.833, 1.083, 0");
  wants("its gap is the chapter's", (await shown(page, "your-box", "gap")) === "7.4°");
  await set(page, "#your-box-y", 0);
  wants("along an edge the gap is none", (await shown(page, "your-box", "gap")) === "0.0°");
  await set(page, "#your-box-y", 1);
  for (const [field, value, says] of [
    ["a", "0", "above zero"], ["b", "-1", "above zero"], ["c", "", "finite"], ["m", "0", "above zero"], ["a", "1e200", "f64"],
    ["m", "1e-320", "f64"], ["x", "", "finite"],
  ]) {
    const before = await page.locator(`#your-box-${field}`).inputValue();
    await set(page, `#your-box-${field}`, value);
    const text = (await page.isVisible(wrong)) ? await page.textContent(wrong) : "nothing";
    wants(`${field} = "${value}" is told wrong, by "${says}", not by "${text}"`, text.includes(says));
    await set(page, `#your-box-${field}`, before);
    wants("put right, it is right again", !(await page.isVisible(wrong)));
  }
  for (const value of ["1e-3", "50", "1e9"]) {
    await set(page, "#your-box-c", value);
    const broken = await page.locator("#live-your-box svg").evaluate((svg) => /NaN|Infinity|undefined/.test(svg.outerHTML));
    wants(`with an edge of ${value} m every part of the drawing has a place`, !broken);
  }
  await set(page, "#your-box-c", 3);
  await page.locator("#your-box-a").focus();
  const address = page.url();
  await page.keyboard.press("ArrowUp");
  await page.keyboard.press("ArrowLeft");
  wants("arrow keys change a number and turn no page", (await page.inputValue("#your-box-a")) === "2.1" && page.url() === address);
  await set(page, "#your-box-a", 2);
}

async function judge(page, wants) {
  const [verdict, wrong] = ["#live-judge .live-verdict", "#live-judge .live-wrong"];
  /** Waits for either; returns its text. */
  async function told(selector, pattern) {
    try {
      await page.waitForFunction(([s, p]) => {
        const e = document.querySelector(s);
        return !e.hidden && new RegExp(p).test(e.textContent);
      }, [selector, pattern], { timeout: 30000 });
    } catch {
      wants(`${selector} says ${pattern}, not "${(await page.textContent(selector)).slice(0, 200)}"`, false);
    }
  }
  await page.click("#judge-go");
  await told(wrong, "the file is empty");
  await set(page, "#judge-text", "t,wx,wy,wz\n0,1,2,3\n1,1,2\n");
  await page.click("#judge-go");
  await told(wrong, "line 3");
  await set(page, "#judge-text", "t,wx,wy,wz\n0,1,2,3\n1,1,2,3\n2,1,2,3\n");
  await page.click("#judge-go");
  await told(wrong, "moments are not known");
  await set(page, "#judge-moments", "1, 2");
  await told(wrong, "three numbers");
  await set(page, "#judge-moments", "1 2 3");
  await told(verdict, "no gyroscopic term");
  await set(page, "#judge-threshold", "-1");
  await told(wrong, "above zero");
  await set(page, "#judge-threshold", "0.01");
  await set(page, "#judge-moments", "");

  // A file of many pieces, and words that would be markup.
  let rows = "# engine: <img src=x onerror=alert(1)>\n# inertia: 1 2 3\nt,wx,wy,wz\n";
  for (let i = 0; i < 60000; i += 1) rows += `${0.01 * i},0.1,2,0.1\n`;
  await page.setInputFiles("#judge-file", { name: "large.csv", mimeType: "text/csv", buffer: Buffer.from(rows) });
  await told(verdict, "large.csv[^]*60000 rows");
  wants("what a record says is no markup", (await page.locator(`${verdict} img`).count()) === 0);

  // Dropped.
  const data = await page.evaluateHandle(() => {
    const data = new DataTransfer();
    data.items.add(new File(["# inertia: 1 2 3\nt,wx,wy,wz\n0,0,2,0\n1,0,2,0\n2,0,2,0\n"], "dropped.csv"));
    return data;
  });
  await page.dispatchEvent("#live-judge .live-drop", "drop", { dataTransfer: data });
  await told(verdict, "Nothing to judge: dropped.csv");

  // The picture. Every part has a place, and every curve its name.
  const picture = `${verdict} svg.live-picture`;
  async function drawn(name, lines, pattern, { curves, says, words }) {
    await page.setInputFiles("#judge-file", { name, mimeType: "text/csv", buffer: Buffer.from(lines) });
    await told(verdict, pattern);
    if ((await page.locator(picture).count()) !== 1) return wants(`${name} has one picture`, false);
    try {
      await page.waitForFunction((s) => document.querySelectorAll(`${s} path`).length > 0, picture, { timeout: 5000 });
    } catch {
      return wants(`${name} is drawn`, false);
    }
    const seen = await page.locator(picture).evaluate((svg) => {
      const [, , width, height] = svg.getAttribute("viewBox").split(" ").map(Number);
      const curves = Object.fromEntries([...svg.querySelectorAll("[data-shows]")].map((path) => [path.dataset.shows, path.getAttribute("d")]));
      const boxes = [...svg.querySelectorAll("path, circle")].map((part) => part.getBBox());
      return {
        curves,
        broken: /NaN|Infinity|undefined|null/.test(svg.outerHTML),
        outside: boxes.filter(({ x, y, width: w, height: h }) => !(x >= -1 && y >= -1 && x + w <= width + 1 && y + h <= height + 1)).length,
        says: [...svg.querySelectorAll("text")].map((text) => text.textContent),
        words: svg.getAttribute("aria-label"),
        flips: svg.querySelectorAll(".live-flip").length,
      };
    });
    wants(`${name}: every part of the drawing has a place`, !seen.broken && seen.outside === 0);
    wants(`${name}: it draws ${Object.keys(seen.curves)}, not ${curves}`, String(Object.keys(seen.curves).sort()) === String([...curves].sort()));
    for (const curve of curves) {
      const label = { momentum: "|L|" }[curve] ?? curve;
      wants(`${name}: ${curve} has its name beside it`, seen.says.some((text) => text.startsWith(label)));
    }
    for (const text of says) wants(`${name} says "${text}", not "${seen.says}"`, seen.says.some((said) => said.includes(text)));
    for (const text of words) wants(`${name} is told as "${text}", not "${seen.words}"`, seen.words.includes(text));
    return seen;
  }
  const head = "# inertia: 1 2 3\nt,wx,wy,wz\n";
  const errors = ["energy", "momentum"];

  // A term of the wrong sign drives the spin out of all bounds.
  let blown = head;
  for (let i = 0, size = 1; size < 1e140; i += 1, size *= 1.5) blown += `${0.1 * i},${0.1 * size},${(i % 2 ? -2 : 2) * size},${0.1 * size}\n`;
  const grown = await drawn("blown.csv", blown, "Failed: blown.csv", {
    curves: ["exact", "recorded", "allowed", ...errors], says: ["leaves the picture", "rad/s", "time"],
    words: ["leaves the picture", "the error of energy", "exponential: grows"],
  });
  // 1.5 times as fast every tenth of a second is 1.5^10 = 57.7 times as fast a second: so is |L|, and energy 57.7^2 = 3325 times.
  const rates = await page.locator(`${verdict} td:last-child`).allTextContents();
  wants(`blown.csv: growth is told plainly, not as ${rates.slice(0, 2)}`,
    rates[0].includes("grows tenfold every 0.284 s") && rates[1].includes("grows by a factor of 57.7 a second"));
  wants("blown.csv: no rate is a logarithm", rates.every((text) => !/e-?\d/.test(text)));
  wants("blown.csv: its curves go on to the end", grown?.curves.recorded?.split("L").length > 100);

  // Stuck: a straight line, where the exact spin moves.
  let stuck = head;
  for (let i = 0; i < 100; i += 1) stuck += `${0.1 * i},0.1,2,0.1\n`;
  const still = await drawn("stuck.csv", stuck, "Failed: stuck.csv", {
    curves: ["exact", "recorded", "allowed", ...errors], says: ["flips: 0, exact: "], words: ["axis 2, the middle one", "It changes sign 0 times"],
  });
  const heights = (d) => new Set(d?.split(/[ML]/).filter(Boolean).map((point) => point.split(" ")[1]));
  wants("stuck.csv: what is recorded stands still, what is exact does not",
    heights(still?.curves.recorded).size === 1 && heights(still?.curves.exact).size > 10);
  wants("stuck.csv: no flip is marked", still?.flips === 0);

  // Attitudes alone: half a turn every second about one axis of a sphere's kin.
  let turns = "# inertia: 1 2 3\nt,qw,qx,qy,qz\n";
  for (let i = 0; i < 100; i += 1) turns += `${0.1 * i},${Math.cos(0.05 * Math.PI * i)},0,0,${Math.sin(0.05 * Math.PI * i)}\n`;
  await drawn("turns.csv", turns, "turns.csv", {
    curves: ["exact", "recorded", "allowed", "direction", ...errors], says: ["spin about axis 3", "direction, rad"],
    words: ["from 3.142 to 3.142 rad/s", "the error of direction"],
  });
  wants("turns.csv: what attitudes do not tell is told", /does not tell/.test(await page.textContent(verdict)));

  // Options: limits by law, and a fitted start.
  const good = new URL("../../tests/data/engines/mujoco-4.0.0-rk4--middle.csv", import.meta.url);
  await page.setInputFiles("#judge-file", fileURLToPath(good));
  await told(verdict, "Passed: mujoco");
  await set(page, "#judge-threshold", "0.5, momentum=1e-6");
  await told(verdict, "Failed: mujoco");
  await page.waitForFunction((s) => [...document.querySelectorAll(`${s} text`)].filter((t) => / may$/.test(t.textContent)).length === 2, picture)
    .catch(() => wants("limits of their own are drawn by name", false));
  for (const [limits, says] of [["energy=0", "above zero"], ["mass=1", "there is no law `mass`"], ["energy=", "above zero"]]) {
    await set(page, "#judge-threshold", limits);
    await told(wrong, says);
  }
  for (const law of ["energy", "momentum", "direction", "unit", "separatrix", "phase", "consistency"]) {
    await set(page, "#judge-threshold", `${law}=0.125`);
    await told(verdict, `${{ momentum: "\\|L\\|", unit: "length", separatrix: "2 E I2", consistency: "turn against spin" }[law] ?? law}[^,;]* within 0.125`);
  }
  await set(page, "#judge-threshold", "0.01");
  await set(page, "#judge-fit", "1");
  await told(wrong, "two at least");
  await set(page, "#judge-fit", "16");
  await told(verdict, "fitted to the first 16 rows");
  await set(page, "#judge-fit", "");
  await told(verdict, "Passed: mujoco");

  await page.locator("#judge-example").focus();
  await page.keyboard.press("Enter");
  await told(verdict, "the example");
  await page.waitForFunction((s) => document.querySelectorAll(`${s} [data-shows]`).length > 3, picture, { timeout: 5000 })
    .catch(() => wants("the example is drawn", false));
  wants("the example has its lines in view", /qw/.test(await page.inputValue("#judge-text")));
}

const TESTS = { "two-arrows": twoArrows, "your-box": yourBox, judge };

/** What hangs out of its drawing or its frame. */
function cutOff(widget) {
  const stage = document.querySelector(`#live-${widget} .live-stage`);
  const found = [];
  if (stage.scrollWidth > stage.clientWidth) found.push(`the frame is ${stage.scrollWidth} px wide inside ${stage.clientWidth}`);
  for (const svg of stage.querySelectorAll("svg")) {
    const frame = svg.getBoundingClientRect();
    for (const text of svg.querySelectorAll("text")) {
      const box = text.getBoundingClientRect();
      if (box.left < frame.left - 1 || box.right > frame.right + 1 || box.top < frame.top - 1 || box.bottom > frame.bottom + 1) {
        found.push(`"${text.textContent}" is cut off`);
      }
    }
  }
  return found;
}

/** Tests all widgets; returns how many. */
export async function live({ open, bases, folder, pages, axe, fault, shots }) {
  const all = await placed(folder, pages);
  let count = 0;
  for (const { name, widgets } of all) {
    if (name === "print.html") {
      const page = await open(bases.file);
      await page.goto(bases.file + name);
      const visible = await page.locator(".live-stage:visible").count();
      if (visible > 0) fault(name, `${visible} widgets are live where all keeps still`);
      await page.context().close();
      continue;
    }
    const bare = await open(bases.file, { javaScriptEnabled: false });
    await bare.goto(bases.file + name);
    for (const widget of widgets) {
      const still = await bare.locator(`#live-${widget} .live-still`).isVisible();
      if (!still || await bare.locator(`#live-${widget} .live-stage`).isVisible()) {
        fault(`${name} without scripts`, `${widget} does not stand still`);
      }
    }
    await bare.context().close();

    for (const [kind, base] of Object.entries(bases)) {
      for (const widget of widgets) {
        const where = `${name}, ${widget}, ${kind}`;
        const wants = (what, holds) => holds || fault(where, what);
        const page = await open(base, { reducedMotion: kind === "file" ? "reduce" : "no-preference" });
        const asked = [];
        page.on("request", (request) => asked.push(path.basename(request.url())));
        await page.goto(base + name);
        const box = page.locator(`#live-${widget}`);
        const far = await box.evaluate((e) => e.getBoundingClientRect().top > innerHeight + 300);
        wants("it waits until it comes into view", !far || !asked.includes(`${widget}.wasm.js`));
        await box.scrollIntoViewIfNeeded();
        try {
          await page.waitForFunction((w) => document.querySelector(`#live-${w}`).dataset.state === "live", widget, { timeout: 20000 });
        } catch {
          wants(`it comes to life, not: ${await box.getAttribute("data-state")}`, false);
          continue;
        }
        const others = asked.filter((file) => file.endsWith(".wasm.js") && !widgets.some((w) => file === `${w}.wasm.js`));
        wants(`it loads no other module than the page's: ${others}`, others.length === 0);
        const before = await box.innerHTML();
        await page.waitForTimeout(200);
        wants("nothing moves until asked", before === (await box.innerHTML()));
        wants("there is a test for it", TESTS[widget]);
        await TESTS[widget]?.(page, wants);

        if (kind === "file") {
          await page.evaluate(() => {
            const contents = document.querySelector("#mdbook-sidebar-toggle-anchor");
            if (contents.checked) contents.click(); // they take the room of the text in a narrow window
          });
          for (const width of [320, 800, 1400]) {
            await page.setViewportSize({ width, height: 900 });
            await page.waitForTimeout(100);
            for (const what of await page.evaluate(cutOff, widget)) fault(`${where}, ${width} px`, what);
            for (const theme of THEMES) {
              if (width !== 800 && theme !== "light" && theme !== "navy") continue;
              await page.evaluate(([themes, theme]) => {
                document.documentElement.classList.remove(...themes);
                document.documentElement.classList.add(theme);
              }, [THEMES, theme]);
              await page.waitForFunction(() => document.getAnimations().length === 0);
              if (width === 800) {
                await page.evaluate(axe);
                const { violations } = await page.evaluate((w) => globalThis.axe.run(`#live-${w}`, { preload: false }), widget);
                for (const rule of violations) {
                  fault(`${where}, ${theme}`, `${rule.impact}: ${rule.id}: ${rule.nodes[0].target.join(" ")}: ${rule.nodes[0].failureSummary}`);
                }
              }
              if (shots) await box.screenshot({ path: path.join(shots, `live-${widget}-${theme}-${width}.png`) });
            }
          }
        }
        await page.context().close();
        count += 1;
      }
    }
  }
  return count;
}
