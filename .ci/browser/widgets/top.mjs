// A top.
import { atTime, broken, said, set, shown, turnsAndPlays } from "./controls.mjs";

/** The greatest lean of the chapter's top after it was let go, degrees: where its height u solves 400 (1 - u²) = (spin/4)² (u0 - u). */
function lowest(spin, lean) {
  const [pull, square, high] = [400, (spin / 4) ** 2, Math.cos((lean * Math.PI) / 180)];
  const u = (square - Math.sqrt(square * square - 4 * pull * (square * high - pull))) / (2 * pull);
  return (Math.acos(u) * 180) / Math.PI;
}

export async function top(page, wants) {
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
  wants(`it nods ${await tell("nods")}, goes round at ${await tell("round")}`, (await tell("nods")) === `every ${period}` && (await tell("round")) === `${rate} rad/s`);
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

  // All ends of all controls, of those too that are folded.
  await page.click("#live-top summary");
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
  wants("a screen reader gets the answer", (await page.getAttribute("#top-spin", "aria-valuetext")) === "205 rad/s");
  await topPlay(page, wants);
}

/** From the middle of its time on, so that there is some to go. */
export async function topPlay(page, wants) {
  await set(page, "#top-scrub", 0.5);
  await turnsAndPlays(page, wants, "top", atTime(page, "top"));
}
