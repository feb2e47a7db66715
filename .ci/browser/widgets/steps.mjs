// The error of a step.
import { read, stepsDrawn } from "../drawn.flat.mjs";
import { broken, said, set, shown } from "./controls.mjs";

export async function steps(page, wants) {
  const step = "#steps-step";
  const methods = await page.locator("#steps-method option").allTextContents();
  wants(`all methods of the library are there: ${methods.length}`, methods.length === 26);
  const choose = (name) => set(page, "#steps-method", methods.indexOf(name));

  // What halving the step buys, as the chapter says.
  for (const [name, times] of [["explicit Euler", 2], ["three rotations", 4], ["Runge-Kutta 4", 16], ["Moser-Veselov 6", 64]]) {
    await choose(name);
    await set(page, step, 6);
    const better = await shown(page, "steps", "better");
    wants(`${name}: with half the step the error is ${better}, not ${times} times`, Math.abs(read(better) / times - 1) < 0.25 && better.endsWith(" better"));
  }

  await stepsDrawn(page, set, shown, wants, methods);

  // Every method at every end, from every start.
  for (let which = 0; which < methods.length; which += 1) {
    await set(page, "#steps-method", which);
    for (const start of [0, 1, 2]) {
      await set(page, "#steps-start", start);
      await set(page, "#steps-body", start);
      for (const end of [0, 16]) {
        await set(page, step, end);
        wants(`${methods[which]}, start ${start}, step ${end}: everything has a number and a place`, !(await broken(page, "steps")));
        const reason = (await page.isVisible("#live-steps .live-wrong")) ? await page.textContent("#live-steps .live-wrong") : "refused: a step";
        wants(`a refusal says why: ${reason}`, /^refused: (a|the) ./.test(reason));
      }
    }
  }
  await choose("Moser-Veselov");
  await set(page, "#steps-start", 1);
  await set(page, "#steps-body", 0);
  await set(page, step, 16);
  wants("a step too long is refused", /^refused: .* was not found/.test(await page.textContent("#live-steps .live-wrong")));

  // By keyboard, with words.
  await set(page, "#steps-start", 0);
  await choose("Runge-Kutta 4");
  await set(page, step, 6);
  await page.locator(step).focus();
  await page.keyboard.press("ArrowRight");
  wants(`an arrow key lengthens the step: ${await shown(page, "steps", "step")}`, (await shown(page, "steps", "step")).endsWith("141 steps"));
  wants("a screen reader gets the answer", /Attitude off by/.test(await page.getAttribute(step, "aria-valuetext")));
  await page.keyboard.press("ArrowLeft");
  wants(...await said(page, "steps", /Runge-Kutta 4, step 0.050 s/));
}
