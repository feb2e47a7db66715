/* Frames, moments and tensors as small and as large as numbers are, and those that no body has: what is taken gives the
   steps of the body in its own scale, what is not is refused and gives a body of constant spin. Says which line is not
   so. In single precision if SINGLE is defined. */
#ifdef SINGLE
#define TUMBLING_FLOAT
#define tumbling(name) tumblingf_##name
#define LEAST (-149)
#define MOST 127
#else
#define tumbling(name) tumbling_##name
#define LEAST (-1074)
#define MOST 1023
#endif
#include "position_stage.h"
#include <stdio.h>
#include <string.h>

typedef tumbling(real) real;
static int wrong = 0;
#define IS(condition) \
    do { \
        if (!(condition)) printf("line %d: not %s\n", __LINE__, #condition), wrong = 1; \
    } while (0)

/* Parts of a step from the same start, and where it ends. */
static int end(const tumbling(body) *body, tumbling(state) *state) {
    const tumbling(state) start = {{(real)0.5, (real)0.5, (real)-0.5, (real)0.5}, {1, 4, -2}};
    *state = start;
    return tumbling(step)(body, state, (real)0.0625);
}
static int constant(const tumbling(body) *body) {
    tumbling(state) state;
    return end(body, &state) > 0 && state.omega[0] == 1 && state.omega[1] == 4 && state.omega[2] == -2;
}
static real power(int exponent) {
    return (real)ldexp(1, exponent);
}

static void frames(void) {
    const real moments[3] = {(real)0.3, (real)0.4, (real)0.6};
    const real none = (real)NAN, endless = (real)INFINITY;
    real frame[4] = {1, -1, 1, 1}, bad[4][4] = {{0, 0, 0, 0}, {1, 0, 0, 0}, {1, 0, 0, 0}, {0, 0, 0, 0}};
    tumbling(body) body;
    tumbling(state) expected, state;
    int e, i;
    IS(tumbling(prepare)(&body, moments, frame) && end(&body, &expected) && !constant(&body));
    for (e = LEAST; e <= MOST; e++) {
        for (i = 0; i < 4; i++) frame[i] = i == 1 ? -power(e) : power(e);
        IS(tumbling(prepare)(&body, moments, frame) && end(&body, &state));
        IS(memcmp(&state, &expected, sizeof state) == 0);
    }
    bad[1][2] = none, bad[2][0] = endless, bad[3][3] = -endless;
    for (i = 0; i < 4; i++) IS(!tumbling(prepare)(&body, moments, bad[i]) && constant(&body));
}

static void moments(void) {
    const real none = (real)NAN, endless = (real)INFINITY, tiny = power(LEAST), huge = power(MOST);
    const real refused[9][3] = {{-1, 1, 1}, {1, none, 1}, {1, 1, endless}, {endless, endless, endless}, {0, 1, 2},
                                {0, 0, 1}, {tiny, 1, huge}, {1, huge, tiny}, {huge, 1, 1}};
    const real locked[3][3] = {{0, 1, 2}, {0, 0, 3}, {0, 0, 0}};
    const real never[4][3] = {{1, 2, -1}, {0, none, 0}, {1, endless, 1}, {1, 1, power(LEAST)}};
    tumbling(body) body, same;
    tumbling(state) expected, state;
    int e, i;
    for (i = 0; i < 9; i++) IS(!tumbling(prepare)(&body, refused[i], 0) && constant(&body));
    for (i = 0; i < 4; i++) IS(!tumbling(of_inverse)(&body, never[i], 0) && constant(&body));
    for (i = 0; i < 3; i++) IS(tumbling(of_inverse)(&body, locked[i], 0) && constant(&body));
    for (e = LEAST + 3; e <= MOST - 3; e++) {
        const real scaled[3] = {3 * power(e), 4 * power(e), 6 * power(e)}, one[3] = {3, 4, 6};
        IS(tumbling(prepare)(&same, one, 0) && end(&same, &expected) && !constant(&same));
        IS(tumbling(prepare)(&body, scaled, 0) && end(&body, &state));
        IS(memcmp(&state, &expected, sizeof state) == 0);
    }
    {
        const real inverse[3] = {(real)0.5, (real)0.25, (real)0.125}, own[3] = {2, 4, 8};
        IS(tumbling(of_inverse)(&body, inverse, 0) && end(&body, &state));
        IS(tumbling(prepare)(&same, own, 0) && end(&same, &expected));
        IS(memcmp(&state, &expected, sizeof state) == 0);
    }
}

static void tensors(void) {
    /* Moments 2, 3, 5 along (2, 1, 2)/3, (-2, 2, 1)/3, (-1, -2, 2)/3, times 9. */
    static const int whole[3][3] = {{25, 2, -8}, {2, 34, -10}, {-8, -10, 31}};
    const real odd[3] = {(real)NAN, (real)INFINITY, 1};
    real first[4], found[3], frame[4], t[3][3];
    int e, i, j;
    for (e = LEAST; e <= MOST - 6; e++) {
        for (i = 0; i < 3; i++) {
            for (j = 0; j < 3; j++) t[i][j] = (real)whole[i][j] * power(e);
        }
        IS(tumbling(principal)(t, found, frame));
        if (e == LEAST) memcpy(first, frame, sizeof frame);
        IS(memcmp(frame, first, sizeof frame) == 0);
        for (i = 0; i < 3; i++) {
            real unit = found[i] / power(e), nearest = (real)(unit < 22 ? 18 : unit < 36 ? 27 : 45);
            IS(fabs((double)(unit - nearest)) < 1e-5);
        }
    }
    for (i = 0; i < 9; i++) {
        memset(t, 0, sizeof t);
        t[0][0] = 2, t[1][1] = 3, t[2][2] = 4;
        t[i % 3][(i + 1) % 3] = odd[i / 3]; /* neither a number, nor finite, nor symmetric */
        IS(!tumbling(principal)(t, found, frame));
    }
    for (i = 0; i < 9; i++) t[i / 3][i % 3] = power(MOST);
    IS(!tumbling(principal)(t, found, frame)); /* one moment is three times as large */
}

int main(void) {
    frames();
    moments();
    tensors();
    return wrong;
}
