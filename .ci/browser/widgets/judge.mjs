// The judge of records.
import { readFile } from "node:fs/promises";
import { fileURLToPath } from "node:url";
import { set } from "./controls.mjs";
import { frames } from "./hands.mjs";

export async function judge(page, wants) {
  const [verdict, wrong] = ["#live-judge .live-verdict", "#live-judge .live-wrong"];
  /** Waits for either; returns its text. */
  async function waitForText(selector, pattern) {
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
  await waitForText(wrong, "the file is empty");
  await set(page, "#judge-text", "t,wx,wy,wz\n0,1,2,3\n1,1,2\n");
  await page.click("#judge-go");
  await waitForText(wrong, "line 3");
  await set(page, "#judge-text", "t,wx,wy,wz\n0,1,2,3\n1,1,2,3\n2,1,2,3\n");
  await page.click("#judge-go");
  await waitForText(wrong, "moments are not known");
  await set(page, "#judge-moments", "1, 2");
  await waitForText(wrong, "three numbers");
  await set(page, "#judge-moments", "1 2 3");
  await waitForText(verdict, "no gyroscopic term");
  await set(page, "#judge-threshold", "-1");
  await waitForText(wrong, "above zero");
  await set(page, "#judge-threshold", "0.01");
  await set(page, "#judge-moments", "");

  // The rows that README.md begins with say too little.
  const readme = await readFile(new URL("../../../README.md", import.meta.url), "utf8");
  const [, three] = readme.match(/```text\n(# inertia[^]*?)```/);
  await set(page, "#judge-text", three);
  await page.click("#judge-go");
  await waitForText(verdict, "^Too short to judge: the lines above[^]*8 rows or more[^]*Record [0-9.]+ s or more");
  const ink = () => page.locator(`${verdict} .live-outcome`).evaluate((line) => [getComputedStyle(line).color, getComputedStyle(line.parentElement).color]);
  const plain = await ink();
  wants(`what did not fail has the colour of the text: ${plain}`, plain[0] === plain[1]);

  // A file of many pieces, and words that would be markup.
  let rows = "# engine: <img src=x onerror=alert(1)>\n# inertia: 1 2 3\nt,wx,wy,wz\n";
  for (let i = 0; i < 60000; i += 1) rows += `${0.01 * i},0.1,2,0.1\n`;
  await page.setInputFiles("#judge-file", { name: "large.csv", mimeType: "text/csv", buffer: Buffer.from(rows) });
  await waitForText(verdict, "large.csv[^]*60000 rows");
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
  await waitForText(verdict, "Nothing to judge: dropped.csv");

  // The picture. Every part has a place, and every curve its name.
  const picture = `${verdict} svg.live-picture`;
  async function drawn(name, lines, pattern, { curves, says, words }) {
    await page.setInputFiles("#judge-file", { name, mimeType: "text/csv", buffer: Buffer.from(lines) });
    await waitForText(verdict, pattern);
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
    for (const text of words) wants(`${name} is shown as "${text}", not "${seen.words}"`, seen.words.includes(text));
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
  wants(`blown.csv: growth is said plainly, not as ${rates.slice(0, 2)}`,
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

  // Options: limits by law.
  const good = new URL("../../../crates/engines/data/mujoco-4.0.0-rk4--middle.csv", import.meta.url);
  await page.setInputFiles("#judge-file", fileURLToPath(good));
  await waitForText(verdict, "Passed: mujoco");
  await set(page, "#judge-threshold", "0.5, momentum=1e-6");
  await waitForText(verdict, "Failed: mujoco");
  await page.waitForFunction((s) => [...document.querySelectorAll(`${s} text`)].filter((t) => / may$/.test(t.textContent)).length === 2, picture)
    .catch(() => wants("limits of their own are drawn by name", false));
  for (const [limits, says] of [["energy=0", "above zero"], ["mass=1", "there is no law `mass`"], ["energy=", "above zero"]]) {
    await set(page, "#judge-threshold", limits);
    await waitForText(wrong, says);
  }
  for (const law of ["energy", "momentum", "direction", "unit", "separatrix", "phase", "consistency"]) {
    await set(page, "#judge-threshold", `${law}=0.125`);
    await waitForText(verdict, `${{ momentum: "\\|L\\|", unit: "length", separatrix: "2 E I₂", consistency: "turn against spin" }[law] ?? law}[^,;]* within 0.125`);
  }
  await set(page, "#judge-threshold", "0.01");
  await waitForText(verdict, "Passed: mujoco");

  // A long record: how far it is read is shown, and said no more than by quarters; another file ends it, and so does a button.
  const several = await Promise.all(["mujoco-4.0.0-rk4--middle", "rapier3d-f64-0.36.1--major"].map(async (name) =>
    ({ name: `${name}.csv`, mimeType: "text/csv", buffer: await readFile(new URL(`../../../crates/engines/data/${name}.csv`, import.meta.url)) })));
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
  await waitForText(reading, "Judging long.csv: [\\d.]+ of 13\\.\\d MB are read");
  await page.setInputFiles("#judge-file", several[0]);
  await waitForText(verdict, "Passed: mujoco");
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
  await waitForText(wrong, "Stopped: long.csv is not judged");
  wants("stopped, it shows no verdict, and the keyboard has its place", !(await page.isVisible(verdict)) && !(await page.isVisible(reading)) &&
    await page.evaluate(() => document.activeElement.id === "judge-go"));
  await long("#live-judge");
  await waitForText(verdict, "long.csv[^]*800000 rows");
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
  await waitForText(records, "Cannot be judged");
  const each = await page.locator(`${records} li`).allTextContents();
  wants(`each has its line: ${each}`, each.length === 3 && /^mujoco.*Passed: Every law.*Every step/.test(each[0]) &&
    /^rapier.*Failed: Every step tried agrees, to the [a-z' ]+, with: rescaled/.test(each[1]) && /^<b>none<\/b>.*Cannot be judged: line /.test(each[2]));
  await waitForText(verdict, "Passed: mujoco");
  await page.setInputFiles("#judge-file", [several[0], { name: "three.csv", mimeType: "text/csv", buffer: Buffer.from(three) }]);
  await waitForText("#live-judge .live-said", "2 records: 1 passed, 1 too short to judge");
  wants("each has its line, the short one too", /Too short to judge: /.test(await page.locator(`${records} li`).last().textContent()));
  await page.setInputFiles("#judge-file", [...several, { name: "<b>none</b>.csv", mimeType: "text/csv", buffer: Buffer.from("t,wx\n0,1\n") }]);
  await waitForText(records, "Cannot be judged");
  await waitForText(verdict, "Passed: mujoco");
  await page.locator(`${records} button`).first().focus();
  await page.keyboard.press("Tab");
  await page.keyboard.press("Enter");
  await waitForText(verdict, "Failed: rapier");
  wants("the keyboard stays with the list", await page.evaluate((s) => document.activeElement.closest(s) !== null, records));
  wants("one of them is shown as chosen", String(await page.locator(`${records} button`).evaluateAll((all) =>
    all.map((button) => button.getAttribute("aria-pressed")))) === "false,true,false");
  await page.click(`${records} li:last-child button`);
  await waitForText(wrong, "<b>none</b>.csv: line ");
  await page.click(`${records} li:nth-child(2) button`);
  await set(page, "#judge-threshold", "0.5");
  await waitForText(verdict, "Passed: rapier");
  await set(page, "#judge-threshold", "0.01");
  await waitForText(verdict, "Failed: rapier");

  // Dropped before the widget has come into view.
  await page.reload();
  await page.evaluate(() => scrollTo(0, 0));
  await long("main h1");
  await waitForText(verdict, "long.csv[^]*800000 rows");

  // The example is the record that the chapter reads.
  await page.locator("#judge-example").focus();
  await page.keyboard.press("Enter");
  await waitForText(verdict, "the example");
  const example = (await page.textContent(verdict)).replace(/\s+/g, " ");
  const words = await page.textContent("main");
  const [, from, to] = example.match(/goes from ([\d.]+) to ([\d.]+)/) ?? [];
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
