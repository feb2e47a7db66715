// Every widget on every page: it loads when it comes into view, shows what the chapter says, and survives what readers do.

import { readFile } from "node:fs/promises";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { byHand, finger, frames, pass, pitfallsDrawn, tumbleDrawn, tumblePlayed, tumbleRolls } from "./drawn.moving.mjs";
import { arrowsDrawn, boxDrawn, read, stepsDrawn } from "./drawn.flat.mjs";

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
/** Waits until the widget has said a text that matches, to those who do not see it. */
const said = async (page, widget, pattern) => {
  const place = page.locator(`#live-${widget} .live-said`);
  const holds = await page.waitForFunction(([w, p]) => new RegExp(p).test(document.querySelector(`#live-${w} .live-said`).textContent),
    [widget, pattern.source], { timeout: 60000 }).then(() => true, () => false);
  return [`it says ${pattern}, not "${await place.textContent()}"`, holds];
};
const shown = (page, widget, what) => page.locator(`#live-${widget} [data-shows=${what}]`).textContent();

async function twoArrows(page, wants) {
  const spin = "#two-arrows-spin";
  const numbers = () => Promise.all(["spin", "momentum", "gap"].map((what) => shown(page, "two-arrows", what)));

  // The chapter's own numbers, and the worked example.
  const text = (await page.textContent("main")).replace(/\s+/g, " ");
  const [, ...pairs] = text.match(/at (\d+)° of spin the momentum stands at ([\d.]+°), and at (\d+)° it stands at ([\d.]+°)/) ?? [];
  wants("the chapter has two spins and their momenta", pairs.length === 4);
  for (const [angle, momentum] of [pairs.slice(0, 2), pairs.slice(2)]) {
    await set(page, spin, angle);
    const got = await numbers();
    wants(`at ${angle}° it shows ${got}, the chapter ${momentum}`, parseFloat(got[0]) === Number(angle) && got[1] === momentum
      && Math.abs(parseFloat(got[1]) - parseFloat(got[0]) - parseFloat(got[2])) < 0.11);
  }
  await set(page, "#two-arrows-body", 1);
  await set(page, "#two-arrows-between", 1);
  await set(page, spin, 45);
  wants(`the worked example's box shows ${await numbers()}`, String(await numbers()) === "45.0°,52.4°,7.4°");

  await arrowsDrawn(page, set, shown, wants);

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
  wants(...await said(page, "two-arrows", /Gap 0\.0°/));

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

  // By a finger, in many small moves: the arrow follows to the end, and the page stays.
  const ring = await page.locator("#live-two-arrows .live-handle").boundingBox();
  const origin = await page.locator("#live-two-arrows .live-point").first().boundingBox();
  const [cx, cy] = [origin.x + origin.width / 2, origin.y + origin.height / 2];
  const start = [ring.x + ring.width / 2, ring.y + ring.height / 2];
  const far = Math.hypot(start[0] - cx, start[1] - cy);
  const along = (degrees) => [cx + far * Math.cos(degrees * Math.PI / 180), cy - far * Math.sin(degrees * Math.PI / 180)];
  const scrolled = await finger(page, start, Array.from({ length: 30 }, (_, i) => along(30 + i + 1)));
  wants(`dragged by a finger to 60° the spin stands at ${await numbers()}`, Math.abs(parseFloat((await numbers())[0]) - 60) < 1);
  wants(`and the page has scrolled by ${scrolled} px`, scrolled === 0);
  await set(page, spin, 30);
}

/** The book of the first screen: it flips about its middle axis and about no other, goes on by itself only where it may, and turns under a finger. */
async function toss(page, wants) {
  const canvas = page.locator("#live-toss canvas");
  const shows = () => canvas.evaluate((canvas) => canvas.shows);
  const play = "#toss-play";
  wants("less motion preferred, it begins at rest", (await page.textContent(play)) === "Play" && (await shows()).t === 0);
  await byHand(page);
  await page.click(play);
  wants("asked to, it plays", (await page.textContent(play)) === "Pause");
  // One clock for all three, which never goes back, however fast the machine is.
  let now = await page.evaluate(() => performance.now());
  for (const [which, axis, flips] of [["across", 0, true], ["spine", 2, false], ["through", 1, false]]) {
    await page.click(`[data-toss=${which}]`);
    await page.waitForFunction(() => window.byHand.waiting.size > 0);
    let [least, most, read] = [1, -1, 0];
    for (let i = 0; i < 60; i += 1) {
      await page.evaluate((now) => { for (let k = 1; k <= 10; k += 1) window.byHand.step(now + 70 * k); }, now);
      now += 700;
      const { turned, titles } = await shows();
      // On the screen y points down: from the way across to the way down is a right-handed turn, and in a mirror the other.
      const mirrored = titles.filter(([across, down]) => across[0] * down[1] <= across[1] * down[0]);
      wants(`${which}: no title is mirrored: ${JSON.stringify(mirrored)}`, mirrored.length === 0);
      read += titles.length;
      [least, most] = [Math.min(least, turned[axis][axis]), Math.max(most, turned[axis][axis])];
      const size = Math.hypot(...turned[axis]);
      wants(`${which}: what is drawn is turned, not stretched: ${size}`, Math.abs(size - 1) < 1e-9);
    }
    wants(`${which}: a title is seen`, read > 0);
    wants(`tossed ${which} its axis points along itself from ${least} to ${most}`, flips ? least < -0.95 && most > 0.95 : least > 0.95);
  }
  await page.click(play);
  const { t } = await shows();
  await pass(page, 3, 50);
  wants("paused, it rests", (await shows()).t === t && (await page.textContent(play)) === "Play");
  await page.evaluate(() => window.byHand.end());
  const box = await canvas.boundingBox();
  const at = (x, y) => [box.x + x * box.width, box.y + y * box.height];
  const before = await canvas.evaluate((canvas) => canvas.toDataURL());
  const scrolled = await finger(page, at(0.5, 0.5), Array.from({ length: 20 }, (_, i) => at(0.5 + 0.01 * i, 0.5 - 0.02 * i)));
  wants(`under a finger the page does not scroll: ${scrolled} px`, scrolled === 0);
  wants("and the book is seen from elsewhere", (await canvas.evaluate((canvas) => canvas.toDataURL())) !== before);
}

/** Where motion is welcome the book tumbles as soon as it is seen, and stops when told to. */
async function tossPlay(page, wants) {
  const t = () => page.locator("#live-toss canvas").evaluate((canvas) => canvas.shows.t);
  await page.waitForFunction(() => document.querySelector("#live-toss canvas").shows.t > 0.05)
    .catch(() => wants("it tumbles by itself", false));
  await page.click("#toss-play");
  const stood = await t();
  await frames(page, 12);
  wants("paused, it rests", (await t()) === stood);
}

