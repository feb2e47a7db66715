// What the pitfalls draw, read back from the page, and held to the module's answers by arithmetic of its own.
import { byHand, finger, pass, waiting } from "./hands.mjs";
import { fitted, near, read, size, turned } from "./space.mjs";

/** The drawings of the pitfalls, and all numbers that they show, as far as they have gone. */
async function engines(page, wants, name) {
  const rows = await page.evaluate(async () => {
    const stage = document.querySelector("#live-pitfalls");
    const chosen = (id) => stage.querySelector(`#pitfalls-${id}`).value;
    const shows = (what) => stage.querySelector(`[data-shows=${what}]`).textContent;
    const plain = (what) => parseFloat(shows(what)); // the tests choose no number that is written with a power
    const [engines, motion] = [await tumblingLive.module("pitfalls"), await tumblingLive.module("tumble")];
    const push = (axis) => (chosen("about") === "both" || chosen("about") === axis ? plain("push") : 0);
    const start = [...motion.answer(7, Number(chosen("body"))).slice(0, 3), plain("spin"), push("y"), push("z")];
    const [step, until, time] = [plain("step"), parseFloat(shows("until")), parseFloat(shows("time"))];
    const exact = motion.answer(5, ...start, until, 1200);
    const points = (d) => d.split(/[ML]/).filter(Boolean).map((point) => point.split(" ").map(Number));
    return [...stage.querySelectorAll(".live-engine")].map((row, which) => {
      const tip = ["cx", "cy"].map((x) => Number(row.querySelector(".live-tip").getAttribute(x)));
      const axis = row.querySelector(".live-axis").getAttribute("d").match(/[\d.]+/g).map(Number);
      // As many steps as the drawing has gone: from it alone the count cannot be read where steps are small beside a pixel.
      const count = Math.round(time / step);
      let found = engines.answer(0, ...start, which);
      const first = Array.from(found.slice(0, 24));
      const all = { spins: [found.at(-1)], low: found[13], high: found[14], flips: 0, turned: 0 };
      for (let taken = 0; taken < count;) {
        const some = Math.min(1000, count - taken);
        found = engines.answer(1, ...start, which, step, taken, some, ...found.slice(1, 10));
        taken += found[0];
        all.spins.push(...found.slice(24));
        all.low = Math.min(all.low, found[13]);
        all.high = Math.max(all.high, found[14]);
        if (found[15] > 0 && all.flips === 0) all.turned = found[16];
        all.flips += found[15];
        if (found[0] < some) break;
      }
      const [energy, length, angle] = found.slice(10, 13);
      return {
        ...all, energy, length, angle, first, step, until, time, tip, axis,
        right: Array.from(exact.slice(1, 1 + exact[0])), spun: Array.from(exact.slice(1 + exact[0])),
        exact: points(row.querySelector(".live-exact")?.getAttribute("d") ?? ""),
        ran: [...row.querySelectorAll("path.live-ran")].flatMap((path) => points(path.getAttribute("d"))),
        attitude: Array.from(found.slice(1, 5)), measured: Array.from(found.slice(18, 24)), body: row.querySelector("canvas").shows,
        shown: Object.fromEntries([...row.querySelectorAll("[data-of]")].map((place) => [place.dataset.of, place.textContent])),
      };
    });
  });
  for (const [which, row] of rows.entries()) {
    const says = `${name}, engine ${which}`;
    const { spins, step, until, time, tip, exact, ran, spun } = row;
    const [left, middle, right] = row.axis;
    const x = (t) => left + (right - left) * t / until;
    const most = spun.reduce((best, value, i) => (Math.abs(value) > Math.abs(spun[best]) ? i : best), 0);
    const high = (middle - exact[most]?.[1]) / spun[most];
    wants(`${says}: the exact spin is drawn upright, ${high * Math.abs(spun[most])} px high`, high > 0 && high * Math.abs(spun[most]) > 12);
    wants(`${says}: and as it goes`, exact.length === spun.length && exact.every(([across, y], i) =>
      near(across, x(until * i / (spun.length - 1)), 0.06) && near(middle - y, high * spun[i], 0.12)));
    const limit = 1.15 * Math.abs(spun[most]);
    const y = (value) => middle - high * Math.max(-limit, Math.min(limit, value));
    // A drawn point stands for some steps about its time.
    const bundle = Math.ceil((until / step + 1) / 1200);
    const strays = ran.filter(([across, up]) => {
      const at = ((across - left) / (right - left)) * until / step;
      const slack = bundle + 1 + 0.06 * until / step / (right - left);
      const some = spins.slice(Math.max(0, Math.floor(at - slack)), Math.ceil(at + slack) + 1).map(y);
      return !(up >= Math.min(...some) - 0.12 && up <= Math.max(...some) + 0.12);
    });
    wants(`${says}: ${strays.length} of ${ran.length} drawn points are not where it went, as ${strays[0]}`, strays.length === 0 && ran.length >= spins.length / bundle - 1);
    wants(`${says}: its line has its highs and lows`, [Math.min, Math.max].every((best) =>
      near(best(...ran.map(([, up]) => up)), best(...spins.map(y)), 0.12)));
    wants(`${says}: its point stands at ${tip}, at the end of its line`, near(tip[0], x(step * (spins.length - 1)), 0.06) && near(tip[1], y(spins.at(-1)), 0.06));
    if (which === 0 && time > 0) {
      const off = Math.max(...ran.map(([across, up]) => Math.min(...exact.map(([a, b]) => Math.hypot(a - across, b - up)))));
      wants(`${says}: the right one runs along the exact spin, but for ${off} px`, off < 3);
    }

    // Its readouts: what is off by less than a thousandth is kept.
    const { energy, angle, flips } = row.shown;
    const met = [Math.min(row.low, 1), Math.max(row.high, 1)].filter((ratio) => Math.abs(ratio - 1) >= 1e-3).map((ratio) => 100 * (ratio - 1));
    const displayed = energy === "kept" ? [] : energy.split("/").map(read);
    wants(`${says}: its energy goes from ${row.low} to ${row.high}, shown as ${energy}`,
      displayed.length === met.length && displayed.every((part, k) => near(part, met[k], Math.max(0.51, 0.006 * Math.abs(met[k])))));
    const kept = row.angle * Math.PI / 180 < 1e-3 && Math.abs(row.length - 1) < 1e-3;
    const longer = 100 * (row.length - 1);
    const words = kept ? ["kept", 0, 0]
      : row.angle >= 0.5 || Math.abs(longer) < 0.1 ? ["° off", row.angle, row.angle < 0.5 ? 0.051 : 0.51]
      : [` % too ${longer > 0 ? "long" : "short"}`, Math.abs(longer), Math.max(Math.abs(longer) < 0.5 ? 0.051 : 0.51, 0.006 * Math.abs(longer))];
    wants(`${says}: its momentum is ${row.angle}° off and ${longer} % longer, shown as ${angle}`,
      angle.endsWith(words[0]) && (kept || near(read(angle), words[1], words[2])));
    const passed = row.right.filter((t) => t <= time).length;
    wants(`${says}: ${row.flips} flips, right ${passed}, shown as ${flips}`, flips === `${row.flips} of ${passed}`);

    // Its body: the spin and the momentum are those measured on it.
    const [spin, momentum] = [row.measured.slice(0, 3), row.measured.slice(3)];
    for (const [name, right] of [["omega", spin], ["momentum", momentum]]) {
      if (size(right) > 0) wants(`${says}: its ${name} points along ${row.body[name]}, not ${right}`, row.body[name].every((x, k) => near(x, right[k] / size(right), 1e-6)));
    }
  }
  if (rows[0].time > 0) {
    const pins = rows.map(({ attitude, body: { body: { xs, ys } } }) => {
      const [from, to] = [Object.values(xs).length - 3, Object.values(xs).length - 2];
      return [turned(attitude, [1, 0, 0]), [xs[to] - xs[from], ys[to] - ys[from]]];
    });
    const { left } = fitted(pins);
    wants(`${name}: each body stands as its engine turned it, but for ${left} px`, left < 0.01);
  }
}

