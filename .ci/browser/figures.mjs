// Figures on a phone and opened large: all of a drawing can be brought into view.

/** Whose letters no scrolling brings into view. Bounds come from every box around that cuts off what sticks out of it. */
function outOfReach() {
  const found = [];
  /** The part of the page in which something may be seen, by the boxes around it. */
  const around = (element) => {
    let [left, right] = [0, document.documentElement.clientWidth];
    for (let box = element.parentElement; box; box = box.parentElement) {
      if (getComputedStyle(box).overflowX === "visible") continue;
      const { left: at } = box.getBoundingClientRect();
      left = Math.max(left, at + box.clientLeft);
      right = Math.min(right, at + box.clientLeft + box.clientWidth);
    }
    return [left, right];
  };
  for (const frame of document.querySelectorAll("main .fig-frame")) {
    const name = frame.closest(".fig").id;
    const [left, right] = around(frame);
    const box = frame.getBoundingClientRect();
    if (box.width === 0) continue;
    if (box.left < left - 1 || box.right > right + 1) {
      found.push(`${name}: its frame from ${box.left} to ${box.right} is seen from ${left} to ${right} only`);
    }
    // Where all its own room is, scrolled to either end.
    const [from, to] = [box.left + frame.clientLeft - frame.scrollLeft, box.left + frame.clientLeft - frame.scrollLeft + frame.scrollWidth];
    if (frame.scrollWidth > frame.clientWidth + 1 && !/auto|scroll/.test(getComputedStyle(frame).overflowX)) found.push(`${name} does not scroll`);
    const drawing = frame.querySelector("svg").getBoundingClientRect();
    for (const text of frame.querySelectorAll("text")) {
      const { left: at, right: end, width } = text.getBoundingClientRect();
      if (width === 0) continue;
      if (at < Math.max(from, drawing.left) - 1 || end > Math.min(to, drawing.right) + 1) found.push(`${name}: "${text.textContent}" is cut off`);
    }
  }
  for (const stage of document.querySelectorAll("main .live-stage")) {
    const [left, right] = around(stage);
    const box = stage.getBoundingClientRect();
    if (box.width > 0 && (box.left < left - 1 || box.right > right + 1)) found.push("a widget's frame is cut off");
  }
  return found;
}

/** Every page's figures at the width of a phone; and each drawing opened by its link. */
export async function figures({ open, base, pages, fault }) {
  const page = await open(base, { viewport: { width: 390, height: 844 } });
  const large = new Set();
  for (const name of pages.filter((name) => name !== "print.html")) {
    await page.goto(base + name);
    await page.evaluate(() => document.fonts.ready);
    for (const what of await page.evaluate(outOfReach)) fault(`${name}, 390 px`, what);
    for (const link of await page.locator("a.fig-large").evaluateAll((all) => all.map((a) => a.href))) large.add(link);
  }
  await page.context().close();
  for (const [width, height] of [[1400, 900], [390, 844]]) {
    const alone = await open(base, { viewport: { width, height }, colorScheme: "dark" });
    for (const link of large) {
      await alone.goto(link);
      const seen = await alone.evaluate(() => {
        const svg = document.documentElement;
        const box = svg.getBBox();
        const to = svg.getScreenCTM();
        const { width, height } = svg.viewBox.baseVal;
        const { x, y } = svg.viewBox.baseVal;
        return {
          left: to.a * x + to.e, top: to.d * y + to.f, width: to.a * width, height: to.d * height, drawn: box.width > 0,
          ink: getComputedStyle(svg).color, wide: innerWidth, high: innerHeight,
        };
      });
      const file = link.split("/").at(-1);
      const full = Math.max(seen.width / seen.wide, seen.height / seen.high);
      if (!seen.drawn || !(full > 0.97 && full < 1.01)) fault(`${file} opened, ${width} px`, `it takes ${(100 * full).toFixed(0)} % of the window`);
      if (Math.abs(2 * seen.left + seen.width - seen.wide) > 3 || Math.abs(2 * seen.top + seen.height - seen.high) > 3) {
        fault(`${file} opened, ${width} px`, `it is not in the middle: ${JSON.stringify(seen)}`);
      }
      if (seen.ink !== "rgb(230, 237, 243)") fault(`${file} opened, ${width} px`, `by night its ink is ${seen.ink}`);
    }
    await alone.context().close();
  }
  return large.size;
}
