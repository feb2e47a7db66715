// Frames, fingers and canvases under the check's own hand.

/** Has every canvas of a widget keep what is drawn on it since it was last cleared, in the page's pixels. */
export const watch = (page, widget) => page.locator(`#live-${widget} canvas`).evaluateAll((all) => all.forEach((canvas) => {
  const pen = canvas.getContext("2d");
  let path = [];
  canvas.drawn = [];
  const around = (name, note) => {
    const own = pen[name];
    pen[name] = (...words) => {
      note(...words);
      return own.apply(pen, words);
    };
  };
  around("clearRect", () => { canvas.drawn = []; });
  around("beginPath", () => { path = []; });
  for (const name of ["moveTo", "lineTo", "arc"]) around(name, (x, y) => path.push([x, y, name]));
  around("stroke", () => canvas.drawn.push({ kind: "stroke", colour: pen.strokeStyle, wide: pen.lineWidth, dashed: pen.getLineDash().length > 0, path }));
  around("fill", () => canvas.drawn.push({ kind: "fill", colour: pen.fillStyle, path }));
  around("fillText", (text, x, y) => canvas.drawn.push({ kind: "text", text, path: [[x, y]] }));
}));

/** Frames that come when `step` is called, at the instants that it is given, ms; `end` puts the browser's own back. */
export const byHand = (page) => page.evaluate(() => {
  const own = [window.requestAnimationFrame, window.cancelAnimationFrame];
  const waiting = new Map();
  let last = 0;
  window.requestAnimationFrame = (frame) => {
    waiting.set(last += 1, frame);
    return last;
  };
  window.cancelAnimationFrame = (id) => waiting.delete(id);
  window.byHand = {
    waiting,
    step(at) {
      for (const [id, frame] of [...waiting]) if (waiting.delete(id)) frame(at);
    },
    end() { [window.requestAnimationFrame, window.cancelAnimationFrame] = own; },
  };
});

/** Waits until the page has drawn so many frames: what was asked for in the first is on the screen after the second. */
export const frames = (page, count = 2) => page.evaluate((count) => new Promise((done) => {
  const next = (left) => (left === 0 ? done() : requestAnimationFrame(() => next(left - 1)));
  next(count);
}), count);

/**
 * The finger goes from one place to others, as a phone reports it; returns how far the page has scrolled meanwhile. With `every` the moves
 * bear instants that many ms apart, however slow the machine is.
 */
export async function finger(page, from, others, every) {
  const client = await page.context().newCDPSession(page);
  const begun = Date.now() / 1000 - 1;
  let count = 0;
  // For a finger controls are larger, and what it takes hold of may stand elsewhere then.
  const taken = await page.evaluateHandle(([x, y]) => document.elementFromPoint(x, y).closest("svg, canvas, input, main"), from);
  const place = () => taken.evaluate((e) => [e.getBoundingClientRect().x, e.getBoundingClientRect().y]);
  const [was, moved] = [await place(), [0, 0]];
  const touch = (type, points) => client.send("Input.dispatchTouchEvent", {
    type, touchPoints: points.map(([x, y]) => ({ x: x + moved[0], y: y + moved[1] })), ...(every && { timestamp: begun + (count++ * every) / 1000 }),
  });
  const scrolled = () => page.evaluate(() => scrollY);
  await client.send("Emulation.setTouchEmulationEnabled", { enabled: true });
  await frames(page);
  (await place()).forEach((now, i) => { moved[i] = now - was[i]; });
  const before = await scrolled();
  await touch("touchStart", [from]);
  for (const place of others) await touch("touchMove", [place]);
  await touch("touchEnd", []);
  const after = await scrolled();
  await client.send("Emulation.setTouchEmulationEnabled", { enabled: false });
  await client.detach();
  return after - before;
}

/** A number of frames of the same number of ms each, from now on; the first begins them. */
export const pass = (page, frames, each) => page.evaluate(([frames, each]) => {
  const from = performance.now();
  for (let i = 0; i <= frames; i += 1) window.byHand.step(from + i * each);
}, [frames, each]);

export const waiting = (page) => page.evaluate(() => window.byHand.waiting.size);

/** A thumb that goes up over a drawing scrolls the page past it, unless it takes hold of something in it. */
export async function thumbs(page, widget, wants) {
  const drawings = page.locator(`#live-${widget} :is(svg, canvas):visible`);
  for (let i = 0; i < await drawings.count(); i += 1) {
    await drawings.nth(i).evaluate((drawing) => scrollBy(0, drawing.getBoundingClientRect().top - innerHeight / 2));
    const box = await drawings.nth(i).boundingBox();
    const at = [box.x + 0.04 * box.width, box.y + 0.6 * box.height];
    const past = await finger(page, at, Array.from({ length: 15 }, (_, k) => [at[0], at[1] - 12 * k]));
    wants(`a thumb over drawing ${i + 1} scrolls the page past it: ${past} px`, past > 60);
  }
}
