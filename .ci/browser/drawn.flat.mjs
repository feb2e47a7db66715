// What the drawings of the widgets show, read back from the page, and set beside numbers worked out here.
import { frames } from "./widgets/hands.mjs";

/** A drawing's parts, by class: the numbers of their paths, and what else they have. */
const parts = (page, selector) => page.locator(selector).evaluate((svg) => {
  const attributes = ["d", "cx", "cy", "r", "x", "y", "width", "height", "text-anchor"];
  return {
    size: svg.getAttribute("viewBox").split(" ").slice(2).map(Number),
    dim: Number(getComputedStyle(svg).opacity) < 0.9,
    all: [...svg.querySelectorAll(":not(g)")].map((part) => ({
      kind: part.localName,
      classes: [...part.classList],
      colour: getComputedStyle(part).stroke,
      numbers: (part.getAttribute("d") ?? "").match(/-?\d+\.?\d*(e-?\d+)?/g)?.map(Number) ?? [],
      text: part.textContent,
      ...Object.fromEntries(attributes.map((name) => [name, name === "d" || name === "text-anchor" ? part.getAttribute(name) : Number(part.getAttribute(name))])),
    })),
  };
});
const withClasses = (drawing, ...names) => drawing.all.filter(({ classes }) => names.every((name) => classes.includes(name)));
const near = (a, b, most) => Math.abs(a - b) <= most;
const length = (v) => Math.hypot(...v);
const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
/** A number as a page shows it: 4 · 10⁻⁵, −1.5, 30°. */
export const read = (text) => {
  const plain = text.replaceAll("−", "-").replace(/ · 10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)/, (_, power) => `e${Array.from(power, (sign) => "-0123456789"["⁻⁰¹²³⁴⁵⁶⁷⁸⁹".indexOf(sign)]).join("")}`);
  return parseFloat(plain);
};
const numbers = (text) => text.split(", ").map(read);
/** Whether a text is this number, in three digits or three decimals. */
const as = (text, right) => near(read(text), right, right < 0.01 ? 0.0051 * right : Math.max(0.00051, 1e-6 * right));
const DEGREES = 180 / Math.PI;

/** The moments of a box of these edges. */
const moments = ([a, b, c], m) => [m * (b * b + c * c) / 12, m * (a * a + c * c) / 12, m * (a * a + b * b) / 12];

