// Body and world, and Euler's equations.
import { read } from "../drawn.flat.mjs";
import { atTime, said, set, shown, turnsAndPlays } from "./controls.mjs";

export async function turning(page, wants) {
  const entries = () => page.locator("#live-turning [data-at]").allTextContents();
  const text = (await page.textContent("main")).replace(/\s+/g, " ");
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

export async function trading(page, wants) {
  const text = (await page.textContent("main")).replace(/\s+/g, " ");
  const [, after] = text.match(/look again after ([\d.]+) s/);
  await set(page, "#trading-scrub", after);
  const spin = () => shown(page, "trading", "spin");
  wants(`after ${after} s the spin is the chapter's: ${await spin()}`, (await spin()) === "0.00, 1.22, −0.87");
  wants(...await said(page, "trading", /of the energy, 0 % belongs to the spin about x/));
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
