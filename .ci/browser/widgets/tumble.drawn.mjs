// What the tumble draws, read back from the page, and held to the module's answers by arithmetic of its own.
import { byHand, finger, frames, pass, waiting, watch } from "./hands.mjs";
import { cross, dot, fitted, near, read, size, turned, unit } from "./space.mjs";

/** The tumble at one setting: what it shows and draws at several instants, and what the module answers. */
async function looked(page, body, spin, push, parts) {
  return page.evaluate(async ([body, spin, push, parts]) => {
    const put = (id, value, event) => {
      const field = document.querySelector(`#tumble-${id}`);
      field.value = value;
      field.dispatchEvent(new Event(event));
    };
    put("body", body, "input");
    put("spin-number", spin, "input");
    put("push-number", push, "input");
    const stage = document.querySelector("#live-tumble");
    const shows = (what) => stage.querySelector(`[data-shows=${what}]`).textContent;
    const canvas = (what) => stage.querySelector(`[data-draws=${what}]`);
    const moved = (what) => (stage.querySelector(what).style.transform.match(/-?[\d.]+/g) ?? []).map(Number);
    const module = await tumblingLive.module("tumble");
    const prepared = Array.from(module.answer(0, body, spin, push, 0));
    const instants = parts.map((part) => {
      const t = part * prepared[0];
      put("time", t, "change");
      const scrub = stage.querySelector("#tumble-scrub");
      return {
        t, from: Number(scrub.min), to: Number(scrub.max),
        answer: Array.from(module.answer(1, t)),
        body: canvas("body").drawn, polhode: canvas("polhode").drawn, names: canvas("polhode").shows.names,
        dot: moved(".tumble-dot"), opacity: stage.querySelector(".tumble-dot").style.opacity,
        cursor: moved(".tumble-cursor")[0],
        shown: Object.fromEntries(["beat", "next", "time", "flips", "spin"].map((what) => [what, shows(what)])),
      };
    });
    const { from, to } = instants.at(-1);
    const stretch = Array.from(module.answer(2, from, to, 480));
    const pen = document.createElement("canvas").getContext("2d", { willReadFrequently: true });
    const probe = stage.appendChild(document.createElement("span"));
    probe.hidden = true; // nor has it a transition from one colour to the next
    const colours = Object.fromEntries(["omega", "momentum", "axis-mid", "separatrix", "faint"].map((name) => {
      probe.style.color = `var(--fig-${name})`;
      pen.fillStyle = getComputedStyle(probe).color;
      pen.fillRect(0, 0, 1, 1);
      return [name, `#${[...pen.getImageData(0, 0, 1, 1).data.slice(0, 3)].map((part) => part.toString(16).padStart(2, "0")).join("")}`];
    }));
    probe.remove();
    const middle = (what) => [canvas(what).clientWidth / 2, canvas(what).clientHeight / 2];
    return {
      prepared, instants, colours, stretch,
      strip: canvas("strip").drawn,
      middles: { body: middle("body"), polhode: middle("polhode"), strip: middle("strip") },
    };
  }, [body, spin, push, parts]);
}

