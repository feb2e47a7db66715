// A body of the reader's own.
import { readFile } from "node:fs/promises";
import { set, shown } from "./controls.mjs";
import { finger } from "./hands.mjs";

/** A phone, a satellite and a robot's link: their numbers, their drawings, and the address that keeps them. */
export async function yourBody(page, wants) {
  const tell = (what) => shown(page, "your-body", what);
  const wrong = "#live-your-body .live-wrong";
  const fill = async (values) => { for (const [field, value] of Object.entries(values)) await set(page, `#your-body-${field}`, value); };
  const choose = (kind) => page.selectOption("#your-body-kind", kind);
  await fill({ a: 2000, b: 1000, c: 3000, m: 1000 }); // mm, g
  for (const [k, moment, along] of [[1, 5 / 12, "0.000, 0.000, 1.000"], [2, 10 / 12, "1.000, 0.000, 0.000"], [3, 13 / 12, "0.000, 1.000, 0.000"]]) {
    const text = await tell(`axis-${k}`);
    wants(`the box's moment ${k} and its axis: ${text}`, Math.abs(parseFloat(text) - moment) < 1e-3 && text.includes(along));
  }
  const rate = Math.sqrt((3 * 5) / (13 * 5));
  const growth = await tell("growth");
  const tenfold = (Math.log(10) / (2 * Math.PI * rate)).toPrecision(3);
  wants(`a push on the box grows tenfold in ${tenfold} turns: ${growth}`, growth.includes(`ten times in ${tenfold} turns`));
  const flips = await page.locator(".your-body-flips td").allTextContents();
  const steps = flips.slice(1).map((text, k) => Number(text) - Number(flips[k]));
  const step = Math.log(100) / rate / 2 / Math.PI;
  wants(`each push ten times smaller waits ${step} turns longer: ${flips}`, flips.length === 9 && steps.slice(2).every((x) => Math.abs(x - step) < 0.08));
  const ratio = 13 / 5;
  const gap = (Math.atan((ratio - 1) / 2 / Math.sqrt(ratio)) * 180) / Math.PI;
  wants(`the widest gap is ${gap}: ${await tell("gap")}`, Math.abs(parseFloat(await tell("gap")) - gap) < 0.06);
  await page.waitForFunction(() => location.hash.startsWith("#your-body?kind=box&m=1&a=2&b=1&c=3"), null, { timeout: 60000 }).catch(() => {});
  wants(`the address keeps the box: ${page.url()}`, page.url().endsWith("#your-body?kind=box&m=1&a=2&b=1&c=3"));

  await typing(page, wants, { tell, fill, choose, wrong });
  await fill({ a: 2000, b: 1000, c: 3000, m: 1000 });

  // It tumbles: in the turned axes the momentum stands in the room, the energy is kept, and the flips are those that the table foretells.
  const motion = () => page.locator("#live-your-body [data-drawing=body]").evaluate((svg) => svg.shows);
  const moments = [5 / 12, 10 / 12, 13 / 12];
  const momentum = ({ axes, spin }) => [0, 1, 2].map((i) => axes.reduce((sum, axis, k) => sum + moments[k] * spin[k] * axis[i], 0));
  const held = momentum(await motion());
  for (let i = 0; i < 15; i += 1) await page.click("#your-body-play");
  const free = await motion();
  wants(`tumbled for 6 s the momentum stands at ${momentum(free)}`, Math.abs(free.t - 6) < 1e-9 && free.axes.some((axis, k) => Math.abs(axis[k]) < 0.9)
    && momentum(free).every((x, i) => Math.abs(x - held[i]) < 1e-9));
  wants(`flips after 6 s: ${await tell("tumbles")}`, (await tell("tumbles")).endsWith(`flips: ${Math.floor(6 / Number(flips[1]) + 0.5)}`));
  await page.click("#your-body-back");
  wants("back, it lies as before", (await motion()).t === 0 && (await tell("tumbles")) === "");

  // All paths lie inside the outline of their ellipsoid.
  const inside = await page.locator("#live-your-body [data-drawing=polhodes]").evaluate((svg) => {
    const box = (path) => path.getBBox();
    const whole = box(svg.querySelector(".live-body"));
    const paths = [...svg.querySelectorAll(".your-body-path")].map(box);
    return [paths.length, paths.every((b) => b.x >= whole.x - 1 && b.y >= whole.y - 1 && b.x + b.width <= whole.x + whole.width + 1 && b.y + b.height <= whole.y + whole.height + 1)];
  });
  wants(`${inside[0]} paths lie on the ellipsoid`, inside[0] >= 18 && inside[1]);

  for (const [kind, never] of [["ball", "any spin stays"], ["cylinder", "equal"], ["disk", "equal"]]) {
    await choose(kind);
    await fill({ a: 100, b: 20 });
    wants(`a ${kind}: ${await tell("growth")}`, (await tell("growth")).includes(never) && !(await page.isVisible(".your-body-flips")));
  }
  await choose("moments");
  for (const [values, says] of [[{ xx: 1, yy: 2, zz: 4 }, "no body"], [{ zz: "" }, "Type a number for zz"], [{ xx: 1, yy: 2, zz: 2.5 }, null]]) {
    await fill(values);
    const text = (await page.isVisible(wrong)) ? await page.textContent(wrong) : null;
    wants(`moments ${Object.values(values)}: ${text}`, says === null ? text === null : text?.includes(says));
  }
  await page.locator("#live-your-body details:not(#your-body-many) summary").click();
  const link = '<link name="arm"><inertial><origin xyz="0 0 1" rpy="0 0 1.5707963267948966"/><mass value="2"/><inertia ixx="1" iyy="2" izz="2.5" ixy="0.1" ixz="0" iyz="0"/></inertial></link>';
  await page.fill("#your-body-urdf", link);
  const taken = await Promise.all(["xx", "yy", "zz", "xy", "m"].map(async (field) => Number(await page.inputValue(`#your-body-${field}`))));
  wants(`a link is turned into its own axes: ${taken}`, [2, 1, 2.5, -0.1, 2000].every((x, k) => Math.abs(taken[k] - x) < 1e-9));
  await page.fill("#your-body-urdf", "<link><inertial><mass value='2'/></inertial></link>");
  wants(`half a link is refused: ${await tell("urdf")}`, (await tell("urdf")).includes("missing"));
  await page.locator("#live-your-body details:not(#your-body-many) summary").click();

  await ofParts(page, wants, { tell, fill, choose });

  // Another's link is taken over, and by finger and keyboard the view goes round.
  await page.evaluate(() => { location.hash = "#your-body?kind=ellipsoid&m=1e12&a=620&b=500&c=384"; });
  await page.waitForFunction(() => document.querySelector("#your-body-kind").value === "ellipsoid", null, { timeout: 60000 }).catch(() => {});
  wants(`a link in the address is taken over: ${await tell("axis-1")}`, (await tell("axis-1")).includes("10¹⁶"));
  const svg = page.locator("#live-your-body [data-drawing=body]");
  await svg.scrollIntoViewIfNeeded();
  const before = await svg.innerHTML();
  const box = await svg.boundingBox();
  const centre = [box.x + box.width / 2, box.y + box.height / 2];
  const scrolled = await finger(page, centre, [[centre[0] + 40, centre[1] + 15]]);
  wants(`under a finger the body turns and the page does not scroll: ${scrolled} px`, scrolled === 0 && (await svg.innerHTML()) !== before);
  const turned = await svg.innerHTML();
  await page.locator("#your-body-turn").focus();
  await page.keyboard.press("ArrowRight");
  wants("by keyboard too", (await svg.innerHTML()) !== turned);
  wants("every part of the drawings has a place", !/NaN|Infinity|undefined/.test(await page.locator("#live-your-body .live-stage").innerHTML()));
}