/** Both arrows, the gap between them, the axes' names: at several settings, so that a picture that stands still is found. */
export async function arrowsDrawn(page, set, shown, wants) {
  const pencil = [0.005 * (3 * 0.0035 ** 2 + 0.18 ** 2) / 12, 0.005 * (3 * 0.0035 ** 2 + 0.18 ** 2) / 12, 0.005 * 0.0035 ** 2 / 2];
  const box = moments([2, 1, 3], 1);
  const cases = [[1, box, [2, 1, 3], 1, 45], [1, box, [2, 1, 3], 2, 20], [0, moments([2, 1, 0], 1), [2, 1, 0], 0, 70], [4, pencil, [0.007, 0.007, 0.18], 0, 5], [4, pencil, [0.007, 0.007, 0.18], 2, 60]];
  for (const [body, all, size, between, angle] of cases) {
    await set(page, "#two-arrows-body", body);
    await set(page, "#two-arrows-between", between);
    await set(page, "#two-arrows-spin", angle);
    const says = (what, holds) => wants(`body ${body}, axes ${between}, ${angle}°: ${what}`, holds);
    const order = [0, 1, 2].sort((i, j) => all[i] - all[j]);
    const axes = [[0, 1], [1, 2], [0, 2]][between].map((i) => order[i]);
    const momentum = [all[axes[0]] * Math.cos(angle / DEGREES), all[axes[1]] * Math.sin(angle / DEGREES)];
    const to = Math.atan2(momentum[1], momentum[0]) * DEGREES;
    const displayed = (await Promise.all(["spin", "momentum", "gap"].map((what) => shown(page, "two-arrows", what)))).map(read);
    says(`the numbers are ${displayed}`, near(displayed[0], angle, 0.051) && near(displayed[1], to, 0.051) && near(displayed[2], to - angle, 0.051));

    const drawing = await parts(page, "#live-two-arrows svg");
    const [point] = withClasses(drawing, "live-point");
    const centre = [point.cx, point.cy];
    const polar = ([x, y]) => [Math.hypot(x - centre[0], centre[1] - y), Math.atan2(centre[1] - y, x - centre[0]) * DEGREES];
    const arrow = (name) => {
      const [shaft] = withClasses(drawing, "live-arrow", name);
      const [head] = withClasses(drawing, "live-head", name);
      says(`${name} begins in the middle`, near(shaft.numbers[0], centre[0], 0.01) && near(shaft.numbers[1], centre[1], 0.01));
      return polar(head.numbers);
    };
    const [omega, l] = [arrow("live-omega"), arrow("live-momentum")];
    says(`the spin's arrow stands at ${omega[1]}`, near(omega[1], angle, 0.1));
    says(`the momentum's arrow stands at ${l[1]}, not ${to}`, near(l[1], to, 0.1));
    const note = drawing.all.some(({ text }) => text.includes("drawn longer"));
    const scale = length(momentum) / all[axes[1]];
    says(`L is ${l[0] / omega[0]} of the spin's arrow, by the numbers ${scale}`, note ? scale < 0.5 && l[0] > 0.49 * omega[0] : near(l[0] / omega[0], scale, 0.01));
    const [arc] = withClasses(drawing, "live-gap");
    const [x, y, r, , , , , toX, toY] = arc.numbers;
    const [from, end] = [polar([x, y]), polar([toX, toY])];
    says(`the arc goes from ${from[1]} to ${end[1]}`, near(from[1], angle, 0.1) && near(end[1], to, 0.1) && near(from[0], r, 0.1));
    says(`the arc lies inside both arrows: ${r}, ${omega[0]}, ${l[0]}`, r < omega[0] && r < 0.95 * l[0]);
    const label = drawing.all.find(({ text }) => text === `${displayed[2].toFixed(1)}°`);
    says("the gap stands in the drawing", displayed[2] < 8 || label !== undefined);
    const [ring] = withClasses(drawing, "live-ring");
    says("a ring and a word show what can be dragged", near(polar([ring.cx, ring.cy])[0], omega[0], 0.1) &&
      near(polar([ring.cx, ring.cy])[1], angle, 0.1) && ring.colour !== "none" && drawing.all.some(({ text }) => text === "drag"));
    // Each axis by its name, and the moment below it.
    const names = drawing.all.filter(({ text }) => text.startsWith("axis "));
    const after = names.map((name) => drawing.all[drawing.all.indexOf(name) + 1].text);
    const [right, upper] = [names.find(({ x }) => x > 0.9 * drawing.size[0]), names.find(({ y }) => y < 0.15 * drawing.size[1])];
    says(`to the right is ${right?.text}, upwards ${upper?.text}`, right?.text === `axis ${"xyz"[axes[0]]}:` && upper?.text === `axis ${"xyz"[axes[1]]}:`);
    says(`their moments are ${after}`, [right, upper].every((name, i) => near(read(after[names.indexOf(name)]) / all[axes[i]], 1, 0.005)));
    const [shape] = withClasses(drawing, "live-body");
    const thin = 3.01; // no body is drawn thinner than this
    says(`the body is ${shape.width} by ${shape.height}`, shape.height < thin || near(shape.width / shape.height, size[axes[0]] / size[axes[1]], 0.01));
  }
  await set(page, "#two-arrows-body", 0);
  await set(page, "#two-arrows-between", 0);
}