async function yourBox(page, wants) {
  const wrong = "#live-your-box .live-wrong";
  wants("it begins with the chapter's box", (await shown(page, "your-box", "moments")) === "0.833, 1.083, 0.417");
  wants("its momentum is the chapter's", (await shown(page, "your-box", "momentum")) === "0.833, 1.083, 0");
  wants("its gap is the chapter's", (await shown(page, "your-box", "gap")) === "7.4°");
  await set(page, "#your-box-y", 0);
  wants("along an edge the gap is none", (await shown(page, "your-box", "gap")) === "0.0°");
  await set(page, "#your-box-y", 1);
  await boxDrawn(page, set, shown, wants);
  for (const [field, value, says] of [
    ["a", "0", "above zero"], ["b", "-1", "above zero"], ["c", "", "Type a number"], ["m", "0", "above zero"], ["a", "1e200", "floating-point"],
    ["m", "1e-320", "floating-point"], ["x", "", "Type a number"],
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

  // The spin's tip follows a finger, its size stays, and onto an axis the gap closes without a leap.
  const values = () => Promise.all(["x", "y", "z"].map(async (axis) => Number(await page.inputValue(`#your-box-${axis}`))));
  const gap = async () => parseFloat(await shown(page, "your-box", "gap"));
  for (const [axis, value] of [["x", 1], ["y", 1], ["z", 0]]) await set(page, `#your-box-${axis}`, value);
  const drawing = page.locator("#live-your-box svg");
  await drawing.scrollIntoViewIfNeeded();
  const middle = async (selector) => {
    const box = await drawing.locator(selector).boundingBox();
    return [box.x + box.width / 2, box.y + box.height / 2];
  };
  const frame = await drawing.boundingBox();
  const centre = [frame.x + frame.width / 2, frame.y + frame.height / 2];
  const x = await drawing.locator("text", { hasText: /^x$/ }).evaluate((text) => [Number(text.getAttribute("x")), Number(text.getAttribute("y")) - 5]);
  const far = Math.hypot(x[0] - frame.width / 2, x[1] - frame.height / 2);
  const leads = [(x[0] - frame.width / 2) / far, (x[1] - frame.height / 2) / far];
  const begin = await middle(".live-handle");
  const gaps = [];
  for (let part = 0.1; part < 1.01; part += 0.1) {
    const tip = await middle(".live-handle");
    const to = [0, 1].map((k) => begin[k] + part * (centre[k] + 0.97 * far * leads[k] - begin[k]));
    const scrolled = await finger(page, tip, [to]);
    wants(`under a finger the page does not scroll: ${scrolled} px`, scrolled === 0);
    wants(`the size of the spin stays: ${await values()}`, Math.abs(Math.hypot(...await values()) - Math.SQRT2) < 0.01);
    gaps.push(await gap());
  }
  wants(`dragged from between the axes the gap closes without a leap: ${gaps}`, gaps[0] > 5 && gaps.every((gap, i) => i === 0 || Math.abs(gap - gaps[i - 1]) < 4));
  const before = await drawing.evaluate((svg) => svg.innerHTML);
  await finger(page, [frame.x + 15, frame.y + 15], [[frame.x + 60, frame.y + 40]]);
  wants("dragged elsewhere the box turns", (await drawing.evaluate((svg) => svg.innerHTML)) !== before);
}

async function judge(page, wants) {
  const [verdict, wrong] = ["#live-judge .live-verdict", "#live-judge .live-wrong"];
  /** Waits for either; returns its text. */
  async function told(selector, pattern) {
    try {
      await page.waitForFunction(([s, p]) => {
        const e = document.querySelector(s);
        return !e.hidden && new RegExp(p).test(e.textContent);
      }, [selector, pattern], { timeout: 60000 });
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

  // The rows that README.md begins with say too little.
  const readme = await readFile(new URL("../../README.md", import.meta.url), "utf8");
  const [, three] = readme.match(/```text\n(# inertia[^]*?)```/);
  await set(page, "#judge-text", three);
  await page.click("#judge-go");
  await told(verdict, "^Too short to judge: the lines above[^]*eight rows at least");
  const ink = () => page.locator(`${verdict} .live-outcome`).evaluate((line) => [getComputedStyle(line).color, getComputedStyle(line.parentElement).color]);
  const plain = await ink();
  wants(`what did not fail has the colour of the text: ${plain}`, plain[0] === plain[1]);

  // A file of many pieces, and words that would be markup.
  let rows = "# engine: <img src=x onerror=alert(1)>\n# inertia: 1 2 3\nt,wx,wy,wz\n";
  for (let i = 0; i < 60000; i += 1) rows += `${0.01 * i},0.1,2,0.1\n`;
  await page.setInputFiles("#judge-file", { name: "large.csv", mimeType: "text/csv", buffer: Buffer.from(rows) });
  await told(verdict, "large.csv[^]*60000 rows");
  const red = await ink();
  wants(`what failed has a colour of its own: ${red}`, red[0] !== red[1] && red[1] === plain[1]);
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
      await page.waitForFunction((s) => document.querySelectorAll(`${s} path`).length > 0, picture, { timeout: 60000 });
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
  wants("turns.csv: what attitudes alone leave open is named", /nothing is known of turn against spin/.test(await page.textContent(verdict)));

  // Options: limits by law, and a fitted start.
  const good = new URL("../../crates/judge/data/mujoco-4.0.0-rk4--middle.csv", import.meta.url);
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

  // A long record: how far it is read is shown, and said no more than by quarters; another file ends it, and so does a button.
  const several = await Promise.all(["mujoco-4.0.0-rk4--middle", "rapier3d-f64-0.36.1--major"].map(async (name) =>
    ({ name: `${name}.csv`, mimeType: "text/csv", buffer: await readFile(new URL(`../../crates/judge/data/${name}.csv`, import.meta.url)) })));
  const reading = "#live-judge .live-reading";
  const long = (where) => page.locator(where).evaluate((element) => {
    const lines = Array.from({ length: 800000 }, (_, i) => `${i},0.1,2,0.1\n`);
    const data = new DataTransfer();
    data.items.add(new File(["# inertia: 1 2 3\n# dt: 0.01 s\nstep,wx,wy,wz\n", ...lines], "long.csv"));
    // What is not prevented would make the browser leave the page for the file.
    return ["dragenter", "dragover", "drop"].map((kind) =>
      element.dispatchEvent(new DragEvent(kind, { bubbles: true, cancelable: true, dataTransfer: data }))).every((left) => !left);
  }, undefined, { timeout: 60000 });
  // However quick the page is, it keeps what it has shown and is about to say.
  const log = await page.locator("#live-judge").evaluateHandle((box) => {
    const [said, reading, bar] = [".live-said", ".live-reading", "progress"].map((part) => box.querySelector(part));
    const log = { says: [], shows: [] };
    new MutationObserver(() => said.dataset.next && log.says.push(said.dataset.next)).observe(said, { attributeFilter: ["data-next"] });
    const hidden = () => [".live-verdict", ".live-wrong"].every((part) => box.querySelector(part).hidden);
    new MutationObserver(() => !reading.hidden && log.shows.push({ text: reading.textContent, bar: bar.position, alone: hidden() }))
      .observe(reading, { childList: true, subtree: true, characterData: true });
    return log;
  });
  wants("a file over the heading is taken", await long("main h1"));
  await told(reading, "Judging long.csv: [\\d.]+ of 13\\.\\d MB are read");
  await page.setInputFiles("#judge-file", several[0]);
  await told(verdict, "Passed: mujoco");
  wants("the long record has ended", !(await page.isVisible(reading)));
  await frames(page, 60);
  wants("and does not come back", /Passed: mujoco/.test(await page.textContent(verdict)) && !(await page.isVisible(reading)));
  // The button is pressed as soon as it can be seen.
  await page.evaluate(() => {
    const stop = document.querySelector("#judge-stop");
    const watch = new MutationObserver(() => {
      if (!stop.checkVisibility()) return;
      watch.disconnect();
      stop.focus();
      stop.click();
    });
    watch.observe(document.querySelector("#live-judge"), { subtree: true, childList: true, attributes: true });
  });
  await long("body");
  await told(wrong, "Stopped: long.csv is not judged");
  wants("stopped, it shows no verdict, and the keyboard has its place", !(await page.isVisible(verdict)) && !(await page.isVisible(reading)) &&
    await page.evaluate(() => document.activeElement.id === "judge-go"));
  await long("#live-judge");
  await told(verdict, "long.csv[^]*800000 rows");
  const { says, shows } = await log.jsonValue();
  wants(`of long records it is said how far they are: ${says.join(" | ")}`, says.some((text) => text.startsWith("Judging long.csv: ")));
  wants(`and not more than five times each: ${says.join(" | ")}`, says.filter((text) => text.startsWith("Judging")).length <= 15);
  wants("while one is read its bar stands between the ends", shows.some(({ bar }) => bar > 0 && bar < 1));
  for (const { text, bar, alone } of shows) {
    const [, read, whole] = text.match(/: ([\d.]+) of ([\d.]+) MB/) ?? [];
    wants(`the bar is where the words are: ${bar}, ${text}`, Math.abs(bar - read / whole) < 0.01);
    wants("nothing of an earlier record is shown meanwhile", alone);
  }
  wants("words that are dragged are none of its business", await page.locator("main h1").evaluate((element) => {
    const data = new DataTransfer();
    data.setData("text/plain", "1,2,3");
    return element.dispatchEvent(new DragEvent("drop", { bubbles: true, cancelable: true, dataTransfer: data }));
  }));

  // Several at once: a line for each, and the whole of the one that is chosen.
  const records = "#live-judge .live-records";
  await page.setInputFiles("#judge-file", [...several, { name: "<b>none</b>.csv", mimeType: "text/csv", buffer: Buffer.from("t,wx\n0,1\n") }]);
  await told(records, "Cannot be judged");
  const each = await page.locator(`${records} li`).allTextContents();
  wants(`each has its line: ${each}`, each.length === 3 && /^mujoco.*Passed\. Every step/.test(each[0]) &&
    /^rapier.*Failed \(energy, .*Every step is made by: rescaled/.test(each[1]) && /^<b>none<\/b>.*Cannot be judged: line /.test(each[2]));
  await told(verdict, "Passed: mujoco");
  await page.setInputFiles("#judge-file", [several[0], { name: "three.csv", mimeType: "text/csv", buffer: Buffer.from(three) }]);
  await told("#live-judge .live-said", "2 records: 1 passed, 1 too short to judge");
  wants("each has its line, the short one too", /Too short to judge\./.test(await page.locator(`${records} li`).last().textContent()));
  await page.setInputFiles("#judge-file", [...several, { name: "<b>none</b>.csv", mimeType: "text/csv", buffer: Buffer.from("t,wx\n0,1\n") }]);
  await told(records, "Cannot be judged");
  await told(verdict, "Passed: mujoco");
  await page.locator(`${records} button`).first().focus();
  await page.keyboard.press("Tab");
  await page.keyboard.press("Enter");
  await told(verdict, "Failed: rapier");
  wants("the keyboard stays with the list", await page.evaluate((s) => document.activeElement.closest(s) !== null, records));
  wants("one of them is shown as chosen", String(await page.locator(`${records} button`).evaluateAll((all) =>
    all.map((button) => button.getAttribute("aria-pressed")))) === "false,true,false");
  await page.click(`${records} li:last-child button`);
  await told(wrong, "<b>none</b>.csv: line ");
  await page.click(`${records} li:nth-child(2) button`);
  await set(page, "#judge-threshold", "0.5");
  await told(verdict, "Passed: rapier");
  await set(page, "#judge-threshold", "0.01");
  await told(verdict, "Failed: rapier");

  // Dropped before the widget has come into view.
  await page.reload();
  await page.evaluate(() => scrollTo(0, 0));
  await long("main h1");
  await told(verdict, "long.csv[^]*800000 rows");

  // The example is the record that the chapter reads.
  await page.locator("#judge-example").focus();
  await page.keyboard.press("Enter");
  await told(verdict, "the example");
  const example = (await page.textContent(verdict)).replace(/\s+/g, " ");
  const words = await page.textContent("main");
  const [, from, to] = example.match(/([\d.]+) to ([\d.]+)/) ?? [];
  const printed = `${Number(from).toFixed(2)} to ${Number(to).toFixed(2)}`;
  wants(`the example goes from ${printed}, as the chapter says`, words.includes(printed));

  // Its table fits, with and without the contents beside the text.
  for (const [width, contents] of [[320, false], [390, false], [700, false], [1000, true], [1400, true]]) {
    await page.setViewportSize({ width, height: 900 });
    await page.evaluate((open) => {
      const anchor = document.querySelector("#mdbook-sidebar-toggle-anchor");
      if (anchor.checked !== open) anchor.click();
    }, contents);
    // The contents glide in and out: what counts is where all comes to rest.
    await page.waitForFunction((selector) => {
      const place = document.querySelector(selector);
      const edge = place.getBoundingClientRect().right + 0.5;
      return document.getAnimations().length === 0 && [...place.querySelectorAll("table, th, td"), place].every((part) =>
        part.scrollWidth <= part.clientWidth && part.getBoundingClientRect().right <= edge);
    }, verdict, { timeout: 60000 }).catch(() => wants(`the table fits at ${width} px`, false));
  }
  await page.waitForFunction((s) => document.querySelectorAll(`${s} [data-shows]`).length > 3, picture, { timeout: 60000 })
    .catch(() => wants("the example is drawn", false));
  wants("the example has its lines in view", /qw/.test(await page.inputValue("#judge-text")));
}

/** Whether some part of a widget's drawings has no place, or a number that is none is shown. */
const broken = (page, widget) => page.locator(`#live-${widget}`).evaluate((box) =>
  [...box.querySelectorAll("svg")].some((svg) => /NaN|Infinity|undefined/.test(svg.outerHTML)) || /NaN|Infinity|undefined|null/.test(box.innerText));

async function pitfalls(page, wants) {
  const of = (which, what) => page.locator("#live-pitfalls .live-engine").nth(which).locator(`[data-of=${what}]`).textContent();
  const start = (which) => page.click(`#live-pitfalls [data-start="${which}"]`);
  const end = () => page.click("#pitfalls-end");
  const text = await page.textContent("main");

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
  wants("a screen reader is told of the step", /s$/.test(await page.getAttribute("#pitfalls-step", "aria-valuetext")));
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
async function pitfallsPlay(page, wants) {
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

async function steps(page, wants) {
  const step = "#steps-step";
  const methods = await page.locator("#steps-method option").allTextContents();
  wants(`all methods of the library are there: ${methods.length}`, methods.length === 26);
  const choose = (name) => set(page, "#steps-method", methods.indexOf(name));

  // What halving the step buys, as the chapter says.
  for (const [name, times] of [["explicit Euler", 2], ["three rotations", 4], ["Runge-Kutta 4", 16], ["Moser-Veselov 6", 64]]) {
    await choose(name);
    await set(page, step, 6);
    const better = await shown(page, "steps", "better");
    wants(`${name}: with half the step the error is ${better}, not ${times} times`, Math.abs(read(better) / times - 1) < 0.25 && better.endsWith(" better"));
  }

  await stepsDrawn(page, set, shown, wants, methods);

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
  wants("a step too long is refused", /^refused: .* was not found/.test(await page.textContent("#live-steps .live-wrong")));

  // By keyboard, with words.
  await set(page, "#steps-start", 0);
  await choose("Runge-Kutta 4");
  await set(page, step, 6);
  await page.locator(step).focus();
  await page.keyboard.press("ArrowRight");
  wants(`an arrow key lengthens the step: ${await shown(page, "steps", "step")}`, (await shown(page, "steps", "step")).endsWith("141 steps"));
  wants("a screen reader is told", /Attitude off by/.test(await page.getAttribute(step, "aria-valuetext")));
  await page.keyboard.press("ArrowLeft");
  wants(...await said(page, "steps", /Runge-Kutta 4, step 0.050 s/));
}

/** What a drawing shows, summed up: another picture has another sum. */
const tumblePicture = (page, what) => page.locator(`#live-tumble [data-draws=${what}]`).evaluate((canvas) => {
  let sum = 0;
  const over = canvas.nextElementSibling; // what moves over it
  for (const letter of canvas.toDataURL() + (over ? getComputedStyle(over).transform : "")) sum = (31 * sum + letter.charCodeAt(0)) % 1000000007;
  return sum;
});

const tumbleShows = (page) => Promise.all(["beat", "next", "time", "flips", "spin"].map((what) => shown(page, "tumble", what)));

/** It moves when it is played: of itself, or by steps where less motion is preferred. */
async function tumblePlay(page, wants) {
  const picture = (what) => tumblePicture(page, what);
  const all = () => tumbleShows(page);
  const reduced = await page.evaluate(() => matchMedia("(prefers-reduced-motion: reduce)").matches);
  for (const [control, value] of [["body", 0], ["spin-number", "10"], ["push-number", "0.01"]]) await set(page, `#tumble-${control}`, value);
  await page.click("#tumble-reset");
  const start = [await picture("body"), await picture("polhode"), await picture("strip")];
  await set(page, "#tumble-speed", 0);
  await page.click("#tumble-play");
  if (reduced) {
    wants("it goes by a step", (await page.textContent("#tumble-play")) === "Step" && (await shown(page, "tumble", "time")) === "0.10 s");
  } else {
    await page.waitForFunction(() => Number(document.querySelector("#live-tumble [data-shows=flips]").textContent) >= 1)
      .catch(() => wants("played, it flips", false));
    await page.click("#tumble-play");
  }
  const at = await all();
  const rest = [await picture("body"), await picture("polhode"), await picture("strip")];
  wants("all three drawings move", rest.every((sum, i) => sum !== start[i]));
  await frames(page, 12);
  wants("paused, it rests", String(await all()) === String(at) && (await picture("body")) === rest[0]);
  wants(...await said(page, "tumble", /has flipped/));
}

async function tumble(page, wants) {
  const all = () => tumbleShows(page);
  const beat = () => shown(page, "tumble", "beat");
  const number = (text) => parseFloat(text.replace("−", "-"));
  const along = async () => number(await shown(page, "tumble", "spin"));
  const wrong = "#live-tumble .live-wrong";
  const told = async () => ((await page.isVisible(wrong)) ? page.textContent(wrong) : "nothing");
  const picture = (what) => tumblePicture(page, what);
  /** How high above the middle the marked end stands: the mean height of the points in its colour. */
  const marked = () => page.locator("#live-tumble [data-draws=body]").evaluate((canvas) => {
    const probe = document.createElement("span");
    probe.style.color = "var(--fig-axis-mid)";
    document.body.append(probe);
    const [r, g, b] = getComputedStyle(probe).color.match(/[0-9.]+/g).map(Number);
    probe.remove();
    const copy = document.createElement("canvas");
    [copy.width, copy.height] = [canvas.width, canvas.height];
    const pen = copy.getContext("2d", { willReadFrequently: true });
    pen.drawImage(canvas, 0, 0);
    const { data } = pen.getImageData(0, 0, canvas.width, canvas.height);
    let [count, sum] = [0, 0];
    for (let i = 0; i < data.length; i += 4) {
      if (data[i + 3] > 200 && Math.abs(data[i] - r) + Math.abs(data[i + 1] - g) + Math.abs(data[i + 2] - b) < 12) {
        count += 1;
        sum += canvas.height / 2 - Math.floor(i / 4 / canvas.width);
      }
    }
    return count > 0 ? sum / count : NaN;
  });

  await page.locator("#live-tumble details > summary").click();
  // It opens on the chapter's wing nut. The chapter's own numbers are of the box.
  wants("it opens on the wing nut", (await page.inputValue("#tumble-body")) === "4");
  await set(page, "#tumble-body", 0);
  const text = (await page.textContent("main")).replace(/\s+/g, " ");
  const [, push, strong, weak, tiny] = text.match(/After a push of ([\d.]+), it flips every ([\d.]+ s); after a push of [^,]*, every ([\d.]+ s)\..*?flips the box every (\d+ s)/) ?? [];
  for (const [given, time] of [[push, strong], ["1e-9", weak], ["5e-324", tiny]]) {
    await set(page, "#tumble-push-number", given);
    wants(`a push of ${given}: it shows ${await beat()}, the chapter ${time}`, (await beat()) === time);
  }

  // It flips when the prediction says so, of every body: the spin changes its sign, and the marked end goes down.
  for (const body of [6, 5, 4, 3, 2, 1, 0]) {
    await set(page, "#tumble-body", body);
    for (const push of ["0.1", "0.001"]) {
      await set(page, "#tumble-push-number", push);
      const [first, second] = (await shown(page, "tumble", "next")).split(", ").map(parseFloat);
      wants(`body ${body}: the first flip is half a beat away, the next a beat later`,
        Math.abs(2 * first - number(await beat())) < 0.011 && Math.abs(second - first - number(await beat())) < 0.011);
      for (const [t, flips, sign] of [[first - 0.011, 0, 1], [first + 0.011, 1, -1], [second - 0.011, 1, -1], [second + 0.011, 2, 1]]) {
        await set(page, "#tumble-time", t);
        wants(`body ${body}, push ${push}, at ${t}: ${await all()}`,
          (await shown(page, "tumble", "flips")) === String(flips) && (await along()) * sign > 0);
      }
      // Half a beat from a flip the spin is along the middle axis again, turned over or back. (Of the racket, the hammer and the T-handle the middle is not the centre.)
      if (push === "0.1" || [3, 5, 6].includes(body)) continue;
      for (const [t, sign] of [[0, 1], [2 * first, -1], [first + second, 1]]) {
        await set(page, "#tumble-time", t);
        const high = await marked();
        wants(`body ${body}, push ${push}, at ${t} the marked end stands at ${high}`, high * sign > 0);
      }
    }
  }

  // Spun about another axis no body turns over, whatever the push.
  for (const [about, along] of [[1, 2], [2, 1]]) {
    await set(page, "#tumble-about", about);
    for (const body of [4, 1]) {
      await set(page, "#tumble-body", body);
      await set(page, "#tumble-push-number", "0.4");
      wants(`about axis ${along} body ${body} never flips: ${await all()}`, (await beat()) === "none: it never flips" && (await shown(page, "tumble", "next")) === "none: it never flips");
      for (const t of [0.7, 3.3, 1000.1]) {
        await set(page, "#tumble-time", t);
        const spins = (await shown(page, "tumble", "spin")).split(", ").map(number);
        wants(`about axis ${along} body ${body} spins on at ${t}: ${spins}`, spins[along] > 5 && (await shown(page, "tumble", "flips")) === "0");
      }
    }
  }
  await set(page, "#tumble-about", 0);

  // The solids drawn are those of the numbers: moments of what the faces enclose, by a sum over the faces alone.
  for (const body of [0, 1, 2, 3, 4, 5, 6, 7]) {
    const { ours, theirs, open } = await page.evaluate(async (body) => {
      const exact = await tumblingLive.module("tumble");
      const at = Array.from(exact.answer(7, body));
      const [moments, centre] = [at.slice(0, 3), at.slice(3)];
      const { parts, strings } = tumblingLive.solids(exact.answer(6, body), body, centre);
      const squares = [0, 0, 0]; // of the distances from the planes through the centre of mass, each by its mass
      let open = 0;
      for (const { corners, faces, mass } of parts) {
        const at = corners.map((p) => p.map((x, k) => x - centre[k]));
        const [about, area] = [[0, 0, 0], [0, 0, 0]];
        let volume = 0;
        // A cone from the centre of mass over each triangle of a face; a hole's count the other way.
        const fan = (list, sign) => {
          for (let i = 1; i + 1 < list.length; i += 1) {
            const [a, b, c] = [list[0], list[i], list[i + 1]].map((k) => at[k]);
            const normal = [0, 1, 2].map((k) => b[(k + 1) % 3] * c[(k + 2) % 3] - b[(k + 2) % 3] * c[(k + 1) % 3]);
            const six = sign * a.reduce((sum, x, k) => sum + x * normal[k], 0);
            volume += six / 6;
            for (let k = 0; k < 3; k += 1) {
              about[k] += six / 60 * (a[k] ** 2 + b[k] ** 2 + c[k] ** 2 + a[k] * b[k] + b[k] * c[k] + c[k] * a[k]);
              const [u, v] = [(k + 1) % 3, (k + 2) % 3];
              area[k] += sign * ((b[u] - a[u]) * (c[v] - a[v]) - (b[v] - a[v]) * (c[u] - a[u]));
            }
          }
        };
        for (const { at: list, hole } of faces) {
          fan(list, 1);
          if (hole) fan(hole, -1);
        }
        open = Math.max(open, Math.max(...area.map(Math.abs)) / Math.abs(volume) ** (2 / 3));
        for (let k = 0; k < 3; k += 1) squares[k] += (mass / volume) * about[k];
      }
      for (const { ends: [from, to], mass } of strings) {
        for (let k = 0; k < 3; k += 1) {
          const [a, b] = [from[k] - centre[k], to[k] - centre[k]];
          squares[k] += mass * (a * a + a * b + b * b) / 3;
        }
      }
      const [x, y, z] = squares;
      return { ours: [y + z, z + x, x + y], theirs: moments, open };
    }, body);
    wants(`body ${body}: its drawing is closed all around, but for ${open}`, open < 1e-9);
    wants(`body ${body}: what is drawn has the moments ${ours}, the motion ${theirs}`,
      ours.every((moment, k) => Math.abs(moment / theirs[k] - 1) < 0.01));
  }

  // What names the arrows is off the body, off each other and within the drawing, at any instant and in any width.
  const instants = () => page.locator("#live-tumble [data-draws=body]").evaluate((canvas) => {
    const scrub = document.querySelector("#tumble-scrub");
    const [from, to] = [Number(scrub.min), Number(scrub.max)];
    const { width, height } = canvas.getBoundingClientRect();
    const wrong = [];
    for (let i = 0; i <= 120; i += 1) {
      scrub.value = from + (to - from) * i / 120;
      scrub.dispatchEvent(new Event("input"));
      const { labels, body: { xs, ys, cx, cy } } = canvas.shows;
      const says = (what) => wrong.push(`${what} at ${scrub.value}`);
      if (labels.length !== 2) says(`${labels.length} labels`);
      for (const { name, left, right, top, bottom } of labels) {
        if (!(left >= 0 && right <= width && top >= 0 && bottom <= height)) says(`${name} leaves the drawing`);
        // Off the body: some line through the label's corners, or the body's, has all of the one on this side and all of the other on that.
        const corners = [[left, top], [left, bottom], [right, top], [right, bottom]];
        let apart = false;
        for (let turn = 0; turn < 360 && !apart; turn += 1) {
          const [x, y] = [Math.cos(turn * Math.PI / 180), Math.sin(turn * Math.PI / 180)];
          let far = -Infinity;
          for (let k = 0; k < xs.length; k += 1) far = Math.max(far, (cx + xs[k]) * x + (cy + ys[k]) * y);
          apart = Math.min(...corners.map(([u, v]) => u * x + v * y)) > far;
        }
        if (!apart) says(`${name} lies on the body`);
      }
      const [a, b] = labels;
      if (a && b && a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom) says("one label on the other");
    }
    return wrong;
  });
  const contents = () => page.evaluate(() => document.querySelector("#mdbook-sidebar-toggle-anchor").click());
  await contents(); // away: in a narrow window they take the room of the text
  for (const width of [390, 1400]) {
    await page.setViewportSize({ width, height: 900 });
    await page.waitForFunction(() => document.getAnimations().length === 0 && [...document.querySelectorAll("#live-tumble canvas")].every((canvas) =>
      canvas.width === Math.round(canvas.clientWidth * Math.min(devicePixelRatio, 2))));
    for (const body of [6, 5, 4, 3, 2, 1, 0]) {
      await set(page, "#tumble-body", body);
      for (const [spin, push] of [["10", "0.01"], ["-10", "0.4"], ["3", "-3"]]) {
        await set(page, "#tumble-spin-number", spin);
        await set(page, "#tumble-push-number", push);
        const wrong = await instants();
        wants(`${width} px, body ${body}, spin ${spin}, push ${push}: ${wrong.length} labels badly placed: ${wrong.slice(0, 3)}`, wrong.length === 0);
      }
    }
  }
  await contents();
  await set(page, "#tumble-spin-number", "10");

  // Any instant, by the slider too.
  await set(page, "#tumble-push-number", "0.01");
  await set(page, "#tumble-time", "1e6");
  const far = await all();
  wants(`after a million seconds: ${far}`, far[2] === "1000000.00 s" && Number(far[3]) > 400000 && !/NaN|undefined/.test(far.join()));
  await set(page, "#tumble-scrub", Number(await page.locator("#tumble-scrub").getAttribute("min")));
  await set(page, "#tumble-time", "1e6");
  wants("and there again, the same", String(await all()) === String(far));
  const before = await picture("body");
  await page.locator("#tumble-scrub").focus();
  for (let i = 0; i < 3; i += 1) await page.keyboard.press("ArrowRight");
  wants("arrow keys move time", (await shown(page, "tumble", "time")) !== far[2] && (await picture("body")) !== before);
  wants("a screen reader is told", /s, \d+ flips so far/.test(await page.getAttribute("#tumble-scrub", "aria-valuetext")));
  await page.click("#tumble-reset");
  wants("back to the start", (await shown(page, "tumble", "time")) === "0.00 s");

  await tumblePlay(page, wants);

  await tumbleDrawn(page, wants);
  await tumbleRolls(page, wants, set);
  await tumblePlayed(page, wants, set);
  await set(page, "#tumble-body", 0);
  await set(page, "#tumble-spin-number", "10");
  await set(page, "#tumble-push-number", "0.01");

  // Turned by hand and by keys: the body looks otherwise, and its labels keep off it.
  const looks = [await picture("body")];
  await page.locator("#live-tumble [data-draws=body]").scrollIntoViewIfNeeded();
  const paper = await page.locator("#live-tumble [data-draws=body]").boundingBox();
  await page.mouse.move(paper.x + 0.5 * paper.width, paper.y + 0.5 * paper.height);
  await page.mouse.down();
  await page.mouse.move(paper.x + 0.5 * paper.width + 40, paper.y + 0.5 * paper.height - 20, { steps: 5 });
  // Let go at rest: in full motion it would be a flick.
  await frames(page, 12);
  await page.mouse.up();
  const dragged = await Promise.all(["turn", "tilt"].map((id) => page.inputValue(`#tumble-${id}`)));
  wants(`dragged, it is seen from ${dragged}`, String(dragged) === "48,12");
  looks.push(await picture("body"));
  await page.mouse.move(paper.x + 5, paper.y + 5);
  wants("let go, it stays", (await picture("body")) === looks[1]);
  await page.locator("#tumble-turn").focus();
  await page.keyboard.press("ArrowRight");
  looks.push(await picture("body"));
  wants("each way of turning it shows", new Set(looks).size === 3);
  for (const [turn, tilt] of [[-120, 60], [170, -70]]) {
    await set(page, "#tumble-turn", turn);
    await set(page, "#tumble-tilt", tilt);
    const wrong = await instants();
    wants(`seen from ${turn}, ${tilt}: ${wrong.length} labels badly placed: ${wrong.slice(0, 3)}`, wrong.length === 0);
  }
  await set(page, "#tumble-turn", 28);
  await set(page, "#tumble-tilt", 22);

  // Before the start, and a spin of hardly anything.
  await set(page, "#tumble-time", "-5");
  wants(`before the start no flip has been yet: ${await all()}`, (await shown(page, "tumble", "flips")) === "none: 2 from here to the start");
  await set(page, "#tumble-spin-number", "1e-150");
  wants(`a spin of 1e-150 is told: ${await all()}`, (await shown(page, "tumble", "spin")).startsWith("1.00 · 10⁻¹⁵⁰, 1.00 · 10⁻¹⁵², 0"));
  await set(page, "#tumble-spin-number", "10");

  // No push at all, no spin at all, and what is no number.
  await set(page, "#tumble-push", -1e9);
  wants(`without a push it never flips: ${await all()}`, /never/.test(await beat()) && (await page.inputValue("#tumble-push-number")) === "0");
  await set(page, "#tumble-time", "1e6");
  wants(`nor in a million seconds: ${await all()}`, (await along()) === 10 && (await shown(page, "tumble", "flips")) === "0");
  for (const [field, value, says] of [["spin", "", "The field for the spin has no number"], ["push", "", "The field for the push has no number"], ["time", "", "The field for the time has no number"], ["time", "1e300", "f64"], ["spin", "1e-320", "floating-point"], ["push", "1e308", "finite"]]) {
    const selector = field === "time" ? "#tumble-time" : `#tumble-${field}-number`;
    await set(page, "#tumble-push-number", "0.01");
    await set(page, selector, value);
    wants(`${field} = "${value}" is told wrong, by "${says}", not by "${await told()}"`, (await told()).includes(says) && !(await told()).includes("#"));
    await set(page, selector, field === "spin" ? 10 : field === "push" ? 0.01 : 0);
    wants(`${field} put right is right again: ${await told()}`, (await told()) === "nothing");
  }
  for (const [spin, push] of [["-1e9", "1e9"], ["1e9", "1e9"], ["1e9", "-1e9"], ["-1e9", "-1e9"]]) {
    for (const body of [0, 3]) {
      await set(page, "#tumble-body", body);
      await set(page, "#tumble-spin", spin);
      await set(page, "#tumble-push", push);
      const text = await page.locator("#live-tumble .live-stage").innerText();
      wants(`body ${body}, spin ${spin}, push ${push}: ${await all()}, ${await told()}`, !/NaN|Infinity|undefined/.test(text) && (await told()) === "nothing");
    }
  }
  await set(page, "#tumble-spin-number", "1e300");
  wants(`a spin of 1e300: ${await all()}`, !/NaN|Infinity|undefined/.test(await page.locator("#live-tumble .live-stage").innerText()));
  await set(page, "#tumble-spin", 10);
  await set(page, "#tumble-push", -2);
  await set(page, "#tumble-body", 0);
  await set(page, "#tumble-time", "1.3");
}

/** A picture that turns by mouse and finger, without the page; and a widget that plays, by steps where less motion is preferred. */
async function turnsAndPlays(page, wants, widget, time) {
  const canvas = page.locator(`#live-${widget} canvas`).first();
  const looks = () => canvas.evaluate((canvas) => Array.from(canvas.shows.body.xs).join());
  await canvas.scrollIntoViewIfNeeded();
  const box = await canvas.boundingBox();
  const at = (part, low = 0.5) => [box.x + part * box.width, box.y + low * box.height];
  const seen = [await looks()];
  // Half a degree for each pixel to the last of many small moves, downward too: a drag that died would fall short.
  const from = () => canvas.evaluate(({ shows: { turn, tilt } }) => [turn, tilt]);
  const stood = await from();
  const scrolled = await finger(page, at(0.3), Array.from({ length: 20 }, (_, i) => at(0.3 + 0.02 * (i + 1), 0.5 + 0.01 * (i + 1))));
  wants(`under a finger the page does not scroll: ${scrolled} px`, scrolled === 0);
  const went = (await from()).map((degrees, i) => degrees - stood[i]);
  const should = [0.2 * box.width, 0.1 * box.height];
  wants(`the picture follows the finger to its end: by ${went}, not ${should}`, went.every((degrees, i) => Math.abs(degrees - should[i]) < 1));
  seen.push(await looks());
  await page.mouse.move(...at(0.3));
  await page.mouse.down();
  for (let i = 1; i <= 10; i += 1) await page.mouse.move(...at(0.3 + 0.03 * i));
  await page.mouse.up();
  seen.push(await looks());
  wants("dragged by finger and by mouse it is seen from elsewhere", new Set(seen).size === 3);
  const address = page.url();
  await page.locator(`#${widget}-scrub`).focus();
  const before = await time();
  await page.keyboard.press("ArrowRight");
  wants("an arrow key moves time and turns no page", (await time()) !== before && page.url() === address);
  const then = await time();
  const reduced = await page.evaluate(() => matchMedia("(prefers-reduced-motion: reduce)").matches);
  await page.click(`#${widget}-play`);
  if (reduced) return wants("it goes by a step", (await time()) !== then && (await page.textContent(`#${widget}-play`)) === "Step");
  await page.waitForFunction(([w, then]) => document.querySelector(`#${w}-scrub`).getAttribute("aria-valuetext") !== then, [widget, then])
    .catch(() => wants("played, it goes on", false));
  await page.click(`#${widget}-play`);
  wants("and it can be paused", (await page.textContent(`#${widget}-play`)) === "Play");
}
const atTime = (page, widget) => () => page.getAttribute(`#${widget}-scrub`, "aria-valuetext");

async function turning(page, wants) {
  const entries = () => page.locator("#live-turning [data-at]").allTextContents();
  const text = await page.textContent("main");
  const [, large, small] = text.match(/change places: ([\d.]+) and ([\d.]+) kg/);
  const [, equal, product] = text.match(/both are\s+([\d.]+) kg m², and a product of (−[\d.]+)/);
  await set(page, "#turning-scrub", 90);
  wants(`a quarter turn swaps the moments: ${await entries()}`, (await entries()).slice(0, 5).filter((_, i) => i !== 2).join() === `${large},0.000,0.000,${small}`);
  await set(page, "#turning-scrub", 45);
  const half = await entries();
  wants(`half of that makes them equal: ${half}`, half[0] === equal && half[4] === equal && half[1] === product && half[3] === product);
  wants(...await said(page, "turning", /At 45° the moments in the world/));
  await set(page, "#turning-motion", "free");
  await set(page, "#turning-scrub", 700);
  const free = (await entries()).map(read);
  wants(`tumbling, the sum of the moments stays: ${free}`, Math.abs(free[0] + free[4] + free[8] - 28 / 12) < 0.002);
  wants("and it is symmetric, with all products", free[1] === free[3] && free[2] === free[6] && free[5] === free[7] && [1, 2, 5].every((k) => free[k] !== 0));
  await turnsAndPlays(page, wants, "turning", atTime(page, "turning"));
}

async function trading(page, wants) {
  const text = (await page.textContent("main")).replace(/\s+/g, " ");
  const [, after] = text.match(/look again after ([\d.]+) s/);
  await set(page, "#trading-scrub", after);
  const spin = () => shown(page, "trading", "spin");
  wants(`after ${after} s the spin is the chapter's: ${await spin()}`, (await spin()) === "0.00, 1.22, −0.87");
  wants(...await said(page, "trading", /the energy is by 0 % along x/));
  const rates = (await shown(page, "trading", "rate")).split(", ").map(read);
  const [wx, wy, wz] = (await spin()).split(", ").map(read);
  wants(`its rate follows Euler's equations: ${rates}`, Math.abs(rates[0] - (13 - 5) / 10 * wy * wz) < 0.02 && rates[1] === 0 && rates[2] === 0 && wx === 0);
  await set(page, "#trading-start", 1);
  await set(page, "#trading-scrub", 9.3);
  wants(`about one axis alone nothing changes: ${await spin()}`, (await spin()) === "0.00, 0.00, 1.00");
  for (const [start, flips] of [[2, false], [3, true], [4, false]]) {
    await set(page, "#trading-start", start);
    const axis = [2, 0, 1][start - 2];
    let least = Infinity;
    for (let t = 0; t < 8; t += 0.1) {
      await set(page, "#trading-scrub", t);
      least = Math.min(least, read((await spin()).split(", ")[axis]));
    }
    wants(`start ${start}: the spin about its axis falls to ${least}`, flips ? least < -9 : least > 9);
  }
  await set(page, "#trading-start", 0);
  await turnsAndPlays(page, wants, "trading", atTime(page, "trading"));
}

/** A phone, a satellite and a robot's link: their numbers, their drawings, and the address that keeps them. */
async function yourBody(page, wants) {
  const tell = (what) => shown(page, "your-body", what);
  const wrong = "#live-your-body .live-wrong";
  const fill = async (values) => { for (const [field, value] of Object.entries(values)) await set(page, `#your-body-${field}`, value); };
  const choose = (kind) => page.selectOption("#your-body-kind", kind);
  await fill({ a: 2, b: 1, c: 3, m: 1 });
  for (const [k, moment, along] of [[1, 5 / 12, "0.000, 0.000, 1.000"], [2, 10 / 12, "1.000, 0.000, 0.000"], [3, 13 / 12, "0.000, 1.000, 0.000"]]) {
    const text = await tell(`axis-${k}`);
    wants(`the box's moment ${k} and its axis: ${text}`, Math.abs(parseFloat(text) - moment) < 1e-3 && text.includes(along));
  }
  const rate = Math.sqrt((3 * 5) / (13 * 5));
  const growth = await tell("growth");
  wants(`a push on the box grows e-fold in 1/(2π ${rate}) turns: ${growth}`, growth.includes(`e-fold in ${Number((1 / (2 * Math.PI * rate)).toPrecision(3))} turns`));
  const flips = await page.locator(".your-body-flips td").allTextContents();
  const steps = flips.slice(1).map((text, k) => Number(text) - Number(flips[k]));
  const step = Math.log(100) / rate / 2 / Math.PI;
  wants(`each push ten times smaller waits ${step} turns longer: ${flips}`, flips.length === 9 && steps.slice(2).every((x) => Math.abs(x - step) < 0.08));
  const ratio = 13 / 5;
  const gap = (Math.atan((ratio - 1) / 2 / Math.sqrt(ratio)) * 180) / Math.PI;
  wants(`the widest gap is ${gap}: ${await tell("gap")}`, Math.abs(parseFloat(await tell("gap")) - gap) < 0.06);
  await page.waitForFunction(() => location.hash.startsWith("#your-body?kind=box&m=1&a=2&b=1&c=3"), null, { timeout: 60000 }).catch(() => {});
  wants(`the address keeps the box: ${page.url()}`, page.url().endsWith("#your-body?kind=box&m=1&a=2&b=1&c=3"));

  // All paths lie inside the outline of their ellipsoid.
  const inside = await page.locator("#live-your-body [data-drawing=polhodes]").evaluate((svg) => {
    const box = (path) => path.getBBox();
    const whole = box(svg.querySelector(".live-body"));
    const paths = [...svg.querySelectorAll(".your-body-path")].map(box);
    return [paths.length, paths.every((b) => b.x >= whole.x - 1 && b.y >= whole.y - 1 && b.x + b.width <= whole.x + whole.width + 1 && b.y + b.height <= whole.y + whole.height + 1)];
  });
  wants(`${inside[0]} paths lie on the ellipsoid`, inside[0] >= 18 && inside[1]);

  for (const [kind, never] of [["ball", "any spin stays"], ["cylinder", "equal"], ["disk", "equal"]]) {
    await choose(kind);
    await fill({ a: 0.1, b: 0.02 });
    wants(`a ${kind}: ${await tell("growth")}`, (await tell("growth")).includes(never) && !(await page.isVisible(".your-body-flips")));
  }
  await choose("moments");
  for (const [values, says] of [[{ xx: 1, yy: 2, zz: 4 }, "no body"], [{ zz: "" }, "Type a number for zz"], [{ xx: 1, yy: 2, zz: 2.5 }, null]]) {
    await fill(values);
    const text = (await page.isVisible(wrong)) ? await page.textContent(wrong) : null;
    wants(`moments ${Object.values(values)}: ${text}`, says === null ? text === null : text?.includes(says));
  }
  await page.locator("#live-your-body summary").click();
  const link = '<link name="arm"><inertial><origin xyz="0 0 1" rpy="0 0 1.5707963267948966"/><mass value="2"/><inertia ixx="1" iyy="2" izz="2.5" ixy="0.1" ixz="0" iyz="0"/></inertial></link>';
  await page.fill("#your-body-urdf", link);
  const taken = await Promise.all(["xx", "yy", "zz", "xy", "m"].map(async (field) => Number(await page.inputValue(`#your-body-${field}`))));
  wants(`a link is turned into its own axes: ${taken}`, [2, 1, 2.5, -0.1, 2].every((x, k) => Math.abs(taken[k] - x) < 1e-9));
  await page.fill("#your-body-urdf", "<link><inertial><mass value='2'/></inertial></link>");
  wants(`half a link is refused: ${await tell("urdf")}`, (await tell("urdf")).includes("missing"));
  await page.locator("#live-your-body summary").click();

  // Another's link is taken over, and by finger and keyboard the view goes round.
  await page.evaluate(() => { location.hash = "#your-body?kind=ellipsoid&m=1e12&a=620&b=500&c=384"; });
  await page.waitForFunction(() => document.querySelector("#your-body-kind").value === "ellipsoid", null, { timeout: 60000 }).catch(() => {});
  wants(`a link in the address is taken over: ${await tell("axis-1")}`, (await tell("axis-1")).includes("10¹⁶"));
  const svg = page.locator("#live-your-body [data-drawing=body]");
  await svg.scrollIntoViewIfNeeded();
  const before = await svg.innerHTML();
  const box = await svg.boundingBox();
  const centre = [box.x + box.width / 2, box.y + box.height / 2];
  const scrolled = await finger(page, centre, [[centre[0] + 40, centre[1] + 15]]);
  wants(`under a finger the body turns and the page does not scroll: ${scrolled} px`, scrolled === 0 && (await svg.innerHTML()) !== before);
  const turned = await svg.innerHTML();
  await page.locator("#your-body-turn").focus();
  await page.keyboard.press("ArrowRight");
  wants("by keyboard too", (await svg.innerHTML()) !== turned);
  wants("every part of the drawings has a place", !/NaN|Infinity|undefined/.test(await page.locator("#live-your-body .live-stage").innerHTML()));
}

/** The greatest lean of the chapter's top after it was let go, degrees: where its height u solves 400 (1 - u²) = (spin/4)² (u0 - u). */
function lowest(spin, lean) {
  const [pull, square, high] = [400, (spin / 4) ** 2, Math.cos((lean * Math.PI) / 180)];
  const u = (square - Math.sqrt(square * square - 4 * pull * (square * high - pull))) / (2 * pull);
  return (Math.acos(u) * 180) / Math.PI;
}

async function top(page, wants) {
  const tell = (what) => shown(page, "top", what);
  const shows = () => page.locator("#live-top [data-draws=body]").evaluate((canvas) => canvas.shows);
  const start = (which) => page.click(`#live-top [data-start=${which}]`);
  const lean = ([x, y, z]) => (Math.atan2(Math.hypot(x, y), z) * 180) / Math.PI;
  const wrong = "#live-top .live-wrong";
  wants(`it begins as the text does: ${await tell("kind")}`, (await tell("kind")).includes("cusps"));

  // The chapter's numbers, and those of an equation of our own.
  const text = (await page.locator("main > p").allTextContents()).join(" ").replace(/\s+/g, " ");
  const sinks = [...text.matchAll(/at (\d+) radians a second it sinks to a lean of ([\d.]+°)/gi)];
  const [, period, rate] = text.match(/is back after ([\d.]+ s), and goes round at ([\d.]+) radians/) ?? [];
  wants(`the text has two spins: ${sinks.length}`, sinks.length === 2);
  for (const [, spin, angle] of sinks) {
    await set(page, "#top-spin", spin);
    const right = `${lowest(Number(spin), 30).toFixed(1)}°`;
    wants(`at ${spin} it leans by ${await tell("leans")}, the text ${angle}, it should be ${right}`, (await tell("leans")) === `30.0° to ${angle}` && angle === right);
    const { exact } = await shows();
    const leans = exact.map(lean);
    wants(`at ${spin} what is drawn leans from ${Math.min(...leans)} to ${Math.max(...leans)}`,
      Math.abs(Math.min(...leans) - 30) < 0.1 && Math.abs(Math.max(...leans) - parseFloat(angle)) < 0.1);
  }
  await start("let-go");
  wants(`it nods every ${await tell("nods")}, goes round at ${await tell("round")}`, (await tell("nods")) === period && (await tell("round")) === `${rate} rad/s`);
  for (const [which, kind, range] of [["steady", "steadily", (a) => a[1] - a[0] < 1e-3], ["on", "waves", (a) => a[0] > 29.9 && a[1] < lowest(200, 30)],
    ["back", "loops", (a) => a[1] > lowest(200, 30)], ["let-go", "cusps", (a) => a[1] > 35]]) {
    await start(which);
    const { exact, trail } = await shows();
    const leans = exact.map(lean);
    const angles = exact.map(([x, y]) => Math.atan2(y, x));
    const turns = angles.slice(1).map((angle, i) => Math.sin(angle - angles[i]));
    const back = turns.filter((turn) => turn < -1e-9).length;
    wants(`${which}: its axis ${await tell("kind")}`, (await tell("kind")).includes(kind));
    wants(`${which}: drawn from ${Math.min(...leans)} to ${Math.max(...leans)}`, range([Math.min(...leans), Math.max(...leans)]));
    wants(`${which}: ${back} parts of its path lead backward`, which === "back" ? back > 20 && back < turns.length / 2 : back === 0);
    const off = Math.max(...trail.map((p, i) => Math.hypot(...p.map((x, k) => x - exact[i][k]))));
    wants(`${which}: the steps keep to the closed form: ${off}`, trail.length === exact.length && off < 1e-2);
    wants(`${which} is marked`, String(await page.locator("#live-top [aria-pressed=true]").evaluateAll((all) => all.map((it) => it.dataset.start))) === which);
  }

  // Steps as long as a game's lose it, and finer ones do not.
  const key = () => page.locator("#live-top .live-key [data-shows=stepped]").evaluate((it) => [it.textContent, it.className].join());
  await set(page, "#top-step", 16);
  wants(`in long steps it says: ${await key()}`, (await key()) === "stepped, astray,live-key-wrong");
  await set(page, "#top-step", 0.5);
  wants(`in short ones: ${await key()}, ${await tell("now")}`, (await key()) === "stepped,live-key-stepped" && (await tell("now")).includes("less than 0.01°"));
  await set(page, "#top-step", 1);

  // Too slow for a steady rate; the critical spin is the chapter's.
  await start("steady");
  await set(page, "#top-spin", 100);
  wants("too slow, it says so", (await page.isVisible(wrong)) && (await page.textContent(wrong)).includes("too slowly"));
  await set(page, "#top-spin", 200);
  wants("fast enough, it is right again", !(await page.isVisible(wrong)) && (await tell("push")) === "4.32 rad/s, the steady rate");
  const [, critical] = text.match(/For our top that is (\d+) radians/) ?? [];
  wants(`the critical spin is ${await tell("critical")}`, (await tell("critical")) === `${critical} rad/s`);
  await set(page, "#top-push", 0);
  await set(page, "#top-lean", 0);
  for (const [spin, kind] of [[115, "asleep"], [110, "would grow"]]) {
    await set(page, "#top-spin", spin);
    wants(`upright at ${spin} its axis ${await tell("kind")}`, (await tell("kind")).includes(kind));
  }
  for (const [spin, angle] of [...text.matchAll(/at (\d+) radians a second (?:it leans )?by ([\d.]+°)/g)].map(([, ...both]) => both)) {
    await set(page, "#top-lean", 1);
    await set(page, "#top-spin", spin);
    wants(`tilted, at ${spin} it leans by ${await tell("leans")}, the text ${angle}`, (await tell("leans")) === `1.0° to ${angle}`);
    wants(`and its axis ${await tell("kind")}`, (await tell("kind")).startsWith("is asleep") === Number(spin) > Number(critical));
  }

  // Asleep, it wakes when the drag has taken enough of the spin.
  await start("asleep");
  const wakes = 8 * Math.log(140 / Number(critical));
  for (const [t, most] of [[wakes - 0.3, 5], [16, 180]]) {
    await set(page, "#top-scrub", t);
    const [, leans, spins] = (await tell("now")).match(/leans by ([\d.]+)°, spins at (\d+)/) ?? [];
    wants(`after ${t} s it ${await tell("now")}`, Math.abs(Number(spins) - 140 * Math.exp(-t / 8)) < 1.5 && Number(leans) < most && (t < 3 || Number(leans) > 60));
  }
  wants(`there is no closed form: ${await key()}`, (await key()).includes("no closed form") && !(await page.isVisible("#live-top [data-shows=closed]")));
  wants(...await said(page, "top", /Its axis stands asleep, until/));
  await page.waitForFunction(() => location.hash === "#top?spin=140&lean=1&push=0&drag=1&step=1", null, { timeout: 60000 }).catch(() => {});
  wants(`the address keeps it: ${page.url()}`, page.url().endsWith("#top?spin=140&lean=1&push=0&drag=1&step=1"));
  await page.evaluate(() => { location.hash = "#top?spin=200&lean=30&push=steady&drag=0&step=2"; });
  await page.waitForFunction(() => document.querySelector("#top-step").value === "2", null, { timeout: 60000 }).catch(() => {});
  wants(`another's is taken over: ${await tell("kind")}`, (await tell("kind")).includes("steadily") && (await page.inputValue("#top-step")) === "2");

  // All ends of all controls.
  for (const slowed of [true, false]) {
    await page.locator("#top-drag").setChecked(slowed);
    for (const [spin, lean, push, step] of [[0, 0, 0, 16], [400, 150, 15, 16], [0, 150, -15, 0.5], [400, 0, 15, 8], [0, 90, 0, 4], [400, 90, -15, 2]]) {
      for (const [id, value] of Object.entries({ spin, lean, push, step })) await set(page, `#top-${id}`, value);
      wants(`spin ${spin}, lean ${lean}, push ${push}, step ${step}: everything has a number and a place`, !(await broken(page, "top")) && !(await page.isVisible(wrong)));
    }
  }
  await start("let-go");
  await page.locator("#top-spin").focus();
  const address = page.url().replace(/#.*/, "");
  await page.keyboard.press("ArrowRight");
  wants(`an arrow key spins it faster: ${await tell("spin")}`, (await tell("spin")) === "205 rad/s" && page.url().startsWith(address));
  wants("a screen reader is told", (await page.getAttribute("#top-spin", "aria-valuetext")) === "205 rad/s");
  await topPlay(page, wants);
}

/** From the middle of its time on, so that there is some to go. */
async function topPlay(page, wants) {
  await set(page, "#top-scrub", 0.5);
  await turnsAndPlays(page, wants, "top", atTime(page, "top"));
}

const TESTS = { toss, "two-arrows": twoArrows, "your-body": yourBody, "your-box": yourBox, top, tumble, judge, pitfalls, steps, trading, turning };
const PLAYS = {
  toss: tossPlay, top: topPlay, tumble: tumblePlay, pitfalls: pitfallsPlay,
  ...Object.fromEntries(["trading", "turning"].map((widget) => [widget, (page, wants) => turnsAndPlays(page, wants, widget, atTime(page, widget))])),
};

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

/** A module that came damaged: the page says so, and neither asks for scripts, which run, nor lets anything be tried. */
async function damaged(page, address, widget, wants) {
  await page.route("**/*.wasm.js", (route) => {
    const module = path.basename(route.request().url(), ".wasm.js");
    return route.fulfill({ contentType: "text/javascript", body: `tumblingLive.carry("${module}", "${btoa("\0asm\x01\0\0\0damaged")}");` });
  });
  await page.goto(address);
  const box = page.locator(`#live-${widget}`);
  await box.scrollIntoViewIfNeeded();
  await page.waitForFunction((w) => document.querySelector(`#live-${w}`).dataset.state, widget, { timeout: 60000 }).catch(() => {});
  const state = await box.getAttribute("data-state");
  wants(`damaged, it does not come to life: ${state}`, /^failed/.test(state));
  const says = await box.innerText();
  wants(`damaged, it says so: ${says.slice(0, 200)}`, says.includes("could not be loaded") && !says.includes("With JavaScript"));
  wants("damaged, it offers nothing to try", !(await box.locator(".live-stage").isVisible()));
  await page.context().close();
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
    const still = await page.locator(`#live-${widget} .live-still`).isVisible();
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
  wants("it waits until it comes into view", !far || !modules.some((module) => asked.includes(`${module}.wasm.js`)));
  await box.scrollIntoViewIfNeeded();
  try {
    await page.waitForFunction((w) => document.querySelector(`#live-${w}`).dataset.state === "live", widget, { timeout: 60000 });
  } catch {
    wants(`it comes to life, not: ${await box.getAttribute("data-state")}`, false);
    return null;
  }
  const others = asked.filter((file) => file.endsWith(".wasm.js") && ![...widgets, ...modules].some((w) => file === `${w}.wasm.js`));
  wants(`it loads no other module than the page's: ${others}`, others.length === 0);
  const before = await box.innerHTML();
  await frames(page, 12);
  wants("nothing moves until asked", before === (await box.innerHTML()));
  return page;
}

/** A widget in five themes and three widths, once it has been tried. */
async function looks({ axe, fault, shots }, page, widget, where) {
  const box = page.locator(`#live-${widget}`);
  await page.evaluate(() => {
    const contents = document.querySelector("#mdbook-sidebar-toggle-anchor");
    if (contents.checked) contents.click(); // they take the room of the text in a narrow window
  });
  for (const width of [320, 800, 1400]) {
    await page.setViewportSize({ width, height: 900 });
    await frames(page);
    for (const what of await page.evaluate(cutOff, widget)) fault(`${where}, ${width} px`, what);
    for (const theme of width === 800 ? THEMES : shots ? ["light", "navy"] : []) {
      await page.evaluate(([themes, theme]) => {
        document.documentElement.classList.remove(...themes);
        document.documentElement.classList.add(theme);
      }, [THEMES, theme]);
      // Colours glide from theme to theme: to their end at once, however slow the machine.
      await page.evaluate(() => document.getAnimations().forEach((glide) => glide.finish()));
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
          await page.context().close();
          await damaged(await open(bases.http), bases.http + name, widget, wants("http"));
        },
      });
    }
  }
  return jobs;
}
