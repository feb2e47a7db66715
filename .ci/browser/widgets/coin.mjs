// The coin: the plate, its cones, and how often each goes round.
import { read } from "../drawn.flat.mjs";
import { set, shown } from "./controls.mjs";
import { finger, frames } from "./hands.mjs";
import { cross, dot, near, size } from "./space.mjs";

const shows = (page) => page.locator("#live-coin canvas").evaluate((canvas) => canvas.shows);

export async function coin(page, wants) {
  for (const [body, along] of [["plate", 2], ["stick", 0.25]]) {
    await set(page, "#coin-body", body);
    for (const degrees of [1, 12, 35]) {
      await set(page, "#coin-tilt", degrees);
      const tilt = degrees * Math.PI / 180;
      const ratio = along / Math.cos(tilt); // the momentum's length is along it by the cosine
      wants("at rest it does not tell what the chapter asks", (await shown(page, "coin", "ratio")) === "?");
      const before = await shows(page);
      wants(`${body}, ${degrees}°: the axis stands so far off the momentum`, near(dot(before.axis, before.up), Math.cos(tilt), 1e-9));
      for (let i = 0; i < 7; i += 1) await page.click("#coin-play");
      wants(`${body}, ${degrees}°: ${await shown(page, "coin", "ratio")} wobbles in a turn, not ${ratio}`, near(read(await shown(page, "coin", "ratio")), ratio, 0.0051));
      const { axis, spin, up, fixed, rolling } = await shows(page);
      wants(`${body}, ${degrees}°: axis, spin and momentum lie in one plane`, Math.abs(dot(cross(axis, spin), up)) < 1e-9);
      wants(`${body}, ${degrees}°: both cones have the spin on them`, near(Math.cos(fixed), dot(up, spin), 1e-9) && near(Math.cos(rolling), dot(axis, spin), 1e-9));
      wants(`${body}, ${degrees}°: a plate's cone holds the other, a stick's stands beside it`, body === "plate" ? near(rolling - fixed, tilt, 1e-6) : near(rolling + fixed, tilt, 1e-6));
      // In 0.7 s the axis goes round the momentum by as many turns as are told.
      const off = (axis) => axis.map((x, k) => x - dot(axis, up) * up[k]);
      const [a, b] = [off(before.axis), off(axis)];
      const went = Math.atan2(dot(cross(a, b), up), dot(a, b)) / (2 * Math.PI);
      const told = ratio * 4 * 0.7 / (2 * Math.PI);
      wants(`${body}, ${degrees}°: it wobbled ${went} and not ${told} turns`, Math.abs(went - told - Math.round(went - told)) < 1e-6 && size(a) > 0);
      wants(`${body}, ${degrees}°: it says ${await shown(page, "coin", "wobbles")}`, near(read(await shown(page, "coin", "wobbles")), told, 0.051));
    }
  }
  await page.click("#coin-back");
  wants("back, nothing is counted", (await shown(page, "coin", "turns")) === "0.0");
  const canvas = page.locator("#live-coin canvas");
  await canvas.scrollIntoViewIfNeeded();
  const box = await canvas.boundingBox();
  const { turn } = await shows(page);
  const still = await finger(page, [box.x + 60, box.y + 90], Array.from({ length: 20 }, (_, i) => [box.x + 60 + 4 * i, box.y + 90]));
  wants(`a finger looks round, and the page stays: ${still} px`, still === 0 && (await shows(page)).turn > turn + 30);
}

export async function coinPlay(page, wants) {
  await page.click("#coin-play");
  await page.waitForFunction(() => document.querySelector("#live-coin [data-shows=turns]").textContent !== "0.0").catch(() => wants("played, it turns", false));
  await page.click("#coin-play");
  const stood = await shown(page, "coin", "turns");
  await frames(page, 12);
  wants("paused, it rests", (await shown(page, "coin", "turns")) === stood);
}
