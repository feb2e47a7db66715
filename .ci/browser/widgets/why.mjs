// Why just the middle axis: the pulls in the turning frame, and the curve where sphere and ellipsoid meet.
import { read } from "../drawn.flat.mjs";
import { said, set, shown } from "./controls.mjs";
import { finger, frames } from "./hands.mjs";
import { cross, dot, near, size } from "./space.mjs";

const MASSES = [1, 1, 0.5, 0.5]; // kg
const MOMENTS = [0.08, 0.12, 0.04]; // about x, y, z, of those at 0.2 m on z and x
const ENERGY = 0.16; // J

const canvas = (page, what) => page.locator(`#live-why [data-draws=${what}]`);
const shows = (page, what) => canvas(page, what).evaluate((canvas) => JSON.parse(JSON.stringify(canvas.shows)));

/** Each mass is pulled away from the axis by its mass, its distance and the square of one rate. */
async function pulls(page, wants, name) {
  const { masses, up } = await shows(page, "body");
  const rates = masses.map(({ place, out, aside }, k) => {
    const away = place.map((x, i) => x - dot(place, up) * up[i]);
    wants(`${name}: each mass stays 0.2 m from the middle: ${size(place)}`, near(size(place), 0.2, 1e-9));
    wants(`${name}: it is pulled straight away from the axis`, size(cross(out, away)) < 1e-9 && dot(out, up) < 1e-9);
    wants(`${name}: and turned aside across the axis`, Math.abs(dot(aside, up)) < 1e-9);
    return dot(out, away) / (MASSES[k] * dot(away, away));
  });
  wants(`${name}: one rate for all: ${rates}`, rates.every((rate) => near(rate, rates[0], 1e-6)));
  const [heavy, light] = [0, 2].map((k) => size(masses[k].out));
  const [h, l] = [read(await shown(page, "why", "heavy")), read(await shown(page, "why", "light"))];
  wants(`${name}: it says ${h} and ${l} N of ${heavy} and ${light}`, near(h, heavy, 0.0051) && near(l, light, 0.0051));
}

export async function why(page, wants) {
  const tilt = async () => read(await shown(page, "why", "tilt"));
  const flips = async () => Number(await shown(page, "why", "flips"));
  for (const [start, turns] of [["hard", false], ["easy", false], ["middle", true]]) {
    await page.click(`[data-start=${start}]`);
    wants(`${start}: it is the one that is chosen`, (await page.getAttribute(`[data-start=${start}]`, "aria-pressed")) === "true");
    let [most, pointed] = [0, 0];
    for (let i = 0; i < 40; i += 1) {
      await page.click("#why-play");
      most = Math.max(most, await tilt());
      if (i % 8 === 0) await pulls(page, wants, `${start}, ${i}`);
      const { now } = await shows(page, "globe");
      pointed = Math.max(pointed, ...[0, 1, 2].map((k) => (k === { hard: 1, easy: 2, middle: 0 }[start] ? 0 : Math.abs(now[k]) / size(now))));
      const energy = now.reduce((sum, x, k) => sum + x * x / (2 * MOMENTS[k]), 0);
      wants(`${start}: the point keeps to the ellipsoid: ${energy} J`, near(energy, ENERGY, 1e-9));
    }
    wants(`${start}: it tilts by at most ${most}°, and has flipped ${await flips()} times`, turns ? most > 170 && (await flips()) >= 2 : most < 20 && (await flips()) === 0 && pointed < 0.4);
  }
  wants(...await said(page, "why", /flips \d; pulled outward with/));
  await page.click("#why-back");
  wants("back, it leans by three degrees again", (await tilt()) === 3);

  // The curve lies on both, at each size; and says what it is.
  const [least, most] = await Promise.all(["min", "max"].map(async (end) => Number(await page.getAttribute("#why-size", end))));
  for (const [length, says] of [[least, /two points/], [0.9 * least + 0.1 * most, /about the heavy rod/], [Math.sqrt(2 * ENERGY * 0.08), /cross/], [0.1 * least + 0.9 * most, /across both/], [most, /two points/]]) {
    await set(page, "#why-size", length);
    const { curve, length: drawn } = await shows(page, "globe");
    wants(`of size ${length} it is drawn as ${drawn}`, near(drawn, length, 1e-3));
    const off = Math.max(...curve.map((p) => Math.max(Math.abs(size(p) / drawn - 1), Math.abs(p.reduce((sum, x, k) => sum + x * x / (2 * MOMENTS[k]), 0) / ENERGY - 1))));
    wants(`of size ${length} the curve is off sphere and ellipsoid by ${off}`, off < 1e-6);
    wants(`of size ${length} it says "${await shown(page, "why", "words")}"`, says.test(await shown(page, "why", "words")));
  }
  await page.focus("#why-size");
  await set(page, "#why-size", 0.5 * (least + most));
  const before = (await shows(page, "globe")).length;
  await page.keyboard.press("ArrowLeft");
  wants("an arrow key shrinks the sphere", (await shows(page, "globe")).length < before);

  // The point is dragged by a finger and let go; beside it a finger looks round, and a thumb scrolls past.
  await page.click("[data-start=easy]");
  await canvas(page, "globe").scrollIntoViewIfNeeded();
  const box = await canvas(page, "globe").boundingBox();
  const { spot, now } = await shows(page, "globe");
  const from = [box.x + spot[0], box.y + spot[1]];
  const scrolled = await finger(page, from, Array.from({ length: 16 }, (_, i) => [from[0] + i, from[1] - 3 * i]));
  const dragged = await shows(page, "globe");
  wants(`the point follows the finger, and the page stays: ${scrolled} px`, scrolled === 0 && size(dragged.now.map((x, k) => x - now[k])) > 0.02);
  const view = async (what) => { const { turn, tilt: above } = await shows(page, what); return [turn, above]; };
  for (const what of ["body", "globe"]) {
    const [left, top, wide, high] = await canvas(page, what).boundingBox().then((b) => [b.x, b.y, b.width, b.height]);
    const [turn] = await view(what);
    const still = await finger(page, [left + 0.3 * wide, top + 0.92 * high], Array.from({ length: 20 }, (_, i) => [left + 0.3 * wide + 4 * i, top + 0.92 * high]));
    wants(`${what}: a finger looks round, and the page stays: ${still} px`, still === 0 && near((await view(what))[0] - turn, 38, 1.1));
  }
  const past = await finger(page, [box.x + 12, box.y + 0.9 * box.height], Array.from({ length: 20 }, (_, i) => [box.x + 12, box.y + 0.9 * box.height - 10 * i]));
  wants(`a thumb scrolls past: ${past} px`, past > 50);
}

/** Let go, it moves; paused, it rests; and what is chosen meanwhile goes on moving. */
export async function whyPlay(page, wants) {
  const t = async () => (await shows(page, "body")).t;
  await page.click("#why-play");
  await page.waitForFunction(() => document.querySelector("#live-why canvas").shows.t > 0.1).catch(() => wants("let go, it moves", false));
  await page.click("[data-start=easy]");
  wants("another start is let go at once", (await page.textContent("#why-play")) === "Pause");
  await page.waitForFunction(() => document.querySelector("#live-why canvas").shows.t > 0.1).catch(() => wants("and moves", false));
  await page.click("#why-play");
  const stood = await t();
  await frames(page, 12);
  wants("paused, it rests", (await t()) === stood && (await page.textContent("#why-play")) === "Let go");
}
