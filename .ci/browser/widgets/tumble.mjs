// The tumble: what it says, and how it is played.
import { said, set, shown } from "./controls.mjs";
import { frames } from "./hands.mjs";
import { tumbleDrawn, tumblePlayed, tumbleRolls } from "./tumble.drawn.mjs";

/** What a drawing shows, summed up: another picture has another sum. */
const tumblePicture = (page, what) => page.locator(`#live-tumble [data-draws=${what}]`).evaluate((canvas) => {
  let sum = 0;
  const over = canvas.nextElementSibling; // what moves over it
  for (const letter of canvas.toDataURL() + (over ? getComputedStyle(over).transform : "")) sum = (31 * sum + letter.charCodeAt(0)) % 1000000007;
  return sum;
});

const tumbleShows = (page) => Promise.all(["beat", "next", "time", "flips", "spin"].map((what) => shown(page, "tumble", what)));

/** It moves when it is played: of itself, or by steps where less motion is preferred. */
export async function tumblePlay(page, wants) {
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

export async function tumble(page, wants) {
  const all = () => tumbleShows(page);
  const beat = () => shown(page, "tumble", "beat");
  const number = (text) => parseFloat(text.replace("−", "-"));
  const along = async () => number(await shown(page, "tumble", "spin"));
  const wrong = "#live-tumble .live-wrong";
  const complaint = async () => ((await page.isVisible(wrong)) ? page.textContent(wrong) : "nothing");
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
  const [, push, strong, weak, tiny] = text.match(/With a slip of ([\d.]+), it flips every ([\d.]+ s); with a slip of [^,]*, every ([\d.]+ s)\..*?flips the box every (\d+ s)/) ?? [];
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
    for (let i = 0; i <= 60; i += 1) {
      scrub.value = from + (to - from) * i / 60;
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
  wants("a screen reader gets the answer", /s, \d+ flips so far/.test(await page.getAttribute("#tumble-scrub", "aria-valuetext")));
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
  wants(`a spin of 1e-150 is shown: ${await all()}`, (await shown(page, "tumble", "spin")).startsWith("1.00 · 10⁻¹⁵⁰, 1.00 · 10⁻¹⁵², 0"));
  await set(page, "#tumble-spin-number", "10");

  // No push at all, no spin at all, and what is no number.
  await set(page, "#tumble-push", -1e9);
  wants(`without a push it never flips: ${await all()}`, /never/.test(await beat()) && (await page.inputValue("#tumble-push-number")) === "0");
  await set(page, "#tumble-time", "1e6");
  wants(`nor in a million seconds: ${await all()}`, (await along()) === 10 && (await shown(page, "tumble", "flips")) === "0");
  for (const [field, value, says] of [["spin", "", "The field for the spin has no number"], ["push", "", "The field for the slip has no number"], ["time", "", "The field for the time has no number"], ["time", "1e300", "f64"], ["spin", "1e-320", "floating-point"], ["push", "1e308", "finite"]]) {
    const selector = field === "time" ? "#tumble-time" : `#tumble-${field}-number`;
    await set(page, "#tumble-push-number", "0.01");
    await set(page, selector, value);
    wants(`${field} = "${value}" is called wrong, by "${says}", not by "${await complaint()}"`, (await complaint()).includes(says) && !(await complaint()).includes("#"));
    await set(page, selector, field === "spin" ? 10 : field === "push" ? 0.01 : 0);
    wants(`${field} put right is right again: ${await complaint()}`, (await complaint()) === "nothing");
  }
  for (const [spin, push] of [["-1e9", "1e9"], ["1e9", "1e9"], ["1e9", "-1e9"], ["-1e9", "-1e9"]]) {
    for (const body of [0, 3]) {
      await set(page, "#tumble-body", body);
      await set(page, "#tumble-spin", spin);
      await set(page, "#tumble-push", push);
      const text = await page.locator("#live-tumble .live-stage").innerText();
      wants(`body ${body}, spin ${spin}, push ${push}: ${await all()}, ${await complaint()}`, !/NaN|Infinity|undefined/.test(text) && (await complaint()) === "nothing");
    }
  }
  await set(page, "#tumble-spin-number", "1e300");
  wants(`a spin of 1e300: ${await all()}`, !/NaN|Infinity|undefined/.test(await page.locator("#live-tumble .live-stage").innerText()));
  await set(page, "#tumble-spin", 10);
  await set(page, "#tumble-push", -2);
  await set(page, "#tumble-body", 0);
  await set(page, "#tumble-time", "1.3");
}
