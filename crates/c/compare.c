/* Random steps, and the sum of their bits: the test in tests/step/position_stage_in_c.rs takes the same in Rust. */
#include "position_stage.h"
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static uint64_t seed = 1;

/* From 0 to 1, with 24 bits. */
static tumbling_real number(void) {
    seed ^= seed << 13, seed ^= seed >> 7, seed ^= seed << 17;
    return (tumbling_real)(seed >> 40) / (tumbling_real)16777216;
}

static uint64_t sum = 14695981039346656037u;

static void add(tumbling_real x) {
    uint64_t bits = 0;
    memcpy(&bits, &x, sizeof x);
    sum = (sum ^ bits) * 1099511628211u;
}

int main(int count, char **words) {
    long steps = count > 1 ? atol(words[1]) : 1000, n;
    int i;
    tumbling_body body;
    tumbling_state state;
    for (n = 0; n < steps; n++) {
        tumbling_real h, size;
        if (n % 16 == 0) {
            tumbling_real moments[3], frame[4];
            for (i = 0; i < 3; i++) moments[i] = number() + (tumbling_real)0.0625;
            if (n % 64 == 16) moments[1] = moments[0];
            if (n % 64 == 32) moments[1] = moments[2] = 1, moments[0] = 0;
            for (i = 0; i < 4; i++) frame[i] = number() - (tumbling_real)0.5;
            tumbling_prepare(&body, moments, n % 32 == 0 ? frame : 0);
            for (i = 0; i < 4; i++) state.attitude[i] = number() + (tumbling_real)0.0625;
            for (i = 0; i < 3; i++) state.omega[i] = 16 * number() - 8;
        }
        /* Mostly short, now and then of some ten radians. */
        size = number();
        h = size * size * size * size / 4 - (tumbling_real)0.0078125;
        sum += (uint64_t)tumbling_step(&body, &state, h);
        for (i = 0; i < 4; i++) add(state.attitude[i]);
        for (i = 0; i < 3; i++) add(state.omega[i]);
        state.omega[n % 3] = state.omega[n % 3] * (tumbling_real)0.9375 + number() - (tumbling_real)0.5;
    }
    printf("%016llx\n", (unsigned long long)sum);
    return 0;
}