/** Numbers with comma, point and unit, and what is none; a mass that no solid has; a tube in place of a box, and the box again; the sheet. */
async function typing(page, wants, { tell, fill, choose, wrong }) {
  const middle = async () => parseFloat(await tell("axis-2"));
  await fill({ a: 77, b: 12.5, c: 160, m: 200 });
  const plain = await middle();
  for (const values of [{ b: "12,5" }, { b: "1.25 cm" }, { m: "0,2 kg", c: "16cm" }]) {
    await fill(values);
    wants(`${Object.values(values)} is read with comma and unit: ${await middle()}, not ${plain}`, (await middle()) === plain && !(await page.isVisible(wrong)));
  }
  for (const [text, says] of [["1,125", "It may be 1125 or 1.125"], ["5 in", "not read as a number for the side along y"], ["5 kg", "mm, cm or m"], ["", "Type a number for the side along y"]]) {
    await fill({ b: text });
    wants(`“${text}” is refused: ${await page.textContent(wrong)}`, (await page.isVisible(wrong)) && (await page.textContent(wrong)).includes(says));
  }
  for (const [m, says] of [["0.2", "so light. Is the mass in kg?"], ["200 kg", "so heavy. Is the mass in g?"], ["200", ""]]) {
    await fill({ b: 7.8, m });
    const asks = await tell("asks");
    wants(`a phone of ${m}: ${asks}`, says === "" ? asks === "" : asks.includes(says));
  }
  const hardest = (200e-3 * (77e-3 ** 2 + 160e-3 ** 2)) / 12 / 1e-4;
  wants(`a phone's moments are in the unit of its sheet: ${await tell("axis-3")}`, (await tell("axis-3")).startsWith(`${hardest.toFixed(3)} kg cm²`));
  await choose("tube");
  const sizes = () => Promise.all(["a", "b", "c"].map(async (name) => Number(await page.inputValue(`#your-body-${name}`))));
  wants(`a tube as large as the box, its hole smaller than itself: ${await sizes()}`, (await sizes())[0] < (await sizes())[1] && (await sizes())[2] === 160 && !(await page.isVisible(wrong)));
  const round = await page.locator("#live-your-body [data-drawing=body] .your-body-face").count();
  wants(`a tube is drawn as a tube, of ${round} faces`, round > 24);
  await choose("box");
  wants(`the box is as before: ${await sizes()}`, (await sizes()).join() === "77,7.8,160");
  await fill({ name: "Handy <3>" });
  await page.emulateMedia({ media: "print" });
  const sheet = await page.evaluate(() => document.querySelector("main").innerText);
  const controls = await page.locator("main :is(button, input, select, summary, textarea, code):visible").count();
  const sheets = (await page.pdf({ format: "A4", margin: { top: "10mm", bottom: "10mm", left: "10mm", right: "10mm" } })).toString("latin1").match(/\/Type \/Page\b/g).length;
  await page.emulateMedia({ media: "screen" });
  wants(`the sheet is one sheet of paper: ${sheets}`, sheets === 1);
  wants(`the sheet has title, sizes and mass, and ${controls} controls: ${sheet.slice(0, 300)}`, controls === 0 && sheet.includes("How Handy <3> turns") && sheet.includes("box, 200 g, 77 × 7.8 × 160 mm"));
  await fill({ name: "your body" });
}

