/* What a step of one body costs, in nanoseconds, by three rules that engines take for the turning of a free body and by
   the position stage: the least of many runs over a thousand bodies, in single and in double precision, and in units of
   the rescaled rule.

       gcc -O2 -o costs examples/engines/c/costs.c -lm && ./costs

   All rules are written out, with spin in world axes, as in an engine; none checks its numbers but the position stage. */
#ifndef BODIES
#define _POSIX_C_SOURCE 199309L
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#define BODIES 1000
#define ROUNDS 2000

static double seconds(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}
#define COUNT 8
static const char *const RULES[COUNT] = {"no gyroscopic term", "explicit step", "explicit step, rescaled", "position stage",
                                         "position stage, tensor in other axes", "position stage, all at once",
                                         "position stage, all at once, other axes", "position stage, round bodies"};

#define tumbling(name) tumbling_##name
#define costs costs_double
#include "position_stage.h"
#include "costs.c"
#undef tumbling
#undef costs
#define TUMBLING_FLOAT
#define tumbling(name) tumblingf_##name
#define costs costs_float
#include "position_stage.h"
#include "costs.c"

int main(void) {
    double single[COUNT], twice[COUNT];
#ifdef __clang__
    const char *compiler = "clang";
    const int version = __clang_major__;
#else
    const char *compiler = "gcc";
    const int version = __GNUC__;
#endif
    int rule;
    costs_float(single);
    costs_double(twice);
    printf("compiler,rule,\"float, ns\",\"double, ns\",\"float, of rescaled\",\"double, of rescaled\"\n");
    for (rule = 0; rule < COUNT; rule++) {
        printf("%s %d,\"%s\",%.1f,%.1f,%.2f,%.2f\n", compiler, version, RULES[rule], single[rule], twice[rule],
               single[rule] / single[2], twice[rule] / twice[2]);
    }
    return 0;
}
#else

/* The bodies of this precision. */
#define bodies tumbling(bodies)
#define moments tumbling(moments)
#define states tumbling(states)
static tumbling(body) bodies[BODIES];
static tumbling(real) moments[BODIES][3];
static tumbling(state) states[BODIES];

/* The attitude turned by the spin, linearly, and its length restored. */
static void tumbling(turn)(tumbling(state) *state, tumbling(real) h) {
    const tumbling(real) *v = state->omega, half = h / 2;
    tumbling(real) *q = state->attitude, a = v[0] * half, b = v[1] * half, c = v[2] * half, over;
    const tumbling(real) w = q[0], x = q[1], y = q[2], z = q[3];
    q[0] = w - (a * x + b * y + c * z);
    q[1] = x + (a * w + b * z - c * y);
    q[2] = y + (b * w + c * x - a * z);
    q[3] = z + (c * w + a * y - b * x);
    over = 1 / tumbling(sqrt)(tumbling(square)(q));
    q[0] *= over, q[1] *= over, q[2] *= over, q[3] *= over;
}

/* The explicit gyroscopic term; the momentum brought back to its length if `rescaled`. */
static void tumbling(gyroscopic)(tumbling(state) *state, const tumbling(real) m[3], tumbling(real) h, int rescaled) {
    const tumbling(real) *q = state->attitude, w = q[0], x = q[1], y = q[2], z = q[3];
    const tumbling(real) x2 = x + x, y2 = y + y, z2 = z + z;
    const tumbling(real) r[3][3] = {{1 - (y * y2 + z * z2), x * y2 - w * z2, x * z2 + w * y2},
                                    {x * y2 + w * z2, 1 - (x * x2 + z * z2), y * z2 - w * x2},
                                    {x * z2 - w * y2, y * z2 + w * x2, 1 - (x * x2 + y * y2)}};
    tumbling(real) v[3], l[3], after[3], factor = 1;
    int i;
    for (i = 0; i < 3; i++) {
        v[i] = r[0][i] * state->omega[0] + r[1][i] * state->omega[1] + r[2][i] * state->omega[2];
        l[i] = m[i] * v[i];
    }
    for (i = 0; i < 3; i++) after[i] = l[i] + h * (l[(i + 1) % 3] * v[(i + 2) % 3] - l[(i + 2) % 3] * v[(i + 1) % 3]);
    if (rescaled) {
        const tumbling(real) square = after[0] * after[0] + after[1] * after[1] + after[2] * after[2];
        if (square > 0) factor = tumbling(sqrt)((l[0] * l[0] + l[1] * l[1] + l[2] * l[2]) / square);
    }
    for (i = 0; i < 3; i++) v[i] = after[i] * factor / m[i];
    for (i = 0; i < 3; i++) state->omega[i] = r[i][0] * v[0] + r[i][1] * v[1] + r[i][2] * v[2];
}

static void tumbling(start)(int framed, int round) {
    static const tumbling(real) frame[4] = {(tumbling(real))0.6, 0, (tumbling(real))0.8, 0};
    int n, i;
    srand(1);
    for (n = 0; n < BODIES; n++) {
        for (i = 0; i < 3; i++) {
            moments[n][i] = 1 + (tumbling(real))(rand() % 1000) / 1001;
            states[n].omega[i] = (tumbling(real))(rand() % 1000) / 100 - 5;
            states[n].attitude[1 + i] = 0;
        }
        states[n].attitude[0] = 1;
        if (round) moments[n][1] = moments[n][2] = moments[n][0];
        tumbling(prepare)(&bodies[n], moments[n], framed ? frame : 0);
    }
}

static void costs(double ns[COUNT]) {
    const tumbling(real) h = (tumbling(real))1 / 240;
    int rule, round, n;
    for (rule = 0; rule < COUNT; rule++) {
        ns[rule] = 1e30;
        tumbling(start)(rule == 4 || rule == 6, rule == 7);
        for (round = 0; round < ROUNDS; round++) {
            const double began = seconds();
            double took;
            if (rule >= 5) {
                tumbling(step_all)(BODIES, bodies, sizeof bodies[0], states[0].attitude, sizeof states[0], states[0].omega,
                                   sizeof states[0], 0, h);
            }
            for (n = 0; n < BODIES && rule < 5; n++) {
                if (rule >= 3) tumbling(step)(&bodies[n], &states[n], h);
                else if (rule > 0) tumbling(gyroscopic)(&states[n], moments[n], h, rule == 2);
                if (rule < 3) tumbling(turn)(&states[n], h);
            }
            took = 1e9 * (seconds() - began) / BODIES;
            if (took < ns[rule]) ns[rule] = took;
        }
    }
}
#undef bodies
#undef moments
#undef states
#endif
