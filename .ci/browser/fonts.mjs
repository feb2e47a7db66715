// Every letter of a page stands in one of the book's own fonts. A letter that none of them has comes from whatever the machine has, so
// that the page fits on one machine and not on another.

/** The families of book/theme/fonts/fonts.css. */
const OWN = ["Literata", "Tumbling Sans", "Tumbling Mono", "Tumbling Math"];

/** To be run before a page's scripts: notes what is written on canvases, in which font, and whether that font was there. */
export function watchCanvases() {
  globalThis.writtenOnCanvases = new Map();
  for (const name of ["fillText", "strokeText"]) {
    const draw = CanvasRenderingContext2D.prototype[name];
    CanvasRenderingContext2D.prototype[name] = function (text, ...place) {
      const family = this.font.replace(/^.*?[\d.]+px(\/\S+)? /, "");
      const about = this.font.slice(0, this.font.length - family.length);
      const kept = globalThis.writtenOnCanvases.get(this.canvas) ?? new Map();
      globalThis.writtenOnCanvases.set(this.canvas, kept.set(`${/italic/.test(about)} ${/bold|[67]00/.test(about) ? 600 : 400} ${family}`, text));
      return draw.call(this, text, ...place);
    };
  }
}

/**
 * Puts a probe at the end of the page for each way in which a part's text is set, with every letter that is set so; answers, for each probe, the first
 * element of each letter. A browser says of an element which fonts its letters came from, but to ask that of each of a page's thousands is slow.
 */
function probe(part) {
  document.querySelector("#font-probes")?.remove();
  const ways = new Map();
  const note = (element, style, text, about) => {
    const letters = [...text].filter((letter) => letter > " ");
    if (letters.length === 0) return;
    const turned = style.textTransform === "math-auto" ? (letters.length === 1 ? "math-auto" : "none") : style.textTransform;
    const way = [style.fontFamily, style.fontStyle, style.fontWeight, turned].join("|");
    if (!ways.has(way)) ways.set(way, new Map());
    for (const letter of letters) if (!ways.get(way).has(letter)) ways.get(way).set(letter, `<${element.localName}> ${about}"${text.trim().slice(0, 40)}"`);
  };
  const drawn = (element) => element.checkVisibility?.() ?? true;
  for (const element of document.querySelectorAll(`${part}, ${part} *`)) {
    if (/^(script|style|noscript|template|option|title)$/.test(element.localName) || !drawn(element)) continue;
    const style = getComputedStyle(element);
    for (const part of element.childNodes) if (part.nodeType === Node.TEXT_NODE) note(element, style, part.data, "");
    for (const pseudo of ["::before", "::after", "::marker"]) {
      const of = getComputedStyle(element, pseudo);
      const said = /^"(.*)"$/.exec(of.content)?.[1];
      if (said) note(element, of, said, `${pseudo} `);
    }
    if (element.matches("select")) for (const option of element.options) note(option, getComputedStyle(option), option.label, "");
    if (element.matches("textarea, input:not([type=range], [type=checkbox], [type=radio])")) {
      note(element, style, element.type === "file" ? "Choose File No file chosen" : element.value, "");
      note(element, style, element.placeholder ?? "", "placeholder ");
      if (element.type === "file") note(element, getComputedStyle(element, "::file-selector-button"), "Choose File", "its button ");
    }
  }
  for (const [canvas, written] of globalThis.writtenOnCanvases ?? []) {
    for (const [font, text] of canvas.closest(part) ? written : []) {
      const [, italic, weight, family] = /^(\w+) (\d+) (.*)$/.exec(font);
      note(canvas, { fontFamily: family, fontStyle: italic === "true" ? "italic" : "normal", fontWeight: weight, textTransform: "none" }, text, "");
    }
  }
  const box = document.body.appendChild(document.createElement("div"));
  box.id = "font-probes";
  box.style.cssText = "position: absolute; top: 0; left: 0; opacity: 0; pointer-events: none";
  return [...ways].map(([way, letters]) => {
    const [fontFamily, fontStyle, fontWeight, textTransform] = way.split("|");
    const line = box.appendChild(document.createElement("p"));
    for (const letter of letters.keys()) {
      const span = line.appendChild(document.createElement("span"));
      Object.assign(span.style, { fontFamily, fontStyle, fontWeight, textTransform });
      span.textContent = letter;
    }
    return { way, letters: [...letters] };
  });
}

/** A session with the browser about a page's elements; `named(node)` says which fonts an element's letters are set in. */
async function asking(page) {
  const session = await page.context().newCDPSession(page);
  await session.send("DOM.enable");
  await session.send("CSS.enable");
  const { root } = await session.send("DOM.getDocument", { depth: 0 });
  const find = async (selector) => (await session.send("DOM.querySelectorAll", { nodeId: root.nodeId, selector })).nodeIds;
  const fonts = async (nodeId) => (await session.send("CSS.getPlatformFontsForNode", { nodeId })).fonts;
  return { find, fonts, end: () => session.detach() };
}

const foreign = (font) => !font.isCustomFont || !OWN.includes(font.familyName);
const names = (fonts) => fonts.map(({ familyName, isCustomFont }) => `${familyName}${isCustomFont ? "" : " (of this machine)"}`).join(", ");

/** What is set in another font than the book's own in a part of a page. */
export async function foreignLetters(page, part = "body") {
  const ways = await page.evaluate(probe, part);
  await page.evaluate(() => document.fonts.ready);
  const { find, fonts, end } = await asking(page);
  const lines = await find("#font-probes > p");
  const found = [];
  for (const [at, { letters }] of ways.entries()) {
    if (!(await fonts(lines[at])).some(foreign)) continue;
    const spans = await find(`#font-probes > p:nth-child(${at + 1}) > span`);
    const by = new Map();
    for (const [k, [letter, where]] of letters.entries()) {
      const of = names((await fonts(spans[k])).filter(foreign));
      if (of) by.set(of, { said: (by.get(of)?.said ?? "") + letter, where: by.get(of)?.where ?? where });
    }
    for (const [of, { said, where }] of by) found.push(`"${said}" is set in ${of}: ${where}`);
  }
  await end();
  await page.evaluate(() => document.querySelector("#font-probes").remove());
  return found;
}

/** To faults of elements that carry `data-fault="N"`, N in their order, adds the fonts that these are set in. */
export async function withFonts(page, faults) {
  if (!faults.some(({ marked }) => marked)) return faults.map(({ what }) => what);
  const { find, fonts, end } = await asking(page);
  const said = [];
  for (const { what, marked } of faults) {
    const [node] = marked ? await find(`[data-fault="${marked}"]`) : [];
    said.push(node ? `${what} (set in ${names(await fonts(node))})` : what);
  }
  await end();
  await page.evaluate(() => { for (const element of document.querySelectorAll("[data-fault]")) delete element.dataset.fault; });
  return said;
}