/** Two boxes, the second added by keyboard: moments as the parallel-axis theorem has them, the address, the file, and a part removed. */
async function ofParts(page, wants, { tell, fill, choose }) {
  const boxes = [{ m: 2, sides: [0.1, 0.2, 0.4], at: [0, 0, 0] }, { m: 3, sides: [0.3, 0.1, 0.2], at: [0.5, 0, -0.05] }]; // kg, m
  const mm = (names, lengths) => Object.fromEntries(lengths.map((x, k) => [names[k], 1000 * x]));
  const items = page.locator("#live-your-body .your-body-parts li");
  await choose("box");
  await page.locator("#your-body-many summary").click();
  for (const { m, sides, at } of boxes) {
    await fill({ m: 1000 * m, ...mm("abc", sides), ...mm("xyz", at) });
    await page.locator("#your-body-add").focus();
    await page.keyboard.press("Enter");
  }
  wants(`two parts are listed: ${await items.allTextContents()}; ${await tell("added")}`, (await items.count()) === 2 && (await tell("added")) === "Part 2 is added."
    && (await items.nth(1).textContent()).includes("3000 g, 300 × 100 × 200 mm, at (500, 0, −50) mm"));
  // The boxes lie in the plane y = 0: across it stands one axis, and the other two turn by half the angle of the product.
  const whole = boxes.reduce((sum, { m }) => sum + m, 0);
  const centre = [0, 1, 2].map((i) => boxes.reduce((sum, { m, at }) => sum + m * at[i], 0) / whole);
  const about = (i, j) => boxes.reduce((sum, { m, sides, at }) => sum + m * ((i === j ? sides[i] ** 2 / 12 : 0) + (at[i] - centre[i]) * (at[j] - centre[j])), 0);
  const [xx, yy, zz, xz] = [about(1, 1) + about(2, 2), about(0, 0) + about(2, 2), about(0, 0) + about(1, 1), -about(0, 2)];
  const root = Math.hypot((xx - zz) / 2, xz);
  const moments = [(xx + zz) / 2 - root, (xx + zz) / 2 + root, yy].sort((a, b) => a - b);
  const told = await Promise.all([1, 2, 3].map(async (k) => parseFloat(await tell(`axis-${k}`))));
  wants(`the moments of two boxes are ${moments}: ${told}`, moments.every((x, k) => Math.abs(told[k] / x - 1) < 6e-4));
  // A box shows three of its faces.
  wants("both parts are drawn", (await page.locator("#live-your-body [data-drawing=body] .your-body-face").count()) === 6);
  const coming = page.waitForEvent("download", { timeout: 60000 });
  await page.click("#live-your-body [data-save=file]");
  const text = await readFile(await (await coming).path(), "utf8");
  const tables = boxes.map(({ m, sides, at }) => `\n[[part]]\nshape = "box"\nsides = [${sides.join(", ")}] # m\nmass = ${m} # kg\nat = [${at.join(", ")}] # m\n`);
  wants(`the file has both parts: ${text}`, text === `name = "your body"\n${tables.join("")}`);

  // A figure for slides has its size, its ground, and colours that are read outside of browsers too.
  const drawn = page.waitForEvent("download", { predicate: (saved) => saved.suggestedFilename() === "your-body-body.svg", timeout: 60000 });
  await page.click("#live-your-body [data-save=figures]");
  const figure = await readFile(await (await drawn).path(), "utf8");
  wants(`the figure is drawn plainly: ${figure.slice(0, 300)}`, / width="\d+" height="\d+"/.test(figure) && figure.includes('><rect width="') && !/color\(|var\(/.test(figure));

  // What is no part is refused in the library's words, and the list stays.
  await fill({ a: -1 });
  await page.click("#your-body-add");
  wants(`no part has a side below zero: ${await tell("added")}`, (await tell("added")).includes("must be above zero") && (await items.count()) === 2);
  await fill({ a: 300 });
  const kept = "part=box_2_0.1_0.2_0.4_0_0_0&part=box_3_0.3_0.1_0.2_0.5_0_-0.05";
  await page.waitForFunction((kept) => location.hash.endsWith(kept), kept, { timeout: 60000 }).catch(() => {});
  wants(`the address keeps the parts: ${page.url()}`, page.url().endsWith(kept));
  await page.locator("#live-your-body .your-body-parts button").first().focus();
  await page.keyboard.press("Enter");
  const alone = parseFloat(await tell("axis-3"));
  wants(`the second box alone: ${alone}`, Math.abs(alone / (3 * (0.3 ** 2 + 0.2 ** 2) / 12) - 1) < 6e-4 && (await page.evaluate(() => document.activeElement.getAttribute("aria-label"))).startsWith("Remove part 1"));
  await page.evaluate((kept) => { location.hash = `#your-body?kind=box&m=1&a=1&b=1&c=1&${kept}`; }, kept);
  await page.waitForFunction(() => document.querySelectorAll("#live-your-body .your-body-parts li").length === 2, null, { timeout: 60000 }).catch(() => {});
  wants(`a link brings both: ${await tell("axis-3")}`, Math.abs(parseFloat(await tell("axis-3")) / moments[2] - 1) < 6e-4);

  // A cone turned by 90° about x lies along −y, so its middle is a quarter of its height that way from the place of its base.
  await page.evaluate(() => { location.hash = "#your-body?kind=cone&m=3&a=0.1&b=0.4&part=box_2_0.1_0.2_0.4_0_0.2_0"; });
  await page.waitForFunction(() => document.querySelectorAll("#live-your-body .your-body-parts li").length === 1, null, { timeout: 60000 }).catch(() => {});
  await fill({ x: 300, y: 0, z: 0, degrees: 90 });
  await page.selectOption("#your-body-axis", "0");
  await page.click("#your-body-add");
  const cone = [(3 / 80) * 3 * (4 * 0.1 ** 2 + 0.4 ** 2), 0.3 * 3 * 0.1 ** 2];
  const [shared, dx, dy] = [(2 * 3) / 5, 0.3, -0.1 - 0.2];
  const [ix, iy, iz] = [(2 * 0.2) / 12 + cone[0] + shared * dy * dy, (2 * 0.17) / 12 + cone[1] + shared * dx * dx, (2 * 0.05) / 12 + cone[0] + shared * (dx * dx + dy * dy)];
  const turned = [(ix + iy) / 2 - Math.hypot((ix - iy) / 2, shared * dx * dy), (ix + iy) / 2 + Math.hypot((ix - iy) / 2, shared * dx * dy), iz].sort((a, b) => a - b);
  const own = await Promise.all([1, 2, 3].map(async (k) => parseFloat(await tell(`axis-${k}`))));
  wants(`a box and a turned cone have ${turned}: ${own}; ${await items.allTextContents()}`, turned.every((x, k) => Math.abs(own[k] / x - 1) < 6e-4) && (await items.nth(1).textContent()).includes("turned by 90° about x"));
  await page.waitForFunction(() => location.hash.endsWith("_0_90"), null, { timeout: 60000 }).catch(() => {});
  wants(`the address keeps the turn: ${page.url()}`, page.url().endsWith("part=cone_3_0.1_0.4_0.3_0_0_0_90"));
  const again = page.waitForEvent("download", { timeout: 60000 });
  await page.click("#live-your-body [data-save=file]");
  const turns = await readFile(await (await again).path(), "utf8");
  wants(`the file has the turn: ${turns}`, turns.includes("turn = [1, 0, 0, 90] # about x\nat = [0.3, 0, 0] # m"));
}
