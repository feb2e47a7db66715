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
        /** Closed curves of one colour, each three numbers a point, and their mirror images: one line for all that is behind, one for all in front. */
        const curves = (list, signs, colour, thick) => {
            const [[a, b, c], [d, e, f]] = [body[0], body[1]].map((axis) => axis.map((x) => scale * x));
            const [u, v, w] = body[2].map((x, k) => x / half[k] ** 2);
            [pen.strokeStyle, pen.lineWidth, pen.lineJoin] = [colour, thick, "round"];
            for (const front of [false, true]) {
                pen.beginPath();
                for (const points of list) {
                    for (const sign of signs) {
                        let was = false;
                        let goes = false; // the line ends at the point before
                        for (let k = -3, fromX = 0, fromY = 0; k < points.length; k += 3) {
                            const i = k < 0 ? points.length - 3 : k;
                            const x = sign * points[i];
                            const y = sign * points[i + 1];
                            const z = sign * points[i + 2];
                            const toX = cx + a * x + b * y + c * z;
                            const toY = cy - d * x - e * y - f * z;
                            const is = u * x + v * y + w * z >= 0 === front;
                            if (k >= 0 && (is || was)) {
                                if (!goes) pen.moveTo(fromX, fromY);
                                pen.lineTo(toX, toY);
                                goes = true;
                            } else goes = false;
                            was = is;
                            fromX = toX;
                            fromY = toY;
                        }
                    }
                }
                pen.globalAlpha = front ? 1 : 0.28;
                pen.stroke();
            }
            pen.globalAlpha = 1;
        };
        const BOTH = [1, -1];
        if (!rolls) curves(setting.others, BOTH, colours.faint, 0.8);
        curves(setting.between, BOTH, colours.separatrix, 1.2);
        if (setting.own) curves([setting.own], [rolls ? -1 : 1], colours.omega, 2.2);
        const names = {};
        AXES.forEach(([name, colour], k) => {
            const [from, to] = [half[k], half[k] + 14 / scale].map((far) => [0, 1, 2].map((i) => (i === k ? far : 0)));
            pen.strokeStyle = colours[colour];
            pen.lineWidth = 2;
            path(pen, [at(from), at(to)]);
            pen.globalAlpha = body[2][k] >= 0 ? 1 : 0.4;
            pen.stroke();
            // Its name on from its tip, as one sees it.
            const [[fromX, fromY], [tipX, tipY]] = [at(from), at(to)];
            const long = Math.hypot(tipX - fromX, tipY - fromY) || 1;
            names[name] = [tipX + 11 * (tipX - fromX) / long, tipY + 11 * (tipY - fromY) / long];
            tumblingLive.word(pen, colours.stamps, name, colours.font, colours[colour], names[name]);
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
        canvas.shows = { rolls, names, touches: there(now.world.map((v) => -v * setting.onto)), spot: [x, y] }; // for those who test it
    };
};
