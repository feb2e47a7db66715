// Spin and momentum of a box, dragged.
import { arrowsDrawn } from "../drawn.flat.mjs";
import { said, set, shown } from "./controls.mjs";
import { finger } from "./hands.mjs";

export async function twoArrows(page, wants) {
  const spin = "#two-arrows-spin";
  const numbers = () => Promise.all(["spin", "momentum", "gap"].map((what) => shown(page, "two-arrows", what)));

  // The arrows do not answer the question above them, and part once it is answered.
  const before = (await numbers())[2];
  await page.locator(".question button").first().click();
  wants(`the gap is ${before} before the question is answered, then ${(await numbers())[2]}`, before === "0.0°" && (await numbers())[2] === "31.0°");

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
  wants("a screen reader gets the answer", /gap/.test(await page.getAttribute(spin, "aria-valuetext")));
  wants(...await said(page, "two-arrows", /Gap 0\.0°/));

  // Let go, the momentum's arrow stands where it stood; the spin, worked out from what is drawn, has the same product with it.
  await set(page, spin, 40);
  const arrow = (name) => page.locator(`#live-two-arrows .live-head.${name}`).getAttribute("d");
  const [stood, ahead] = [await arrow("live-momentum"), await arrow("live-omega")];
  for (let i = 0; i < 3; i += 1) await page.click("#two-arrows-play");
  const free = await page.locator("#live-two-arrows svg").evaluate((svg) => svg.shows);
  const [easy, hard] = [Math.cos(40 * Math.PI / 180), Math.sin(40 * Math.PI / 180)]; // the plate's moments are as 1 to 4
  wants("let go, the momentum stays and the spin moves", (await arrow("live-momentum")) === stood && (await arrow("live-omega")) !== ahead);
  wants(`the energy stays: ${free.spin}`, Math.abs(free.spin[0] * easy + free.spin[1] * 4 * hard - easy * easy - 4 * hard * hard) < 1e-9);
  await page.click("#two-arrows-back");
  wants("back, it stands as before", (await arrow("live-omega")) === ahead);
  // On an axis nothing would be seen to happen: it says so.
  await set(page, spin, 0);
  await page.click("#two-arrows-play");
  await page.click("#two-arrows-play");
  wants("let go on an axis, it says that both arrows stay", /both arrows stay/.test(await page.locator("#live-two-arrows svg").textContent()));
  await page.click("#two-arrows-back");

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
  await page.locator("#live-two-arrows").evaluate((box) => box.scrollIntoView()); // above it a finger makes controls larger

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