/** The box, its axes, both arrows and all numbers: at several settings. */
export async function boxDrawn(page, set, shown, wants) {
  const fields = ["a", "b", "c", "m", "x", "y", "z"];
  const fill = async (values) => {
    for (let i = 0; i < fields.length; i += 1) await set(page, `#your-box-${fields[i]}`, values[i]);
  };
  const cases = [
    [[2, 1, 3, 1, 1, 1, 0], []], // where it moves the words come from the formula below
    [[1, 2, 0.5, 2, 0.2, -0.5, 1.5], []],
    [[2, 1, 3, 1, 0, 0.2, 3], []],
    [[2, 1, 3, 1, 1, 0, 0], ["stands on the axis x, of the middle moment", "flip"]],
    [[2, 1, 3, 1, 0, 1, 0], ["stays on the axis y, of the largest moment", "wobble"]],
    [[2, 1, 3, 1, 0, 0, -2], ["stays on the axis z, of the smallest moment", "wobble"]],
  ];
  for (const [values, on] of cases) {
    await fill(values);
    const says = (what, holds) => wants(`box ${values}: ${what}`, holds);
    const [edges, mass, spin] = [values.slice(0, 3), values[3], values.slice(4)];
    const inertia = moments(edges, mass);
    const momentum = inertia.map((moment, i) => moment * spin[i]);
    const gap = Math.acos(Math.min(1, dot(spin, momentum) / length(spin) / length(momentum))) * DEGREES;
    const displayed = Object.fromEntries(await Promise.all(["moments", "momentum", "gap", "circled"].map(async (what) => [what, await shown(page, "your-box", what)])));
    const same = (text, right) => numbers(text).length === 3 && numbers(text).every((x, i) => near(x, right[i], 0.00051));
    says(`moments ${displayed.moments}, momentum ${displayed.momentum}, gap ${displayed.gap}`,
      same(displayed.moments, inertia) && same(displayed.momentum, momentum) && near(read(displayed.gap), gap, 0.051));
    const order = [0, 1, 2].sort((i, j) => inertia[i] - inertia[j]);
    const moving = spin.filter((x) => x !== 0).length > 1;
    // Inside the separatrix, 2 E I2 > L², it goes round the axis of the smallest moment.
    const round = order[dot(spin, momentum) * inertia[order[1]] > dot(momentum, momentum) ? 0 : 2];
    const words = moving ? [`circles the axis ${"xyz"[round]}, of the ${round === order[0] ? "smallest" : "largest"} moment`, "for ever"] : on;
    for (const word of words) says(`"${displayed.circled}" says "${word}"`, displayed.circled.includes(word));
    if (!moving) says(`"${displayed.circled}" says one thing`, displayed.circled.includes("flip") !== displayed.circled.includes("wobble"));

    const drawing = await parts(page, "#live-your-box svg");
    const [width, height] = drawing.size;
    const centre = [width / 2, height / 2];
    const half = edges.map((edge) => edge / Math.max(...edges));
    // Where each of the body's axes leads in the picture, by the axes drawn, each with its name at its end.
    const names = drawing.all.filter(({ kind, text }) => kind === "text" && ["x", "y", "z"].includes(text));
    const lines = withClasses(drawing, "live-axis").map(({ numbers }) => numbers);
    says("three axes have names", names.length === 3 && lines.length === 3);
    const unit = ["x", "y", "z"].map((name) => {
      const at = names.find(({ text }) => text === name);
      const line = lines.find(([, , x, y]) => near(x, at.x, 1) && near(y, at.y, 8)) ?? lines[0];
      return [(line[2] - line[0]) / 0.28, (line[3] - line[1]) / 0.28];
    });
    unit.forEach((leads, i) => {
      const line = lines.find(([x, y]) => near(x, centre[0] + half[i] * leads[0], 0.5) && near(y, centre[1] + half[i] * leads[1], 0.5));
      says(`axis ${"xyz"[i]} begins at the box's face`, line !== undefined);
    });
    const place = (v) => [0, 1].map((k) => centre[k] + v.reduce((sum, x, i) => sum + x * unit[i][k], 0));
    // All of the box's eight corners, each with three edges.
    const ends = withClasses(drawing, "live-edge").flatMap(({ numbers: [a, b, c, d] }) => [[a, b], [c, d]]);
    says("the box has twelve edges", ends.length === 24);
    for (let bits = 0; bits < 8; bits += 1) {
      const [x, y] = place(half.map((far, i) => (bits >> i & 1 ? far : -far)));
      says(`corner ${bits} is where the edges say`, ends.filter(([a, b]) => near(a, x, 0.5) && near(b, y, 0.5)).length >= 3);
    }
    for (const [name, vector] of [["live-omega", spin], ["live-momentum", momentum]]) {
      const [head] = withClasses(drawing, "live-head", name);
      const [x, y] = place(vector.map((part) => 1.5 * part / length(vector)));
      says(`${name} ends at ${head?.numbers.slice(0, 2)}, by the numbers at ${[x, y]}`, head && near(head.numbers[0], x, 1) && near(head.numbers[1], y, 1));
    }
  }
  // What cannot be leaves the last drawing, dimmed, and one message.
  const before = await parts(page, "#live-your-box svg");
  await set(page, "#your-box-a", 0);
  await frames(page); // where less motion is wanted a style changes a moment later
  const after = await parts(page, "#live-your-box svg");
  wants(`a box that cannot be leaves the last drawing, dimmed: ${after.all.length} parts of ${before.all.length}`, JSON.stringify(before.all) === JSON.stringify(after.all) && after.dim && !before.dim);
  wants("and its numbers are not to be seen", !(await page.isVisible("#live-your-box dl")) && !/none/.test(await page.locator("#live-your-box .live-stage").innerText()));
  await fill([2, 1, 3, 1, 1, 1, 0]);
  await frames(page);
  wants("put right, all is there again", !(await parts(page, "#live-your-box svg")).dim && (await page.isVisible("#live-your-box dl")));
}