export async function pitfallsDrawn(page, wants, set) {
  const before = await page.evaluate(() => (matchMedia("(prefers-reduced-motion: reduce)").matches ? "reduce" : "no-preference"));
  const [play, time] = ["#pitfalls-play", "#live-pitfalls [data-shows=time]"];
  await page.click("#live-pitfalls [data-start='1']");
  await engines(page, wants, "pitfall one, at the start");
  await page.click("#pitfalls-end");
  await engines(page, wants, "pitfall one, at the end");

  // Played, a second is a second; then on, another body, another push.
  await page.emulateMedia({ reducedMotion: "no-preference" });
  for (const [control, value] of [["body", 1], ["about", "z"], ["spin", 5], ["push", 9], ["step", 2], ["until", 0]]) await set(page, `#pitfalls-${control}`, value);
  await byHand(page);
  await page.evaluate((play) => [1, 2, 3].forEach(() => document.querySelector(play).click()), play);
  wants(`pressed three times it waits for one frame, not ${await waiting(page)}`, (await waiting(page)) === 1);
  await pass(page, 40, 50);
  await page.click(play);
  wants(`two seconds are two seconds: ${await page.textContent(time)}`, (await page.textContent(time)) === "2.0 s of 5 s");
  wants("paused, it waits for none", (await waiting(page)) === 0);
  await page.click("#pitfalls-end");
  await engines(page, wants, "the book, pushed about z, at the end");
  await page.click("#pitfalls-reset");

  // Less motion, asked for while it runs.
  await page.click(play);
  await pass(page, 4, 50);
  await page.emulateMedia({ reducedMotion: "reduce" });
  await page.waitForFunction((play) => document.querySelector(play).textContent === "Step", play, { polling: 50, timeout: 60000 })
    .catch(() => wants("asked for less motion while it runs it goes by steps", false));
  wants("and waits for no frame", (await waiting(page)) === 0);
  await page.emulateMedia({ reducedMotion: "no-preference" });
  await page.waitForFunction((play) => document.querySelector(play).textContent === "Play", play, { polling: 50, timeout: 60000 })
    .catch(() => wants("motion allowed again it plays", false));
  await page.evaluate(() => window.byHand.end());
  await page.emulateMedia({ reducedMotion: before });

  // Turned by a finger: all four together, and the page keeps its place.
  await page.click("#live-pitfalls [data-start='1']");
  await page.click("#pitfalls-end");
  const canvas = page.locator("#live-pitfalls canvas").nth(2);
  await canvas.scrollIntoViewIfNeeded();
  const box = await canvas.boundingBox();
  const bodies = () => page.locator("#live-pitfalls canvas").evaluateAll((all) => all.map((one) => Array.from(one.shows.body.xs).join()));
  const stood = await bodies();
  const round = () => canvas.evaluate((one) => one.shows.turn);
  const began = await round();
  const at = (part) => [box.x + part * box.width, box.y + 0.5 * box.height];
  const scrolled = await finger(page, at(0.2), Array.from({ length: 20 }, (_, i) => at(0.2 + 0.03 * (i + 1))));
  const turns = await bodies();
  wants(`the bodies follow the finger to its end: by ${(await round()) - began}° over ${0.6 * box.width} px`, near((await round()) - began, 0.3 * box.width, 1));
  wants(`under a finger the page does not scroll: ${scrolled} px`, scrolled === 0);
  wants("all four bodies turn with it", turns.every((places, i) => places !== stood[i]));
  await page.mouse.move(...at(0.8));
  await page.mouse.down();
  for (let i = 1; i <= 20; i += 1) await page.mouse.move(...at(0.8 - 0.03 * i));
  await page.mouse.up();
  wants("and with the mouse", (await bodies()).every((places, i) => places !== turns[i]));
}
