// A box of the reader's own.
import { boxDrawn } from "../drawn.flat.mjs";
import { set, shown } from "./controls.mjs";
import { finger } from "./hands.mjs";

export async function yourBox(page, wants) {
  const wrong = "#live-your-box .live-wrong";
  wants("it begins with the chapter's box", (await shown(page, "your-box", "moments")) === "0.833, 1.083, 0.417");
  wants("it begins with another spin than that of the question above it", (await shown(page, "your-box", "momentum")) === "0.833, 0, 0.417" && (await shown(page, "your-box", "gap")) === "18.4°");
  await set(page, "#your-box-z", 0);
  wants("along an edge the gap is none", (await shown(page, "your-box", "gap")) === "0.0°");
  await set(page, "#your-box-y", 1);
  wants("its momentum is the chapter's", (await shown(page, "your-box", "momentum")) === "0.833, 1.083, 0");
  wants("its gap is the chapter's", (await shown(page, "your-box", "gap")) === "7.4°");
  await boxDrawn(page, set, shown, wants);
  for (const [field, value, says] of [
    ["a", "0", "above zero"], ["b", "-1", "above zero"], ["c", "", "Type a number"], ["m", "0", "above zero"], ["a", "1e200", "floating-point"],
    ["m", "1e-320", "floating-point"], ["x", "", "Type a number"],
  ]) {
    const before = await page.locator(`#your-box-${field}`).inputValue();
    await set(page, `#your-box-${field}`, value);
    const text = (await page.isVisible(wrong)) ? await page.textContent(wrong) : "nothing";
    wants(`${field} = "${value}" is called wrong, by "${says}", not by "${text}"`, text.includes(says));
    await set(page, `#your-box-${field}`, before);
    wants("put right, it is right again", !(await page.isVisible(wrong)));
  }
  for (const value of ["1e-3", "50", "1e9"]) {
    await set(page, "#your-box-c", value);
    const broken = await page.locator("#live-your-box svg").evaluate((svg) => /NaN|Infinity|undefined/.test(svg.outerHTML));
    wants(`with an edge of ${value} m every part of the drawing has a place`, !broken);
  }
  await set(page, "#your-box-c", 3);
  await page.locator("#your-box-a").focus();
  const address = page.url();
  await page.keyboard.press("ArrowUp");
  await page.keyboard.press("ArrowLeft");
  wants("arrow keys change a number and turn no page", (await page.inputValue("#your-box-a")) === "2.1" && page.url() === address);
  await set(page, "#your-box-a", 2);

  // Let go, the momentum stands in the room, and the spin moves; the energy, half of their product, is kept.
  const motion = () => page.locator("#live-your-box svg").evaluate((svg) => svg.shows);
  const held = await motion();
  for (let i = 0; i < 5; i += 1) await page.click("#your-box-play");
  const free = await motion();
  wants(`let go for 1.5 s: ${free.time}`, Math.abs(free.time - 1.5) < 1e-9 && String(free.momentum) === String(held.momentum));
  const product = ({ spin, momentum }) => spin.reduce((sum, x, i) => sum + x * momentum[i], 0);
  wants(`the spin moves and keeps the energy: ${free.spin}`, free.spin.some((x, i) => Math.abs(x - held.spin[i]) > 0.05) && Math.abs(product(free) / product(held) - 1) < 1e-12);
  wants("let go, nothing is dragged by its tip", (await page.locator("#live-your-box .live-handle").count()) === 0);
  await page.click("#your-box-back");
  wants("back, it is as it was", String((await motion()).spin) === String(held.spin) && (await shown(page, "your-box", "gap")) === "7.4°");

  // The spin's tip follows a finger, its size stays, and onto an axis the gap closes without a leap.
  const values = () => Promise.all(["x", "y", "z"].map(async (axis) => Number(await page.inputValue(`#your-box-${axis}`))));
  const gap = async () => parseFloat(await shown(page, "your-box", "gap"));
  for (const [axis, value] of [["x", 1], ["y", 1], ["z", 0]]) await set(page, `#your-box-${axis}`, value);
  const drawing = page.locator("#live-your-box svg");
  await drawing.scrollIntoViewIfNeeded();
  const middle = async (selector) => {
    const box = await drawing.locator(selector).boundingBox();
    return [box.x + box.width / 2, box.y + box.height / 2];
  };
  const frame = await drawing.boundingBox();
  const centre = [frame.x + frame.width / 2, frame.y + frame.height / 2];
  const x = await drawing.locator("text", { hasText: /^x$/ }).evaluate((text) => [Number(text.getAttribute("x")), Number(text.getAttribute("y")) - 5]);
  const far = Math.hypot(x[0] - frame.width / 2, x[1] - frame.height / 2);
  const leads = [(x[0] - frame.width / 2) / far, (x[1] - frame.height / 2) / far];
  const begin = await middle(".live-handle");
  const gaps = [];
  for (let part = 0.1; part < 1.01; part += 0.1) {
    const tip = await middle(".live-handle");
    const to = [0, 1].map((k) => begin[k] + part * (centre[k] + 0.97 * far * leads[k] - begin[k]));
    const scrolled = await finger(page, tip, [to]);
    wants(`under a finger the page does not scroll: ${scrolled} px`, scrolled === 0);
    wants(`the size of the spin stays: ${await values()}`, Math.abs(Math.hypot(...await values()) - Math.SQRT2) < 0.01);
    gaps.push(await gap());
  }
  wants(`dragged from between the axes the gap closes without a leap: ${gaps}`, gaps[0] > 5 && gaps.every((gap, i) => i === 0 || Math.abs(gap - gaps[i - 1]) < 4));
  const before = await drawing.evaluate((svg) => svg.innerHTML);
  await finger(page, [frame.x + 15, frame.y + 15], [[frame.x + 60, frame.y + 40]]);
  wants("dragged elsewhere the box turns", (await drawing.evaluate((svg) => svg.innerHTML)) !== before);
}