/** The drawings of the tumble, and all numbers that it shows. */
export async function tumbleDrawn(page, wants) {
  await watch(page, "tumble");
  const parts = [0, 0.13, 0.31, 0.48, 0.55, 0.77, 1.02, 1.37, 1.49, 1.71, 2.2, 6.68];
  for (const [body, spin, push] of [[0, 10, 0.01], [2, -7, 0.4], [4, 12, -0.1]]) {
    const name = `body ${body}, spin ${spin}, push ${push}`;
    const { prepared, instants, colours, stretch, strip, middles } = await looked(page, body, spin, push, parts);
    const from = (middle, [x, y]) => [x - middle[0], y - middle[1]];

    // The body: the pin lies along its x, turned by the attitude, seen along some line in the world, the same at all instants.
    const strokes = (drawn, colour) => drawn.filter((part) => part.kind === "stroke" && part.colour === colours[colour]);
    const tips = (drawn, colour) => drawn.filter((part) => part.kind === "fill" && part.colour === colours[colour] && part.path.length === 3).map(({ path }) => path[0]);
    const pins = instants.map(({ answer, body }) => [turned(answer.slice(3, 7), [1, 0, 0]), from(middles.body, strokes(body, "axis-mid")[0].path[1])]);
    const view = fitted(pins);
    wants(`${name}: the pin is drawn where the attitude turns it, but for ${view.left} px`, view.left < 0.01);
    const [across, down] = view.rows;
    wants(`${name}: it is seen as it is, neither drawn out nor mirrored`, near(size(across) / size(down), 1, 1e-6) && near(dot(across, down) / size(down) ** 2, 0, 1e-6));
    const momentum = unit(prepared.slice(7, 10));
    const sight = cross(across, down.map((x) => -x));
    wants(`${name}: from a little above`, dot(unit(sight), momentum) > 0.2 && dot(unit(sight), momentum) < 0.6);
    const onto = (v) => [dot(across, v), dot(down, v)];
    for (const { t, answer, body } of instants) {
      const [up] = tips(body, "momentum").map((tip) => from(middles.body, tip));
      wants(`${name}, at ${t}: the momentum's arrow points straight up: ${up}`, up && near(up[0], 0, 0.01) && up[1] < -20);
      const right = onto(momentum);
      wants(`${name}: up is where the momentum is`, right[1] < 0 && near(right[0], 0, 0.01));
      const [tip] = tips(body, "omega").map((tip) => from(middles.body, tip));
      const spun = onto(unit(answer.slice(7, 10)));
      const reach = size(tip ?? [0, 0]) / size(spun);
      wants(`${name}, at ${t}: the spin's arrow ${tip} lies along ${spun}`, tip && Math.hypot(tip[0] - reach * spun[0], tip[1] - reach * spun[1]) < 0.01);
      const world = turned(answer.slice(3, 7), answer.slice(0, 3));
      wants(`${name}, at ${t}: the spin along the body's axes is that in the world`, Math.hypot(...world.map((x, k) => x - answer[7 + k])) < 1e-9 * Math.abs(spin));
    }

    // The ellipsoid: the dot is the spin in the world, seen along the same line as the body.
    const spots = instants.map(({ answer, dot: spot }) => [answer.slice(7, 10).map((x) => x * prepared[12]), from(middles.polhode, spot)]);
    const seen = fitted(spots);
    const [right, low] = seen.rows;
    wants(`${name}: the dot is where the spin is, but for ${seen.left} px`, seen.left < 0.3);
    wants(`${name}: on an ellipsoid seen as it is`, near(size(right) / size(low), 1, 0.02) && near(dot(right, low) / size(low) ** 2, 0, 0.02));
    wants(`${name}: in the body's attitude`, dot(unit(right), unit(across)) > 0.999 && dot(unit(low), unit(down)) > 0.999);
    const toward = cross(right, low.map((x) => -x));
    for (const { t, answer, dot: spot, opacity, polhode, names } of instants) {
      const attitude = answer.slice(3, 7);
      for (const [k, axis] of ["x", "y", "z"].entries()) {
        const place = from(middles.polhode, names[axis]);
        const leads = turned(attitude, [0, 1, 2].map((i) => Number(i === k)));
        const along = [dot(right, leads) / size(right), dot(low, leads) / size(right)];
        if (size(along) > 0.2) wants(`${name}, at ${t}: the axis ${axis} is named where it comes out: ${place}`,
          place && dot(place, along) > 0 && Math.abs(place[0] * along[1] - place[1] * along[0]) / size(along) < 3);
      }
      const own = polhode.filter((part) => part.kind === "stroke" && part.colour === colours.omega).flatMap(({ path }) =>
        path.flatMap(([x, y, how], i) => (how === "lineTo" ? [[path[i - 1], [x, y]]] : [])));
      wants(`${name}, at ${t}: the spin's own polhode is drawn, in ${own.length} pieces`, own.length >= 240);
      const off = Math.min(...own.map(([a, b]) => {
        const [u, v] = [[b[0] - a[0], b[1] - a[1]], [spot[0] - a[0], spot[1] - a[1]]];
        const part = Math.max(0, Math.min(1, dot(u, v) / (dot(u, u) || 1)));
        return Math.hypot(v[0] - part * u[0], v[1] - part * u[1]);
      }));
      wants(`${name}, at ${t}: the dot lies on it, but for ${off} px`, off < 1.5);
      const facing = dot(unit(turned(attitude, answer.slice(0, 3).map((x, k) => x * prepared[1 + k]))), unit(toward));
      if (Math.abs(facing) > 0.03) wants(`${name}, at ${t}: the dot is on the side that it shows`, (opacity === "1") === (facing > 0));
    }

    // The strip: time from left to right, the spin along the middle axis upward.
    const { from: first, to: last } = instants.at(-1);
    const [flips, samples] = [stretch.slice(1, 1 + stretch[0]), stretch.slice(1 + stretch[0])];
    const [[left, level], [end]] = strokes(strip, "faint")[0].path;
    const at = (t) => left + (end - left) * (t - first) / (last - first);
    const marks = strokes(strip, "separatrix").map(({ path }) => path[0][0]);
    wants(`${name}: the flips are marked at ${marks}, not ${flips.map(at)}`,
      flips.length > 2 && marks.length === flips.length && flips.every((flip, i) => near(marks[i], at(flip), 0.05)));
    for (const { text, path: [[x]] } of strip.filter(({ kind }) => kind === "text")) {
      wants(`${name}: "${text}" stands below a flip`, flips.some((flip) => near(at(flip), x, 0.05) && near(read(text), flip, 0.0051)));
    }
    const [curve] = strokes(strip, "axis-mid").map(({ path }) => path);
    const most = samples.reduce((best, x, i) => (Math.abs(x) > Math.abs(samples[best]) ? i : best), 0);
    const high = (level - curve[most][1]) / samples[most];
    wants(`${name}: the spin's curve is high enough, and upright`, high > 0 && high * Math.abs(samples[most]) > 0.3 * middles.strip[1]);
    wants(`${name}: it is drawn as it goes`, curve.length === samples.length && curve.every(([x, y], i) =>
      near(x, at(first + (last - first) * i / (samples.length - 1)), 0.01) && near(level - y, high * samples[i], 0.01)));
    for (const { t, from: first, to: last, cursor } of instants) {
      wants(`${name}, at ${t}: the cursor stands at ${cursor}`, near(cursor, left + (end - left) * (t - first) / (last - first), 0.06));
    }

    // Every number.
    for (const { t, answer, shown } of instants) {
      const [spins, next] = [shown.spin, shown.next].map((text) => text.split(", ").map(read));
      wants(`${name}, at ${t}: ${Object.values(shown).join("; ")}`,
        near(read(shown.beat), prepared[0], 0.0051) && near(read(shown.time), t, 0.0051) && Number(shown.flips) === answer[10]
        && Math.round(t / prepared[0]) === answer[10]
        && spins.length === 3 && spins.every((x, k) => near(x, answer[k], 0.0051))
        && next.length === 3 && next.every((x, k) => near(x, answer[11 + k], 0.0051) && near(x, (answer[10] + k + 0.5) * prepared[0], 0.0051)));
    }
  }
}

