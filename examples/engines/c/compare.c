/* Random steps, and the sum of their bits: the test in tests/step/position_stage_in_c.rs takes the same in Rust. In single
   precision if SINGLE is defined. */
#ifdef SINGLE
#define TUMBLING_FLOAT
#define tumbling(name) tumblingf_##name
#else
#define tumbling(name) tumbling_##name
#endif
#include "position_stage.h"
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifdef __clang__ /* the numbers of this file are no part of what options change */
#pragma clang diagnostic ignored "-Wignored-pragmas"
#pragma float_control(precise, on)
#pragma STDC FP_CONTRACT OFF
#endif

static uint64_t seed = 1;

/* From 0 to 1, with 24 bits. */
static tumbling(real) number(void) {
    seed ^= seed << 13, seed ^= seed >> 7, seed ^= seed << 17;
    return (tumbling(real))(seed >> 40) / (tumbling(real))16777216;
}

static uint64_t sum = 14695981039346656037u;

static void add(tumbling(real) x) {
    uint64_t bits = 0;
    memcpy(&bits, &x, sizeof x);
    sum = (sum ^ bits) * 1099511628211u;
}

/* How far a tensor is from what its principal moments and their frame make again. */
static double apart(tumbling(real) tensor[3][3]) {
    tumbling(real) moments[3], f[4];
    double w, x, y, z, r[3][3], most = 0;
    int i, j, k;
    if (!tumbling(principal)(tensor, moments, f)) return 1;
    w = (double)f[0], x = (double)f[1], y = (double)f[2], z = (double)f[3];
    r[0][0] = 1 - 2 * (y * y + z * z), r[0][1] = 2 * (x * y - w * z), r[0][2] = 2 * (x * z + w * y);
    r[1][0] = 2 * (x * y + w * z), r[1][1] = 1 - 2 * (x * x + z * z), r[1][2] = 2 * (y * z - w * x);
    r[2][0] = 2 * (x * z - w * y), r[2][1] = 2 * (y * z + w * x), r[2][2] = 1 - 2 * (x * x + y * y);
    for (i = 0; i < 3; i++) {
        for (j = 0; j < 3; j++) {
            double sum = -(double)tensor[i][j];
            for (k = 0; k < 3; k++) sum += r[i][k] * (double)moments[k] * r[j][k];
            if (fabs(sum) > most) most = fabs(sum);
        }
    }
    return most;
}

/* Random tensors; 0 if one is not made again to rounding. */
static int principal_axes(void) {
    int n, i, j;
    for (n = 0; n < 1000; n++) {
        tumbling(real) t[3][3];
        for (i = 0; i < 3; i++) {
            for (j = i; j < 3; j++) t[i][j] = t[j][i] = i == j ? 1 + number() : n % 7 == j ? 0 : number() - (tumbling(real))0.5;
        }
        if (apart(t) > (sizeof t[0][0] == sizeof(float) ? 1e-6 : 1e-14)) return 0;
    }
    seed = 1;
    return 1;
}

/* Bodies of every kind side by side; 0 if one does not get the bits that it gets alone. */
static int side_by_side(void) {
    enum { BODIES = 203 };
    static tumbling(body) bodies[BODIES];
    static tumbling(state) alone[BODIES], together[BODIES];
    const tumbling(real) h = (tumbling(real))0.03125;
    size_t missed = 0, n;
    int i, round;
    for (n = 0; n < BODIES; n++) {
        const tumbling(real) speed = n % 19 == 0 ? 0 : n % 13 == 0 ? (tumbling(real))1e-12 : n % 17 == 0 ? 300 : 16;
        tumbling(real) moments[3], frame[4];
        for (i = 0; i < 3; i++) moments[i] = n % 5 == 0 && i > 0 ? moments[0] : number() + (tumbling(real))0.0625;
        for (i = 0; i < 4; i++) frame[i] = number() - (tumbling(real))0.5;
        tumbling(prepare)(&bodies[n], moments, n % 3 ? frame : 0);
        for (i = 0; i < 4; i++) alone[n].attitude[i] = n % 11 ? (tumbling(real))(i == 0) : number();
        for (i = 0; i < 3; i++) alone[n].omega[i] = speed * (number() - (tumbling(real))0.5);
        if (n % 71 == 70) alone[n].omega[1] = (tumbling(real))(HUGE_VAL - HUGE_VAL);
        together[n] = alone[n];
    }
    for (round = 0; round < 9; round++) {
        for (n = 0; n < BODIES; n++) missed += !tumbling(step)(&bodies[n], &alone[n], h);
        missed -= tumbling(step_all)(BODIES, bodies, sizeof bodies[0], together[0].attitude, sizeof together[0],
                                     together[0].omega, sizeof together[0], 0, h);
        if (missed || memcmp(alone, together, sizeof alone)) return 0;
    }
    seed = 1;
    return 1;
}

int main(int count, char **words) {
    long steps = count > 1 ? atol(words[1]) : 1000, n;
    int i;
    tumbling(body) body;
    tumbling(state) state;
    if (!principal_axes() || !side_by_side()) return 1;
    for (n = 0; n < steps; n++) {
        tumbling(real) h, size;
        if (n % 16 == 0) {
            tumbling(real) moments[3], frame[4];
            for (i = 0; i < 3; i++) moments[i] = number() + (tumbling(real))0.0625;
            if (n % 64 == 16) moments[1] = moments[0];
            if (n % 64 == 32) moments[1] = moments[2] = 1, moments[0] = 0;
            for (i = 0; i < 4; i++) frame[i] = number() - (tumbling(real))0.5;
            if (n % 48 == 0) tumbling(of_inverse)(&body, moments, n % 32 == 0 ? frame : 0);
            else tumbling(prepare)(&body, moments, n % 32 == 0 ? frame : 0);
            for (i = 0; i < 4; i++) state.attitude[i] = number() + (tumbling(real))0.0625;
            for (i = 0; i < 3; i++) state.omega[i] = 16 * number() - 8;
        }
        /* Mostly short, now and then of some ten radians. */
        size = number();
        h = size * size * size * size / 4 - (tumbling(real))0.0078125;
        sum += (uint64_t)tumbling(step)(&body, &state, h);
        for (i = 0; i < 4; i++) add(state.attitude[i]);
        for (i = 0; i < 3; i++) add(state.omega[i]);
        state.omega[n % 3] = state.omega[n % 3] * (tumbling(real))0.9375 + number() - (tumbling(real))0.5;
    }
    printf("%016llx\n", (unsigned long long)sum);
    return 0;
}
