// The first screen: a book in the air, in slow motion, tossed about one of its three axes. Where it is, the tumble's module says.
"use strict";

tumblingLive.widget("toss", async (stage, from) => {
    const { load, module, sayer } = tumblingLive;
    const [exact] = await Promise.all([module("tumble"), load(`${from}live.book.js`)]);
    const canvas = stage.querySelector("canvas");
    const play = stage.querySelector("#toss-play");
    const choices = [...stage.querySelectorAll("[data-toss]")];
    const words = stage.querySelector("[data-shows=words]");
    const [slow, count, hint] = ["#toss-slow", ".toss-count", ".toss-hint"].map((what) => stage.querySelector(what));
    const say = sayer(stage);

    const [BOOK, SPIN, SLIP] = [1, 10, 0.04]; // which body; rad/s; how far a hand misses the axis, of the spin
    const book = tumblingLive.book(stage, exact.answer(6, BOOK));
    const WORDS = {
        across: "Watch the pin: it starts on the right. Every few turns the book flips, and the pin comes out on the other side. Nothing touches it.",
        spine: "Rolled about its long axis, of least resistance, it goes on as it began: no flip.",
        through: "Thrown flat, about the axis of greatest resistance, it goes on as it began: no flip.",
    };
    const state = { toss: "across", t: 0, flips: 0, turn: 24, tilt: 0, playing: false };
    function draw() {
        const [, , , w, i, j, k, , , , flips] = exact.answer(1, state.t);
        if (flips !== state.flips) tell(flips);
        book.draw(canvas, book.tosses[state.toss], [w, i, j, k], state);
        Object.assign(canvas.shows ??= {}, { t: state.t, flips });
    }

    // ---- Time: it runs while the book is in view, unless it is paused or less motion is preferred.
    const still = matchMedia("(prefers-reduced-motion: reduce)");
    let [wanted, inView, pending, last] = [!still.matches, false, 0, null];
    function frame(now) {
        if (last !== null) state.t += Math.min(now - last, 100) / (1000 * slow.value); // what a hidden page missed is not made up for
        last = now;
        draw();
        pending = requestAnimationFrame(frame);
    }
    function settle() {
        const runs = wanted && inView;
        if (runs === state.playing) return;
        state.playing = runs;
        last = null;
        if (runs) pending = requestAnimationFrame(frame);
        else cancelAnimationFrame(pending);
    }
    function name() {
        play.textContent = wanted ? "Pause" : "Play";
    }
    play.addEventListener("click", () => {
        wanted = !wanted;
        name();
        settle();
    });
    still.addEventListener("change", () => {
        wanted = !still.matches;
        name();
        settle();
    });
    new IntersectionObserver(([{ isIntersecting }]) => {
        inView = isIntersecting;
        settle();
    }).observe(canvas);

    /** A flip is counted where it is seen. */
    function tell(flips) {
        state.flips = flips;
        count.textContent = flips > 0 ? `Flip ${flips}` : "";
        count.getAnimations().forEach((glide) => glide.finish());
        if (flips > 0 && !still.matches) count.animate([{ transform: "scale(1.6)" }, { transform: "none" }], 500);
        if (flips > 0) say(`Flip ${flips}.`);
    }
    const paced = () => {
        stage.querySelector("[data-shows=slow]").textContent = slow.value === "1" ? "as in life" : `${slow.value} times slower`;
        slow.setAttribute("aria-valuetext", stage.querySelector("[data-shows=slow]").textContent);
    };
    slow.addEventListener("input", paced);
    function toss(which) {
        for (const button of choices) button.setAttribute("aria-pressed", String(button.dataset.toss === which));
        state.toss = which;
        state.t = 0;
        exact.answer(0, BOOK, SPIN, SLIP, book.tosses[which].about);
        tell(0);
        words.textContent = WORDS[state.toss];
        draw();
    }
    for (const button of choices) {
        button.addEventListener("click", () => {
            toss(button.dataset.toss);
            say(WORDS[state.toss]);
        });
    }

    // Dragged, the reader goes round: half a degree for each pixel, by finger as by mouse. A finger that goes up or down scrolls the page.
    let held = null;
    canvas.addEventListener("pointerdown", (event) => {
        canvas.setPointerCapture(event.pointerId);
        held = [event.clientX, event.clientY];
        hint.hidden = true;
    });
    canvas.addEventListener("pointermove", (event) => {
        if (!held) return;
        const { above } = book.tosses[state.toss];
        state.turn += 0.5 * (event.clientX - held[0]);
        state.tilt = Math.max(-80 - above, Math.min(80 - above, state.tilt + 0.5 * (event.clientY - held[1])));
        held = [event.clientX, event.clientY];
        if (!state.playing) draw();
    });
    for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, () => { held = null; });

    const recolour = () => {
        book.dye();
        draw();
    };
    new MutationObserver(recolour).observe(document.documentElement, { attributes: true, attributeFilter: ["class"] });
    new ResizeObserver(draw).observe(canvas);
    name();
    paced();
    toss("across");
});