/** The ellipsoid on its plane: it touches opposite the spin, and what touches does not slip; ridden on, the body keeps still and the momentum moves. */
export async function tumbleRolls(page, wants, set) {
  await set(page, "#tumble-body", 0);
  await set(page, "#tumble-spin-number", 10);
  await set(page, "#tumble-push-number", 0.3);
  const shows = (what) => page.locator(`#live-tumble [data-draws=${what}]`).evaluate((canvas) => JSON.parse(JSON.stringify(canvas.shows)));
  await set(page, "#tumble-rolling", "plane");
  for (const t of [0, 0.2, 0.7, 1.9]) {
    await set(page, "#tumble-time", t);
    const { rolls, touches, spot } = await shows("polhode");
    wants(`rolling, at ${t}: the dot ${spot} is where the plane is touched, ${touches}`, rolls && Math.hypot(touches[0] - spot[0], touches[1] - spot[1]) < 0.3);
  }
  await set(page, "#tumble-rolling", "polhode");
  await set(page, "#tumble-ride", "body");
  const [bodies, momenta] = [[], []];
  for (const t of [0, 0.3, 1.1]) {
    await set(page, "#tumble-time", t);
    const { body, labels } = await shows("body");
    bodies.push(Object.values(body.xs).map((x) => x.toFixed(3)).join());
    momenta.push(labels.find(({ name }) => name === "L").left);
  }
  wants("ridden on, the body keeps still", new Set(bodies).size === 1);
  wants(`and the momentum goes round it: ${momenta}`, new Set(momenta).size === 3);
  await set(page, "#tumble-ride", "room");

  // Bodies of the reader's own.
  for (const [which, values, says] of [[8, [1, 2, 2.5], ""], [9, [1, 2, 2.5], ""], [9, [1, 2, 3.5], "two of them must add up"], [8, [0, 1, 2], "above zero"], [8, [1, 1, 2], ""]]) {
    await set(page, "#tumble-body", which);
    for (const [k, id] of ["a", "b", "c"].entries()) await set(page, `#tumble-${id}`, values[k]);
    const wrong = page.locator("#live-tumble .live-wrong");
    const complaint = (await wrong.isVisible()) ? await wrong.textContent() : "";
    wants(`own body ${which}, ${values}: it says "${complaint}", not "${says}"`, says === "" ? complaint === "" : complaint.includes(says));
    await set(page, "#tumble-a", 1);
  }
  wants("a body with two equal moments never flips", /never/.test(await page.textContent("#live-tumble [data-shows=beat]")));
  await set(page, "#tumble-body", 0);

  // Looked round by a finger, in many small moves: the view follows to the end.
  const ellipsoid = page.locator("#live-tumble [data-draws=polhode]");
  await ellipsoid.scrollIntoViewIfNeeded();
  const paper = await ellipsoid.boundingBox();
  const along = (part) => [paper.x + (0.3 + 0.4 * part) * paper.width, paper.y + (0.4 + 0.2 * part) * paper.height];
  const away = await finger(page, along(0), Array.from({ length: 25 }, (_, i) => along((i + 1) / 25)));
  const [turns, tilts] = await Promise.all(["turn", "tilt"].map((id) => page.inputValue(`#tumble-${id}`)));
  wants(`under a finger the page does not scroll: ${away} px`, away === 0);
  wants(`the view follows the finger to its end: ${turns}, ${tilts}`, near(turns - 28, 0.2 * paper.width, 1) && near(tilts - 22, 0.1 * paper.height, 1));

  // A flick: the body spins about the line across the finger's way, from where it stood.
  await set(page, "#tumble-time", 0.4);
  const canvas = page.locator("#live-tumble [data-draws=body]");
  await canvas.scrollIntoViewIfNeeded();
  const box = await canvas.boundingBox();
  const at = (x, y) => [box.x + x * box.width, box.y + y * box.height];
  const spin = () => page.textContent("#live-tumble [data-shows=spin]");
  const before = await spin();
  const scrolled = await finger(page, at(0.3, 0.5), Array.from({ length: 8 }, (_, i) => at(0.3 + 0.08 * i, 0.5)), 10);
  wants(`under a finger the page does not scroll: ${scrolled} px`, scrolled === 0);
  wants(`flicked, it spins otherwise than ${before}`, (await spin()) !== before && (await page.textContent("#live-tumble [data-shows=time]")) === "0.00 s");
  await set(page, "#tumble-body", 0);
  await set(page, "#tumble-turn", 28);
  await set(page, "#tumble-tilt", 22);
}