/** Euler's equations of the box 2, 1, 3 of one kilogram: by the classical rule in small steps, or by Euler's own rule. */
const BOX = moments([2, 1, 3], 1);
const rate = (w) => [0, 1, 2].map((i) => (BOX[(i + 1) % 3] - BOX[(i + 2) % 3]) / BOX[i] * w[(i + 1) % 3] * w[(i + 2) % 3]);
const ahead = (w, k, h) => w.map((x, i) => x + h * k[i]);
function exactSpins(start, count, each) {
  const h = 10 / count / each;
  let w = start;
  const all = [w];
  for (let i = 0; i < count; i += 1) {
    for (let j = 0; j < each; j += 1) {
      const a = rate(w);
      const b = rate(ahead(w, a, h / 2));
      const c = rate(ahead(w, b, h / 2));
      const d = rate(ahead(w, c, h));
      w = w.map((x, k) => x + h * (a[k] + 2 * b[k] + 2 * c[k] + d[k]) / 6);
    }
    all.push(w);
  }
  return all;
}
/** What Euler's rule is off by at most: energy and the length of the momentum. */
function eulerErrors(start, count) {
  const energy = (w) => w.reduce((sum, x, i) => sum + BOX[i] * x * x, 0);
  const size = (w) => length(w.map((x, i) => BOX[i] * x));
  let [w, most] = [start, [0, 0]];
  for (let i = 0; i < count; i += 1) {
    w = ahead(w, rate(w), 10 / count);
    most = [Math.max(most[0], Math.abs(energy(w) / energy(start) - 1)), Math.max(most[1], Math.abs(size(w) / size(start) - 1))];
  }
  return { energy: most[0], length: most[1] };
}

