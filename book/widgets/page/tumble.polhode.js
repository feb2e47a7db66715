// The tumble's ellipsoid of energy, as the body lies, with its polhodes; or rolling on its plane.
"use strict";

/** How it is drawn of the widget's state: the drawing for `paper` of live.bodies.js. */
tumblingLive.tumblePolhode = ({ state, seen, colours, place, rolling, spot }) => {
    const { dot, cross, unit, path } = tumblingLive.bodies;
    const AXES = [["x", "axis-mid"], ["y", "axis-max"], ["z", "axis-min"]];
    return (pen, width, height, canvas) => {
        const { setting, now } = state;
        const { body, world } = seen();
        const rolls = rolling.value === "plane" && setting.up !== null && setting.own !== null;
        const half = setting.moments.map((m) => Math.sqrt(setting.moments[2] / m));
        // The ellipsoid reaches 1 from its middle in any direction at most; its plane lies below.
        const scale = Math.max(Math.min(0.5 * width - 26, rolls ? (height - 52) / (1 + setting.deep + 0.4 * setting.wide) : 0.5 * height - 26), 1);
        const [cx, cy] = [width / 2, rolls ? 26 + scale : height / 2];
        const onto = (axes) => (p) => [cx + scale * dot(axes[0], p), cy - scale * dot(axes[1], p)];
        const [at, there] = [onto(body), onto(world)];
        const before = (p) => dot(p.map((x, k) => x / half[k] ** 2), body[2]) >= 0;
        const sign = rolls ? -1 : 1; // the plane lies below: it is touched opposite the spin
        const point = now.omega.map((x) => sign * x * setting.onto);
        const above = setting.up ? dot(world[2], setting.up) >= 0 : true;
        const plane = () => {
            const middle = setting.up.map((x) => -x * setting.deep);
            const [one, two] = [unit(cross(setting.up, Math.abs(setting.up[0]) < 0.7 ? [1, 0, 0] : [0, 1, 0]))].flatMap((a) => [a, cross(setting.up, a)]);
            const round = Array.from({ length: 48 }, (_, i) => {
                const turn = (i * Math.PI) / 24;
                return there(middle.map((x, k) => x + setting.wide * (Math.cos(turn) * one[k] + Math.sin(turn) * two[k])));
            });
            path(pen, round, true);
            pen.globalAlpha = above ? 1 : 0.6;
            pen.fillStyle = colours.ground;
            pen.fill();
            pen.globalAlpha = 1;
        };
        const herpolhode = () => {
            const track = state.window.track.map((p) => there(p));
            path(pen, track);
            pen.strokeStyle = colours.faint;
            pen.lineWidth = 0.8;
            pen.stroke();
            const share = (state.t - state.window.from) / (state.window.to - state.window.from);
            const here = Math.round(share * (track.length - 1));
            path(pen, [...track.slice(Math.max(0, here - 40), here), there(now.world.map((x) => -x * setting.onto))]);
            pen.strokeStyle = colours.omega;
            pen.lineWidth = 2.2;
            pen.stroke();
        };
        if (rolls && above) {
            plane();
            herpolhode();
        }
        // The outline is where a ball's is, drawn out along the half axes.
        const [a, b, c] = [[0, 0], [0, 1], [1, 1]].map(([i, j]) => half.reduce((sum, h, k) => sum + h * h * body[i][k] * body[j][k], 0));
        const lean = 0.5 * Math.atan2(2 * b, a - c);
        const root = Math.hypot((a - c) / 2, b);
        pen.beginPath();
        pen.ellipse(cx, cy, scale * Math.sqrt((a + c) / 2 + root), scale * Math.sqrt(Math.max((a + c) / 2 - root, 0)), -lean, 0, 2 * Math.PI);
        pen.fillStyle = colours.plain[26];
        pen.strokeStyle = colours.faint;
        pen.lineWidth = 1.2;
        pen.globalAlpha = rolls ? 0.7 : 1;
        pen.fill();
        pen.globalAlpha = 1;
        pen.stroke();
        const curve = (points, colour, thick) => {
            for (const front of [false, true]) {
                pen.beginPath();
                points.forEach((p, i) => {
                    const last = points.at(i - 1);
                    if (before(p) !== front && before(last) !== front) return;
                    pen.moveTo(...at(last));
                    pen.lineTo(...at(p));
                });
                pen.strokeStyle = colour;
                pen.lineWidth = thick;
                pen.globalAlpha = front ? 1 : 0.28;
                pen.stroke();
            }
            pen.globalAlpha = 1;
        };
        const mirrored = (points) => points.map((p) => p.map((x) => -x));
        for (const points of rolls ? [] : setting.others) for (const side of [points, mirrored(points)]) curve(side, colours.faint, 0.8);
        for (const points of setting.between) for (const side of [points, mirrored(points)]) curve(side, colours.separatrix, 1.2);
        if (setting.own) curve(rolls ? mirrored(setting.own) : setting.own, colours.omega, 2.2);
        AXES.forEach(([name, colour], k) => {
            const [from, to] = [half[k], half[k] + 14 / scale].map((far) => [0, 1, 2].map((i) => (i === k ? far : 0)));
            pen.strokeStyle = pen.fillStyle = colours[colour];
            pen.lineWidth = 2;
            path(pen, [at(from), at(to)]);
            pen.globalAlpha = body[2][k] >= 0 ? 1 : 0.4;
            pen.stroke();
            // Its name on from its tip, as one sees it.
            const [[fromX, fromY], [tipX, tipY]] = [at(from), at(to)];
            const long = Math.hypot(tipX - fromX, tipY - fromY) || 1;
            const [x, y] = [tipX + 11 * (tipX - fromX) / long, tipY + 11 * (tipY - fromY) / long];
            pen.font = colours.font;
            pen.textAlign = "center";
            pen.fillText(name, x, y + 5);
            pen.globalAlpha = 1;
        });
        // Seen through: what touches the plane is under the ellipsoid, or under the plane.
        if (rolls && !above) plane();
        if (rolls) {
            pen.globalAlpha = above ? 0.5 : 1;
            herpolhode();
            pen.globalAlpha = 1;
        }
        const finite = point.every(Number.isFinite);
        place(spot, "visibility", finite ? "visible" : "hidden");
        if (!finite) return;
        const [x, y] = at(point);
        place(spot, "transform", `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`);
        place(spot, "opacity", before(point) ? "1" : "0.45");
        canvas.shows = { rolls, touches: there(now.world.map((v) => -v * setting.onto)), spot: [x, y] }; // for those who test it
    };
};