/** The tumble's time: one loop however often the button is pressed, as fast as is set, at rest out of sight. */
export async function tumblePlayed(page, wants, set) {
  const before = await page.evaluate(() => (matchMedia("(prefers-reduced-motion: reduce)").matches ? "reduce" : "no-preference"));
  const [play, time] = ["#tumble-play", "#live-tumble [data-shows=time]"];
  await page.emulateMedia({ reducedMotion: "no-preference" });
  await set(page, "#tumble-body", 0);
  await set(page, "#tumble-spin-number", 10);
  await set(page, "#tumble-push-number", 0.01);
  await set(page, "#tumble-speed", 0);
  await byHand(page);
  await page.evaluate((play) => [1, 2, 3].forEach(() => document.querySelector(play).click()), play);
  wants(`pressed three times it waits for one frame, not ${await waiting(page)}`, (await waiting(page)) === 1);
  await pass(page, 50, 20);
  await page.click(play);
  wants(`a second is a second: ${await page.textContent(time)}`, (await page.textContent(time)) === "1.00 s");
  wants("paused, it waits for none", (await waiting(page)) === 0);
  await set(page, "#tumble-speed", -0.3);
  await page.click(play);
  await pass(page, 50, 20);
  await page.click(play);
  wants(`and half of one at half the pace: ${await page.textContent(time)}`, (await page.textContent(time)) === "1.50 s");
  await page.click(play);
  await page.emulateMedia({ reducedMotion: "reduce" });
  await page.waitForFunction((play) => document.querySelector(play).textContent === "Step", play, { polling: 50, timeout: 60000 })
    .catch(() => wants("asked for less motion it goes by steps", false));
  wants("and waits for no frame", (await waiting(page)) === 0);
  await page.emulateMedia({ reducedMotion: "no-preference" });
  await page.click(play);
  await page.evaluate(() => scrollTo(0, document.body.scrollHeight));
  await page.waitForFunction((play) => document.querySelector(play).textContent === "Play", play, { polling: 50, timeout: 60000 })
    .catch(() => wants("out of sight it rests", false));
  await page.evaluate(() => window.byHand.end());
  await page.emulateMedia({ reducedMotion: before });
  await page.locator("#live-tumble").scrollIntoViewIfNeeded();

  // Forced colours are taken on at once.
  const ink = () => page.locator("#live-tumble [data-draws=body]").evaluate((canvas) => {
    const pen = document.createElement("canvas").getContext("2d");
    const probe = document.body.appendChild(document.createElement("span"));
    probe.style.color = matchMedia("(forced-colors: active)").matches ? "CanvasText" : "var(--fg)";
    pen.fillStyle = getComputedStyle(probe).color;
    probe.remove();
    return [canvas.drawn.at(-1).colour, pen.fillStyle];
  });
  await page.emulateMedia({ forcedColors: "active" });
  await frames(page);
  const [forced, meant] = await ink();
  wants(`in forced colours it is drawn in ${meant}, not ${forced}`, forced === meant);
  await page.emulateMedia({ forcedColors: "none" });
  await frames(page);
  const [again, own] = await ink();
  wants("and in its own again", again === own && again !== forced);
}