/** Both drawings and all numbers of a method, at several settings. */
export async function stepsDrawn(page, set, shown, wants, methods) {
  const SPINS = [[1, 1, 1], [10, 0.1, 0.1]];
  const COUNTS = { 2: 800, 4: 400, 6: 200, 16: 6 };
  const POWERS = { "explicit Euler": 1, "Runge-Kutta 4": 4, "implicit midpoint": 2 };
  await set(page, "#steps-body", 0);
  for (const [method, start, step] of [["explicit Euler", 0, 6], ["explicit Euler", 0, 2], ["Runge-Kutta 4", 0, 6], ["Runge-Kutta 4", 1, 2], ["implicit midpoint", 0, 4], ["explicit Euler", 1, 16]]) {
    const power = POWERS[method];
    wants(`there is ${method}`, methods.includes(method));
    await set(page, "#steps-method", methods.indexOf(method));
    await set(page, "#steps-start", start);
    await set(page, "#steps-step", step);
    const count = COUNTS[step];
    const h = 10 / count;
    const says = (what, holds) => wants(`${method}, start ${start}, ${count} steps: ${what}`, holds);
    const displayed = Object.fromEntries(await Promise.all(["step", "attitude", "better", "slope", "order", "energy", "length", "keeps"].map(async (what) => [what, await shown(page, "steps", what)])));
    says(`its step is shown as ${displayed.step}`, as(displayed.step, h) && displayed.step.endsWith(` ${count} steps`));
    says(`its order is ${displayed.order}`, displayed.order === `${power}${method === "implicit midpoint" ? ", implicit" : ""}`);
    const keeps = { "explicit Euler": /^nothing$/, "Runge-Kutta 4": /^nothing$/, "implicit midpoint": /^the energy, \|L\|/ }[method];
    says(`it keeps ${displayed.keeps}`, keeps.test(displayed.keeps));
    const long = step === 16;
    const right = method === "explicit Euler" ? eulerErrors(SPINS[start], count) : null;
    if (right && !long) {
      says(`energy is off by ${displayed.energy}, |L| by ${displayed.length}`, as(displayed.energy, right.energy) && as(displayed.length, right.length));
    }
    if (method === "implicit midpoint") says(`it keeps what it is said to: ${displayed.energy}, ${displayed.length}`, !(read(displayed.energy) > 1e-12) && !(read(displayed.length) > 1e-12));
    if (long) says(`its slope is ${displayed.slope}`, displayed.slope === "none: the step is too long" || displayed.slope === "none to see");
    else {
      says(`its slope is ${displayed.slope}`, near(read(displayed.slope), power, 0.25));
      says(`half the step is ${displayed.better}`, near(Math.log2(read(displayed.better)), read(displayed.slope), 0.25));
    }

    // The spin along the middle axis, recorded and exact, on one scale.
    const path = await parts(page, "#live-steps [data-drawing=path]");
    const [, high] = path.size;
    const curve = (name) => {
      const [line] = withClasses(path, name).filter(({ kind, numbers }) => kind === "path" && numbers.length > 12);
      return Array.from({ length: (line?.numbers.length ?? 0) / 2 }, (_, i) => [line.numbers[2 * i], high / 2 - line.numbers[2 * i + 1]]);
    };
    const [exact, ran] = [curve("live-exact"), withClasses(path, "live-ran").filter(({ kind, classes }) => kind === "path" && !classes.includes("live-cross"))[0]];
    const wanted = exactSpins(SPINS[start], exact.length - 1, 20).map(([x]) => x);
    const [most, tallest] = [wanted, exact.map(([, y]) => y)].map((all) => Math.max(...all.map(Math.abs)));
    const worst = Math.max(...wanted.map((x, i) => Math.abs(x / most - exact[i][1] / tallest)));
    says(`the exact curve is off by ${worst}`, exact.length > 100 && worst < 0.02);
    says("the exact curve goes on evenly", exact.every(([x], i) => near(x, exact[0][0] + i * (exact.at(-1)[0] - exact[0][0]) / (exact.length - 1), 0.1)));
    const scale = tallest / most;
    if (!long) {
      let w = SPINS[start];
      const at = method === "explicit Euler" ? Array.from({ length: count + 1 }, (_, i) => (i === 0 ? w : (w = ahead(w, rate(w), h)))) : exactSpins(w, count, 20);
      const off = Math.max(...at.map(([x], i) => Math.abs(x * scale - (high / 2 - ran.numbers[2 * i + 1])) / tallest));
      says(`what the method does is off by ${off}`, ran.numbers.length === 2 * (count + 1) && off < 0.03);
    }
    const key = await page.locator("#live-steps .live-key-exact + span").evaluate((span) => [span.textContent, getComputedStyle(span, "::before").borderBlockStartColor]);
    says(`the key calls it "${key}", drawn ${ran?.colour}`, key[1] === ran?.colour && key[0].includes("astray") === !(read(displayed.energy) < 0.1 && read(displayed.attitude) < 90));

    // The errors, by the names at the axes.
    const errors = await parts(page, "#live-steps [data-drawing=errors]");
    const texts = errors.all.filter(({ kind }) => kind === "text");
    const line = (points) => {
      const [[a, x], [b, y]] = [points[0], points.at(-1)];
      return (at) => x + (at - a) * (y - x) / (b - a);
    };
    const powers = texts.filter(({ text, "text-anchor": anchor }) => anchor === "end" && /^(1|10[⁻⁰-⁹¹²³]+)$/.test(text))
      .map(({ text, y }) => [y - 5, text === "1" ? 0 : Math.log10(read(`1 · ${text}`))]);
    const names = texts.filter(({ text }) => /^[\d.]+ s$/.test(text)).map(({ text, x }) => [x, Math.log10(parseFloat(text))]);
    says(`the axes have their names: ${powers.length}, ${names.length}`, powers.length >= 5 && names.length === 3);
    if (powers.length < 2 || names.length < 2) continue;
    const [error, stepAt] = [line(powers), line(names)];
    const now = withClasses(errors, "live-now")[0].numbers[0];
    says("the line of now stands at the step", near(stepAt(now), Math.log10(h), 0.01));
    const middle = { energy: ({ x, y, width: w, height: t }) => [x + w / 2, y + t / 2, w === 12], length: ({ numbers: n }) => [n[0] + n[2], n[1], near(n[2], 8.4, 0.01)], attitude: ({ cx, cy, r }) => [cx, cy, r === 6] };
    for (const kind of ["energy", "length", "attitude"]) {
      const marks = withClasses(errors, "live-mark", `live-curve-${kind}`).map(middle[kind]);
      const chosen = marks.find(([, , large]) => large);
      const clamp = (x) => Math.max(-16, Math.min(4, x > 0 ? Math.log10(x) : -16));
      const size = displayed[kind] === "nothing" ? 0 : read(displayed[kind]);
      // The attitude is shown to one digit.
      if (!long) says(`${kind} stands at ${chosen && error(chosen[1])}, shown as ${displayed[kind]}`, chosen && near(error(chosen[1]), clamp(size), kind === "attitude" ? 0.2 : 0.025) && near(stepAt(chosen[0]), Math.log10(h), 0.01));
      const [drawn] = withClasses(errors, "live-curve", `live-curve-${kind}`);
      const points = Array.from({ length: (drawn?.numbers.length ?? 0) / 2 }, (_, i) => [stepAt(drawn.numbers[2 * i]), error(drawn.numbers[2 * i + 1])]);
      says(`${kind} has its curve of ${points.length} points`, points.length >= 6);
      if (right && kind !== "attitude" && start === 0) {
        for (const [at, e] of points.filter(([at]) => at < -0.9)) {
          const by = clamp(eulerErrors(SPINS[start], Math.round(10 / 10 ** at))[kind]);
          says(`at a step of ${10 ** at} s ${kind} is drawn at ${e}, not ${by}`, near(e, by, 0.05));
        }
      }
      if (kind === "attitude" && start === 0) {
        // Where halving tells anything its slope is the order: no rounding, and far from a whole turn.
        const steep = points.slice(1).map(([at, e], i) => [(e - points[i][1]) / (at - points[i][0]), points[i][1], e]).filter(([, a, b]) => Math.min(a, b) > -10 && Math.max(a, b) < (power === 1 ? 1 : 0)); // higher orders show later
        says(`attitude rises by ${steep.map(([slope]) => slope)}`, (long || steep.length > 0) && steep.every(([slope]) => near(slope, power, 0.3)));
      }
    }
    const guide = withClasses(errors, "live-guide")[0]?.numbers;
    if (guide) {
      const [x1, y1, x2, y2] = [stepAt(guide[0]), error(guide[1]), stepAt(guide[2]), error(guide[3])];
      says(`the dotted line rises by ${(y2 - y1) / (x2 - x1)}`, near((y2 - y1) / (x2 - x1), power, 0.05));
      const [x, y] = withClasses(errors, "live-mark", "live-curve-attitude").map(middle.attitude).find(([, , large]) => large);
      says("and goes through the error", near(y1 + (stepAt(x) - x1) * (y2 - y1) / (x2 - x1), error(y), 0.05));
    } else says("there is a dotted line", long);
    const slope = texts.find(({ text }) => text.startsWith("slope "));
    says(`the drawing says ${slope?.text}`, long ? slope === undefined : slope?.text === `slope ${displayed.slope}`);
  }
}
