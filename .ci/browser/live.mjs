// Every widget on every page: it loads when it comes into view, shows what the chapter says, and survives what readers do.

import { readFile } from "node:fs/promises";
import path from "node:path";

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

  await page.locator("#judge-example").focus();
  await page.keyboard.press("Enter");
  await told(verdict, "the example");
  wants("the example has its lines in view", /qw/.test(await page.inputValue("#judge-text")));
}

/** Whether some part of a widget's drawings has no place, or a number that is none is shown. */
const broken = (page, widget) => page.locator(`#live-${widget}`).evaluate((box) =>
  [...box.querySelectorAll("svg")].some((svg) => /NaN|Infinity|undefined/.test(svg.outerHTML)) || /NaN|Infinity|undefined|null/.test(box.innerText));

async function pitfalls(page, wants) {
  const row = (which) => page.locator("#live-pitfalls .live-engine").nth(which);
  const of = (which, what) => row(which).locator(`[data-of=${what}]`).textContent();
  const start = (which) => page.click(`#live-pitfalls [data-start="${which}"]`);
  const end = () => page.click("#pitfalls-end");
  const text = await page.textContent("main");

  // The chapter's numbers, taken from its sentences.
  const [, low, high] = text.match(/sinks to (\d+ %) of its energy and rises to (\d+ %)/);
  await start(1);
  await end();
  wants(`with the frozen tensor the energy goes from ${low} to ${high}: ${await of(1, "energy")}`,
    (await of(1, "energy")).includes(`${low} to ${high}`));
  wants(`the right engine keeps it: ${await of(0, "energy")}`, (await of(0, "energy")).startsWith("100 %, off by"));
  const [, gap, energy] = text.match(/its spin is ([\d.]+°) off.*?its energy is (\d+ %)/);
  await start(2);
  wants(`momentum for spin starts ${gap} off with ${energy}: ${await of(2, "off")}`, (await of(2, "off")) === `${gap} off, energy ${energy}`);
  await set(page, "#pitfalls-body", 3);
  wants(`a ball forgives it: ${await of(2, "off")}`, (await of(2, "off")) === "0.0° off, energy 100 %");
  const [, flips, first, none] = text.match(/should flip (\d+) times, the first time after ([\d.]+ s).*?it flips (\d+) times/);
  await start(3);
  await end();
  wants(`right is ${flips} flips: ${await of(0, "flips")}`, (await of(0, "flips")) === `${flips} times, the first after ${first}; right: ${flips}`);
  wants(`without the term there are ${none}: ${await of(3, "flips")}`, (await of(3, "flips")) === `${none} times; right: ${flips}`);
  wants(`nor with momentum for spin: ${await of(2, "flips")}`, (await of(2, "flips")).startsWith("0 times"));
  await page.waitForTimeout(800);
  wants("at rest it is told in words", new RegExp(`Right would be ${flips} flips`).test(await page.textContent("#live-pitfalls .live-said")));

  // Played, or where motion is not wanted, in tenths; paused, and back.
  await page.click("#pitfalls-reset");
  wants("back at the start", (await shown(page, "pitfalls", "time")).startsWith("0.0 s"));
  const drawn = () => page.locator("#live-pitfalls svg .live-tip").first().getAttribute("cx");
  const before = await drawn();
  const reduced = await page.evaluate(() => matchMedia("(prefers-reduced-motion: reduce)").matches);
  await page.locator("#pitfalls-play").focus();
  await page.keyboard.press("Enter");
  await page.waitForTimeout(600);
  const then = await drawn();
  wants("played, it goes on", Number(then) > Number(before));
  if (reduced) {
    await page.waitForTimeout(300);
    wants("by itself nothing moves", (await drawn()) === then);
    wants("a tenth at a time", (await shown(page, "pitfalls", "time")).startsWith("2.0 s"));
  } else {
    await page.keyboard.press("Enter");
    const stood = await drawn();
    await page.waitForTimeout(300);
    wants("paused, it stands", (await drawn()) === stood && (await page.textContent("#pitfalls-play")) === "Play");
  }

  // All ends of all controls.
  for (const body of [3, 2, 1, 0]) {
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
  wants("a screen reader is told of the step", /s$/.test(await page.getAttribute("#pitfalls-step", "aria-valuetext")));
  await start(3);
  await end();
}

async function steps(page, wants) {
  const step = "#steps-step";
  const methods = await page.locator("#steps-method option").allTextContents();
  wants(`all methods of the library are there: ${methods.length}`, methods.length === 26);
  const choose = (name) => set(page, "#steps-method", methods.indexOf(name));

  // The chapter's table, at its two hundred steps.
  const names = { "Euler's": "explicit Euler", "three rotations": "three rotations", "Runge and Kutta's": "Runge-Kutta 4", "Moser and Veselov's, sixth order": "Moser-Veselov 6" };
  const table = await page.locator("main table").filter({ hasText: "better with half the step" }).locator("tbody tr").evaluateAll((rows) =>
    rows.map((row) => [...row.cells].map((cell) => cell.textContent.trim().replaceAll("’", "'"))));
  wants("the chapter has its table", table.length === 4);
  for (const [method, off, better] of table) {
    wants(`${method} method is there, as ${names[method]}`, methods.includes(names[method]));
    await choose(names[method]);
    await set(page, step, 6);
    const got = [await shown(page, "steps", "attitude"), await shown(page, "steps", "better")];
    wants(`${method}: ${got}, the chapter ${off}, ${better}`, got[0].replace("−", "-") === off.replace("−", "-") && got[1] === `${better} better`);
  }

  // Every method at every end, from every start.
  for (let which = 0; which < methods.length; which += 1) {
    await set(page, "#steps-method", which);
    for (const start of [0, 1, 2]) {
      await set(page, "#steps-start", start);
      await set(page, "#steps-body", start);
      for (const end of [0, 16]) {
        await set(page, step, end);
        wants(`${methods[which]}, start ${start}, step ${end}: everything has a number and a place`, !(await broken(page, "steps")));
        const reason = (await page.isVisible("#live-steps .live-wrong")) ? await page.textContent("#live-steps .live-wrong") : "refused: a step";
        wants(`a refusal says why: ${reason}`, /^refused: (a|the) ./.test(reason));
      }
    }
  }
  await choose("Moser-Veselov");
  await set(page, "#steps-start", 1);
  await set(page, "#steps-body", 0);
  await set(page, step, 16);
  wants("a step too long is refused", /^refused: .* was not found in \d+ rounds/.test(await page.textContent("#live-steps .live-wrong")));

  // By keyboard, with words.
  await set(page, "#steps-start", 0);
  await choose("Runge-Kutta 4");
  await set(page, step, 6);
  await page.locator(step).focus();
  await page.keyboard.press("ArrowRight");
  wants(`an arrow key lengthens the step: ${await shown(page, "steps", "step")}`, (await shown(page, "steps", "step")).endsWith("141 steps"));
  wants("a screen reader is told", /Attitude off by/.test(await page.getAttribute(step, "aria-valuetext")));
  await page.keyboard.press("ArrowLeft");
  await page.waitForTimeout(800);
  wants("and, at rest, in words", /Runge-Kutta 4, step 0.050 s/.test(await page.textContent("#live-steps .live-said")));
}

/** Modules that a widget asks besides its own. */
const BESIDE = { pitfalls: ["exact"], steps: ["exact"] };

const TESTS = { "two-arrows": twoArrows, "your-box": yourBox, judge, pitfalls, steps };

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
        const others = asked.filter((file) => file.endsWith(".wasm.js") && ![...widgets, ...(BESIDE[widget] ?? [])].some((w) => file === `${w}.wasm.js`));
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
