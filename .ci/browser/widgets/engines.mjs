// Three engines beside the exact motion: each loses the spin, and gives up, when the chapter says.
import { shown } from "./controls.mjs";
import { finger } from "./hands.mjs";
import { dot, near, size, turned, unit } from "./space.mjs";

const MOMENTS = [2, 3, 1]; // kg m², in the order of the drawing
const shows = (page) => page.locator("#live-engines canvas").evaluateAll((all) => all.map((canvas) => canvas.shows));
const words = (page) => page.locator("#live-engines .toss-count").allTextContents();

export async function engines(page, wants) {
  const text = (await page.textContent("main")).replace(/\s+/g, " ");
  const [, ...lost] = text.match(/passes 60° after ([\d.]+) s in pybullet, ([\d.]+) s in Rapier and ([\d.]+) s in MuJoCo/) ?? [];
  const [, rests] = text.match(/At ([\d.]+) s MuJoCo notices/) ?? [];
  const cut = `cut off at ${text.match(/Bullet cuts each component of the spin off at (100 rad\/s)/)?.[1]}`;
  wants(`the chapter says when each is lost: ${lost}, ${rests}, ${cut}`, lost.length === 3 && rests !== undefined && !cut.includes("undefined"));
  const [first] = await shows(page);
  const energy = ({ spin }) => dot(spin, spin.map((x, k) => x * MOMENTS[k]));
  const world = ({ attitude, momentum }) => turned(attitude, momentum);
  let rose = false;
  for (let seconds = 5; seconds <= 60; seconds += 5) {
    await page.click("#engines-play");
    const [exact, pybullet, rapier, mujoco] = await shows(page);
    wants(`${seconds} s: the exact motion keeps its energy and its momentum in the room`, near(energy(exact) / energy(first), 1, 1e-12)
      && size(world(exact).map((x, k) => x - first.momentum[k])) < 1e-10 * size(first.momentum));
    wants(`${seconds} s: Rapier's rule keeps the momentum's length`, near(size(rapier.momentum) / size(first.momentum), 1, 1e-9));
    rose ||= energy(pybullet) > 1.05 * energy(first) && energy(mujoco) > 1.005 * energy(first);
    const told = await words(page);
    wants(`${seconds} s: the exact spin stays near its axis: ${told[0]}`, /^leans [0-4]°$/.test(told[0]));
    for (const [k, name] of ["pybullet", "Rapier", "MuJoCo"].entries()) {
      const right = name === "MuJoCo" && seconds > rests ? `gave up at ${rests} s` : seconds > lost[k] ? `lost at ${lost[k]} s` : "leans ";
      wants(`${seconds} s: of ${name} it says "${told[k + 1]}", not "${right}"`, told[k + 1].startsWith(right) || (name === "pybullet" && seconds > lost[k] && told[k + 1] === cut));
    }
  }
  wants(`the explicit step adds energy, and pybullet ends at its limit: ${await words(page)}`, rose && (await words(page))[1] === cut);
  wants(`it ends after a minute: ${await shown(page, "engines", "time")}`, (await shown(page, "engines", "time")) === "60.0 s");
  await page.click("#engines-back");
  const again = await shows(page);
  wants("back, all four stand as at the start", again.every(({ spin, t }) => t === 0 && near(dot(unit(spin), unit(first.spin)), 1, 1e-12)));
  const canvas = page.locator("#live-engines canvas").nth(2);
  await canvas.scrollIntoViewIfNeeded();
  const box = await canvas.boundingBox();
  const scrolled = await finger(page, [box.x + 15, box.y + 50], Array.from({ length: 12 }, (_, i) => [box.x + 15 + 4 * i, box.y + 50]));
  wants(`a finger looks round all of them, and the page stays: ${scrolled} px`, scrolled === 0 && (await shows(page)).every(({ turn }) => turn > first.turn + 15));
}
