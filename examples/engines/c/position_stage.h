/* The position stage of a physics engine: attitude and spin over a time step, with nothing else acting. It keeps energy
   and momentum to rounding, whatever spin and step, if no axis is locked. In the engine's loop, after forces, damping,
   contacts and joints have changed the spin, it replaces the gyroscopic term and the update of the attitude.

   Version: 0.1.0
   Home: not yet published

   C99, or C++11 and later. The names tumbling_... are in double precision. Define TUMBLING_FLOAT before including this
   file for those in single precision, tumblingf_...; include it both ways to have both in one program:

       #include "position_stage.h"
       #define TUMBLING_FLOAT
       #include "position_stage.h"

   It gives the bits of the Rust library that it is taken from, `tumbling::step::PositionStage`. Where the processor has
   a fused multiply-add, gcc needs -ffp-contract=off for that, and clang must not have -ffp-contract=fast; the last bits
   are all that differs.

   Options that let the compiler take every number for finite, or a sum or a quotient for another of about that value,
   are refused below where the compiler says that it has them; in clang for x86 they have no effect on this file. Some
   cannot be seen: in clang for other processors -fno-honor-nans, -funsafe-math-optimizations and its parts, and
   -fapprox-func; in gcc `__attribute__((optimize))` on a caller. Nor can linking with -ffast-math, after which the whole
   program takes subnormal numbers for zero.

   MIT License

   Copyright (c) 2026 the tumbling maintainers

   Permission is hereby granted, free of charge, to any person obtaining a copy
   of this software and associated documentation files (the "Software"), to deal
   in the Software without restriction, including without limitation the rights
   to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
   copies of the Software, and to permit persons to whom the Software is
   furnished to do so, subject to the following conditions:

   The above copyright notice and this permission notice shall be included in all
   copies or substantial portions of the Software.

   THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
   IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
   FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
   AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
   LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
   OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE
   SOFTWARE.

   Or, at your choice, the Apache License, version 2.0.
   SPDX-License-Identifier: MIT OR Apache-2.0 */
#ifdef TUMBLING_NUMBER
/* The arithmetic of a part of a step, written once: this file includes itself for one number and for lanes of them, with
   TUMBLING_NUMBER the type, TUMBLING_BODY the coefficients and TUMBLING_BY the names. It decides nothing. */

/* The spin along the principal axes; the rotation matrix from these to the world; the bound of the turn's square. */
static inline TUMBLING_NUMBER TUMBLING_BY(spin)(const TUMBLING_BODY *body, const TUMBLING_NUMBER p[4],
                                                const TUMBLING_NUMBER v[3], tumbling_real h, int framed,
                                                TUMBLING_NUMBER r[3][3], TUMBLING_NUMBER omega[3],
                                                TUMBLING_NUMBER s[3]) {
    const TUMBLING_NUMBER *f = body->frame;
    TUMBLING_NUMBER w = p[0], x = p[1], y = p[2], z = p[3], x2, y2, z2;
    if (framed) {
        w = p[0] * f[0] - p[1] * f[1] - p[2] * f[2] - p[3] * f[3];
        x = p[0] * f[1] + p[1] * f[0] + p[2] * f[3] - p[3] * f[2];
        y = p[0] * f[2] - p[1] * f[3] + p[2] * f[0] + p[3] * f[1];
        z = p[0] * f[3] + p[1] * f[2] - p[2] * f[1] + p[3] * f[0];
    }
    x2 = x + x, y2 = y + y, z2 = z + z;
    r[0][0] = 1 - (y * y2 + z * z2), r[0][1] = x * y2 - w * z2, r[0][2] = x * z2 + w * y2;
    r[1][0] = x * y2 + w * z2, r[1][1] = 1 - (x * x2 + z * z2), r[1][2] = y * z2 - w * x2;
    r[2][0] = x * z2 - w * y2, r[2][1] = y * z2 + w * x2, r[2][2] = 1 - (x * x2 + y * y2);
    omega[0] = r[0][0] * v[0] + r[1][0] * v[1] + r[2][0] * v[2];
    omega[1] = r[0][1] * v[0] + r[1][1] * v[1] + r[2][1] * v[2];
    omega[2] = r[0][2] * v[0] + r[1][2] * v[1] + r[2][2] * v[2];
    s[0] = (omega[0] * h) * (omega[0] * h), s[1] = (omega[1] * h) * (omega[1] * h);
    s[2] = (omega[2] * h) * (omega[2] * h);
    return body->bound[0] * s[0] + body->bound[1] * s[1] + body->bound[2] * s[2];
}

/* The attitude `q`, times `d` and by the half-angle tangents `c` over `d` along the body axes, all times `over`. */
static inline void TUMBLING_BY(turned)(const TUMBLING_NUMBER q[4], TUMBLING_NUMBER d, const TUMBLING_NUMBER c[3],
                                       TUMBLING_NUMBER over, TUMBLING_NUMBER to[4]) {
    to[0] = (q[0] * d - (q[1] * c[0] + q[2] * c[1] + q[3] * c[2])) * over;
    to[1] = (q[1] * d + (q[0] * c[0] + (q[2] * c[2] - q[3] * c[1]))) * over;
    to[2] = (q[2] * d + (q[0] * c[1] + (q[3] * c[0] - q[1] * c[2]))) * over;
    to[3] = (q[3] * d + (q[0] * c[2] + (q[1] * c[1] - q[2] * c[0]))) * over;
}

/* Attitude and spin at the end of a part, from what the spin above is; `length` is the square of the attitude's. Returns
   a number that is finite if all are. */
static inline TUMBLING_NUMBER TUMBLING_BY(turn)(const TUMBLING_BODY *body, const TUMBLING_NUMBER q[4],
                                                const TUMBLING_NUMBER v[3], tumbling_real h, int framed,
                                                TUMBLING_NUMBER r[3][3], const TUMBLING_NUMBER omega[3],
                                                const TUMBLING_NUMBER s[3], TUMBLING_NUMBER length,
                                                TUMBLING_NUMBER to_attitude[4], TUMBLING_NUMBER to_spin[3]) {
    const TUMBLING_NUMBER *a = body->coupling, *t = body->twist, *u = body->twist_2, *f = body->frame;
    const TUMBLING_NUMBER m0 = a[1] * a[2] * s[0], m1 = a[2] * a[0] * s[1], m2 = a[0] * a[1] * s[2];
    const TUMBLING_NUMBER mean = (m0 + m1 + m2) * ((tumbling_real)1 / 3);
    const TUMBLING_NUMBER e0 = mean - m0, e1 = mean - m1, e2 = mean - m2;
    const TUMBLING_NUMBER square = e0 * e0 + e1 * e1 + e2 * e2;
    const TUMBLING_NUMBER series = square * ((tumbling_real)1 / 10 + square * ((tumbling_real)1 / 300))
        + (e0 * e1) * e2 * ((tumbling_real)1 / 7);
    const TUMBLING_NUMBER first = t[0] * s[0] + t[1] * s[1] + t[2] * s[2];
    const TUMBLING_NUMBER more = s[0] * (u[0] * s[0] + u[1] * s[1] + u[2] * s[2])
        + s[1] * (u[3] * s[1] + u[4] * s[2]) + s[2] * (u[5] * s[2]);
    const TUMBLING_NUMBER twist = first + more * (1 + first * ((tumbling_real)17 / 14));
    const TUMBLING_NUMBER rate = (1 - mean) + series;
    const TUMBLING_NUMBER k[3] = {1 + body->relative[0] * twist, 1 + body->relative[1] * twist,
                                  1 + body->relative[2] * twist};
    const TUMBLING_NUMBER r0 = TUMBLING_ROOT(rate + m0), r1 = TUMBLING_ROOT(rate + m1), r2 = TUMBLING_ROOT(rate + m2);
    const TUMBLING_NUMBER b0 = a[0] * (omega[1] * h), b1 = a[1] * (omega[2] * h), b2 = a[2] * (omega[0] * h);
    const TUMBLING_NUMBER product = r1 * r2;
    const TUMBLING_NUMBER s0 = omega[0] * (rate + product) + b0 * omega[2] * r0;
    const TUMBLING_NUMBER s1 = omega[1] * (rate + r2 * r0) + b1 * omega[0] * r1;
    const TUMBLING_NUMBER s2 = omega[2] * (rate + r0 * r1) + b2 * omega[1] * r2;
    const TUMBLING_NUMBER below = rate * (rate * ((r0 + r1) + r2) + (r0 * product + b0 * b1 * b2));
    const TUMBLING_NUMBER h0 = s0 * h, h1 = s1 * h, h2 = s2 * h;
    const TUMBLING_NUMBER c[3] = {k[0] * (h0 * rate), k[1] * (h1 * rate), k[2] * (h2 * rate)};
    const TUMBLING_NUMBER b[3] = {k[0] * (a[0] * (h1 * s2)), k[1] * (a[1] * (h2 * s0)), k[2] * (a[2] * (h0 * s1))};
    const TUMBLING_NUMBER along = (c[0] * b[0] + c[1] * b[1]) + c[2] * b[2];
    const TUMBLING_NUMBER stretched = (below * below + c[0] * c[0]) + (c[1] * c[1] + c[2] * c[2]);
    const TUMBLING_NUMBER grown = stretched * length, scale = 1 / (below * grown);
    const TUMBLING_NUMBER over = (scale * below) * TUMBLING_ROOT(grown);
    const TUMBLING_NUMBER c0 = below * (below * b[0] + (c[1] * b[2] - c[2] * b[1])) + c[0] * along;
    const TUMBLING_NUMBER c1 = below * (below * b[1] + (c[2] * b[0] - c[0] * b[2])) + c[1] * along;
    const TUMBLING_NUMBER c2 = below * (below * b[2] + (c[0] * b[1] - c[1] * b[0])) + c[2] * along;
    to_spin[0] = v[0] + ((r[0][0] * c0 + r[0][1] * c1) + r[0][2] * c2) * scale;
    to_spin[1] = v[1] + ((r[1][0] * c0 + r[1][1] * c1) + r[1][2] * c2) * scale;
    to_spin[2] = v[2] + ((r[2][0] * c0 + r[2][1] * c1) + r[2][2] * c2) * scale;
    if (framed) {
        const TUMBLING_NUMBER x0 = f[2] * c[2] - f[3] * c[1], x1 = f[3] * c[0] - f[1] * c[2], x2 = f[1] * c[1] - f[2] * c[0];
        const TUMBLING_NUMBER y0 = x0 + x0, y1 = x1 + x1, y2 = x2 + x2;
        const TUMBLING_NUMBER in_body[3] = {c[0] + (f[0] * y0 + (f[2] * y2 - f[3] * y1)),
                                            c[1] + (f[0] * y1 + (f[3] * y0 - f[1] * y2)),
                                            c[2] + (f[0] * y2 + (f[1] * y1 - f[2] * y0))};
        TUMBLING_BY(turned)(q, below, in_body, over, to_attitude);
    } else {
        TUMBLING_BY(turned)(q, below, c, over, to_attitude);
    }
    return to_spin[0] + to_spin[1] + to_spin[2] + over;
}

/* The attitude at the end of a part that needs no gyroscopic term: a turn about the spin in the world, which stays.
   `s` is the square of the turn. Returns a number that is finite if all are. */
static inline TUMBLING_NUMBER TUMBLING_BY(steady_turn)(const TUMBLING_NUMBER q[4], const TUMBLING_NUMBER v[3],
                                                       tumbling_real h, TUMBLING_NUMBER s, TUMBLING_NUMBER length,
                                                       TUMBLING_NUMBER to[4]) {
    const tumbling_real first = (tumbling_real)1 / 12, second = (tumbling_real)1 / 120;
    const TUMBLING_NUMBER half = (1 + s * (first + s * (second + s * ((tumbling_real)17 / 20160)))) * (h / 2);
    const TUMBLING_NUMBER x = v[0] * half, y = v[1] * half, z = v[2] * half;
    const TUMBLING_NUMBER over = 1 / TUMBLING_ROOT(((1 + x * x) + (y * y + z * z)) * length);
    to[0] = (q[0] - (x * q[1] + y * q[2] + z * q[3])) * over;
    to[1] = (q[1] + (x * q[0] + (y * q[3] - z * q[2]))) * over;
    to[2] = (q[2] + (y * q[0] + (z * q[1] - x * q[3]))) * over;
    to[3] = (q[3] + (z * q[0] + (x * q[2] - y * q[1]))) * over;
    return over;
}
#else
#ifndef TUMBLING_POSITION_STAGE_VERSION
#define TUMBLING_POSITION_STAGE_VERSION "0.1.0"
#include <float.h>
#include <math.h>
#include <stddef.h>
#ifdef __SSE2__
#include <immintrin.h>
#elif defined __aarch64__
#include <arm_neon.h>
#endif
#ifdef TUMBLING_REAL
#error "define TUMBLING_FLOAT for single precision instead of TUMBLING_REAL: its names begin with tumblingf_"
#endif
#if defined __FAST_MATH__ || (defined __FINITE_MATH_ONLY__ && __FINITE_MATH_ONLY__ > 0) || defined _M_FP_FAST
#error "-ffast-math, -Ofast, -ffinite-math-only and /fp:fast take away what tells a number from none: compile without"
#endif
#if defined __ASSOCIATIVE_MATH__ || defined __RECIPROCAL_MATH__ || defined __NO_SIGNED_ZEROS__ || defined _M_FP_CONTRACT
#error "-funsafe-math-optimizations, its parts and /fp:contract change the bits of every step: compile without"
#endif
#if defined __GCC_IEC_559 && __GCC_IEC_559 < 1
#error "an option makes the compiler depart from IEEE 754: compile without it"
#endif
#if defined FLT_EVAL_METHOD && (FLT_EVAL_METHOD < 0 || FLT_EVAL_METHOD == 1 || FLT_EVAL_METHOD == 2)
#error "float and double are computed in another precision than their own: compile with -msse2 -mfpmath=sse"
#endif
#endif

#if defined TUMBLING_FLOAT ? !defined TUMBLING_POSITION_STAGE_FLOAT : !defined TUMBLING_POSITION_STAGE_DOUBLE
#ifdef TUMBLING_FLOAT
#define TUMBLING_POSITION_STAGE_FLOAT
#define tumbling_real tumblingf_real
#define tumbling_body tumblingf_body
#define tumbling_state tumblingf_state
#define tumbling_sqrt tumblingf_sqrt
#define tumbling_square tumblingf_square
#define tumbling_unit tumblingf_unit
#define tumbling_share tumblingf_share
#define tumbling_prepare tumblingf_prepare
#define tumbling_of_inverse tumblingf_of_inverse
#define tumbling_principal_rows tumblingf_principal_rows
#define tumbling_part tumblingf_part
#define tumbling_step tumblingf_step
#define tumbling_ordinary tumblingf_ordinary
#define tumbling_turn_square tumblingf_turn_square
#define tumbling_lane tumblingf_lane
#define tumbling_lanes tumblingf_lanes
#define tumbling_block tumblingf_block
#define tumbling_gather tumblingf_gather
#define tumbling_lane_sqrt tumblingf_lane_sqrt
#define tumbling_step_block tumblingf_step_block
#define tumbling_step_apart tumblingf_step_apart
#define tumbling_step_all tumblingf_step_all
#define TUMBLING_OF(single, twice) single
typedef float tumblingf_real;
#else
#define TUMBLING_POSITION_STAGE_DOUBLE
#define TUMBLING_OF(single, twice) twice
typedef double tumbling_real;
#endif
#ifdef __clang__
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Wignored-pragmas"
#pragma float_control(push)
#pragma float_control(precise, on)
#pragma STDC FP_CONTRACT OFF
#endif
/* A body, prepared once: pure numbers. `frame` (w, x, y, z) takes principal axes to body axes, if `framed`. A turn whose
   square is at most `steady` needs no gyroscopic term: the body is round, or the term is below rounding. */
typedef struct {
    tumbling_real coupling[3], relative[3], twist[3], twist_2[6], bound[3], frame[4], steady;
    int framed;
} tumbling_body;

/* Attitude (w, x, y, z; body to world; length 1) and spin in world axes, rad/s. */
typedef struct {
    tumbling_real attitude[4], omega[3];
} tumbling_state;

/* The square of the longest turn of a part of a step, and a hair more for what the parts of a longer one are rounded by. */
#ifndef TUMBLING_LONGEST
#define TUMBLING_LONGEST ((tumbling_real)0.5 * (tumbling_real)0.5 * (tumbling_real)1.0001f)
#endif
static inline tumbling_real tumbling_sqrt(tumbling_real x) {
    return TUMBLING_OF(sqrtf, sqrt)(x);
}
static inline tumbling_real tumbling_square(const tumbling_real q[4]) {
    return (q[0] * q[0] + q[1] * q[1]) + (q[2] * q[2] + q[3] * q[3]);
}
/* Of length 1; returns 0 for a quaternion of no length, or not finite. */
static inline int tumbling_unit(const tumbling_real q[4], tumbling_real unit[4]) {
    const tumbling_real few = (tumbling_real)1e-30f, many = (tumbling_real)1e30f;
    tumbling_real square = tumbling_square(q), most = 0, length;
    int i;
    for (i = 0; i < 4; i++) unit[i] = q[i];
    if (!(square >= few && square <= many)) { /* scaled first, where squares leave the range of numbers */
        for (i = 0; i < 4; i++) most = fabs((double)q[i]) > (double)most ? (q[i] < 0 ? -q[i] : q[i]) : most;
        for (i = 0; i < 4; i++) unit[i] = unit[i] / most;
        square = tumbling_square(unit);
    }
    length = tumbling_sqrt(square);
    for (i = 0; i < 4; i++) unit[i] = unit[i] / length;
    return square >= few;
}
static inline tumbling_real tumbling_share(tumbling_real weight, tumbling_real over, tumbling_real apart, tumbling_real beside) {
    return apart == 0 ? 0 : (weight / over) * (apart / beside);
}

/* Moments (any unit) along the principal axes, and the turn from these to the body axes or NULL. One zero moment is a
   thin rod; three mean locked axes: the spin then stays constant. Returns 0, and a body of constant spin, for moments
   that are negative or not finite, or one zero with two different ones, or so different that their ratios have no
   number, and for a turn of no length or not finite. */
static inline int tumbling_prepare(tumbling_body *body, const tumbling_real moments[3], const tumbling_real frame[4]) {
    static const int pair[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};
    const tumbling_real ones[3] = {1, 1, 1};
    tumbling_real m[3], a[3], first[6], y, z, yz, lo, mid, hi, most = 1, sum = 0;
    int i, j, valid = 1, zeros = 0, order[3] = {0, 1, 2}, axes[3];
    for (i = 0; i < 3; i++) {
        m[i] = moments[i];
        valid &= m[i] >= 0 && m[i] - m[i] == 0;
        zeros += m[i] == 0;
    }
    for (i = 0; i < 3; i++) { /* a rod is left alone: its other moments are equal */
        tumbling_real left = m[(i + 1) % 3], right = m[(i + 2) % 3];
        if (zeros == 1 && m[i] == 0) valid &= left == right;
        if (zeros == 2 && m[i] != 0) valid = 0;
    }
    body->framed = frame != 0;
    for (i = 0; i < 4; i++) body->frame[i] = (tumbling_real)(i == 0);
    if (frame) valid &= tumbling_unit(frame, body->frame);
    if (!valid || zeros == 3) {
        tumbling_prepare(body, ones, valid ? frame : 0);
        return valid;
    }
    for (i = 0; i < 3; i++) {
        tumbling_real left = m[(i + 1) % 3], right = m[(i + 2) % 3];
        a[i] = m[i] == 0 ? 0 : (left - right) / m[i];
        if (zeros == 1) a[i] = (tumbling_real)(m[i] == 0 ? 0 : left == 0 ? -1 : 1);
    }
    for (i = 0; i < 3; i++) {
        int at = i % 2;
        if (m[order[at + 1]] < m[order[at]]) j = order[at], order[at] = order[at + 1], order[at + 1] = j;
    }
    for (i = 0; i < 3; i++) axes[i] = (order[1] + i) % 3;
    y = a[axes[1]], z = a[axes[2]], yz = y * z;
    body->twist[axes[0]] = (1 + yz) / 12;
    body->twist[axes[1]] = (1 + z) / 12;
    body->twist[axes[2]] = (1 - y) / 12;
    first[0] = (6 - yz) * (1 + yz);
    first[1] = 2 * (6 + 3 * (yz + z) + 4 * (y - 1) * z * z);
    first[2] = 2 * (6 + 3 * (yz - y) - 4 * (z + 1) * y * y);
    first[3] = (1 + z) * (6 + 7 * yz + z * z) / (1 + yz);
    first[4] = 2 * (6 - yz * (2 + 3 * (y - z)) - 4 * (y * y + z * z) + 3 * (z - y)) / (1 + yz);
    first[5] = (1 - y) * (6 + 7 * yz + y * y) / (1 + yz);
    for (i = 0; i < 3; i++) {
        for (j = i; j < 3; j++) body->twist_2[pair[axes[i]][axes[j]]] = first[pair[i][j]] / 720;
    }
    lo = m[order[0]], mid = m[order[1]], hi = m[order[2]];
    for (i = 0; i < 3; i++) {
        body->coupling[i] = a[i];
        body->relative[i] = m[i] / mid;
        body->bound[i] = 1;
        if ((a[i] < 0 ? -a[i] : a[i]) > most) most = a[i] < 0 ? -a[i] : a[i];
    }
    if (lo > 0) {
        body->bound[order[1]] =
            1 + tumbling_share(mid, lo, hi - mid, hi - lo) + tumbling_share(mid, hi, mid - lo, hi - lo);
    }
    if (hi - mid > mid - lo) body->bound[order[0]] = 1 + tumbling_share(lo, mid, hi - lo, hi - mid);
    else body->bound[order[2]] = 1 + tumbling_share(hi, mid, hi - lo, mid - lo);
    for (i = 0; i < 3; i++) body->bound[i] = body->bound[i] * most * most;
    most = body->bound[0];
    for (i = 1; i < 3; i++) most = body->bound[i] > most ? body->bound[i] : most;
    body->steady = TUMBLING_OF(FLT_EPSILON, DBL_EPSILON) / 4;
    body->steady = body->steady * body->steady / most;
    if (a[0] == 0 && a[1] == 0 && a[2] == 0) body->steady = TUMBLING_LONGEST;
    for (i = 0; i < 3; i++) sum += body->bound[i] * 0 + body->twist[i] * 0;
    for (i = 0; i < 6; i++) sum += body->twist_2[i] * 0;
    if (sum == 0) return 1;
    tumbling_prepare(body, ones, 0);
    return 0;
}

/* From inverse moments, as engines store them; zero locks an axis, and the spin then stays constant. Returns 0, and a
   body of constant spin, for those that are negative or not finite or have no inverse, and as above. */
static inline int tumbling_of_inverse(tumbling_body *body, const tumbling_real inverse[3], const tumbling_real frame[4]) {
    tumbling_real moments[3];
    int i, valid = 1, locked = 0;
    for (i = 0; i < 3; i++) {
        valid &= inverse[i] >= 0 && inverse[i] - inverse[i] == 0;
        locked |= inverse[i] == 0;
    }
    for (i = 0; i < 3; i++) moments[i] = !valid ? -1 : locked ? 0 : 1 / inverse[i];
    return tumbling_prepare(body, moments, frame);
}

/* See tumbling_principal below. Jacobi's rotations, in double precision. Returns 0, and moments that are refused above,
   for numbers that are not finite, a tensor that is not symmetric to rounding, a moment too large for a number. */
static inline int tumbling_principal_rows(const tumbling_real x[3], const tumbling_real y[3], const tumbling_real z[3],
                                          tumbling_real moments[3], tumbling_real frame[4]) {
    const double limit = (double)TUMBLING_OF(FLT_MAX, DBL_MAX), epsilon = (double)TUMBLING_OF(FLT_EPSILON, DBL_EPSILON);
    double m[3][3], q[4] = {1, 0, 0, 0}, most = 0, apart;
    int i, j, k, n, exponent, valid = 1;
    for (i = 0; i < 3; i++) {
        m[0][i] = (double)x[i], m[1][i] = (double)y[i], m[2][i] = (double)z[i];
    }
    for (n = 0; n < 9; n++) {
        valid &= fabs(m[n / 3][n % 3]) <= limit;
        if (fabs(m[n / 3][n % 3]) > most) most = fabs(m[n / 3][n % 3]);
    }
    (void)frexp(valid ? most : 1, &exponent);
    for (n = 0; n < 9; n++) m[n / 3][n % 3] = ldexp(m[n / 3][n % 3], -exponent); /* no square is out of range */
    for (i = 0; i < 3; i++) {
        j = (i + 1) % 3;
        apart = m[i][j] - m[j][i];
        valid &= fabs(apart) <= 32 * epsilon;
        m[i][j] = m[j][i] = m[j][i] + apart / 2;
    }
    for (n = 0; n < 24 && valid; n++) {
        double t, c, s, half, p[4];
        i = (n + 1) % 3, j = (n + 2) % 3, k = n % 3;
        if (m[i][j] == 0) continue;
        apart = (m[j][j] - m[i][i]) / (2 * m[i][j]);
        t = (apart < 0 ? -1 : 1) / (fabs(apart) + sqrt(apart * apart + 1));
        c = 1 / sqrt(t * t + 1), s = t * c;
        m[i][i] -= t * m[i][j], m[j][j] += t * m[i][j], m[i][j] = m[j][i] = 0;
        apart = m[i][k];
        m[i][k] = m[k][i] = c * apart - s * m[j][k];
        m[j][k] = m[k][j] = s * apart + c * m[j][k];
        half = sqrt((1 + c) / 2), s = -s / (2 * half);
        p[0] = q[0] * half - q[1 + k] * s;
        p[1 + k] = q[1 + k] * half + q[0] * s;
        p[1 + i] = q[1 + i] * half + q[1 + j] * s;
        p[1 + j] = q[1 + j] * half - q[1 + i] * s;
        for (i = 0; i < 4; i++) q[i] = p[i];
    }
    for (i = 0; i < 3; i++) {
        m[i][i] = ldexp(m[i][i], exponent);
        valid &= m[i][i] <= limit;
    }
    for (i = 0; i < 3; i++) moments[i] = valid ? (tumbling_real)m[i][i] : -1;
    for (i = 0; i < 4; i++) frame[i] = (tumbling_real)q[i];
    return valid;
}

/* The arithmetic of one body; see the top of this file. */
#ifdef TUMBLING_FLOAT
#define TUMBLING_BY(name) tumblingf_by_one_##name
#define tumbling_by_one_spin tumblingf_by_one_spin
#else
#define TUMBLING_BY(name) tumbling_by_one_##name
#endif
#define TUMBLING_NUMBER tumbling_real
#define TUMBLING_BODY tumbling_body
#define TUMBLING_ROOT tumbling_sqrt
#include "position_stage.h"

/* Whether an attitude whose length has this square may be stepped: it is of length 1, to what steps round off. */
static inline int tumbling_ordinary(tumbling_real square) {
    const tumbling_real off = square - 1;
    return (off < 0 ? -off : off) <= TUMBLING_OF(FLT_EPSILON, DBL_EPSILON) * 32;
}

/* The square of the turn about this spin. */
static inline tumbling_real tumbling_turn_square(const tumbling_real v[3], tumbling_real h) {
    return ((v[0] * h) * (v[0] * h) + (v[1] * h) * (v[1] * h)) + (v[2] * h) * (v[2] * h);
}

/* One part of a step, of half a radian at most. Returns 0, and leaves `to`, if it is longer or not finite. */
static inline int tumbling_part(const tumbling_body *body, const tumbling_state *from, tumbling_real h, tumbling_state *to) {
    tumbling_real r[3][3], omega[3], s[3], q[4], v[3], check;
    const tumbling_real length = tumbling_square(from->attitude), turn = tumbling_turn_square(from->omega, h);
    int i;
    if (turn <= body->steady) {
        if (!tumbling_ordinary(length)) return 0;
        check = TUMBLING_BY(steady_turn)(from->attitude, from->omega, h, turn, length, q);
        for (i = 0; i < 3; i++) v[i] = from->omega[i];
    } else {
        const tumbling_real most = TUMBLING_BY(spin)(body, from->attitude, from->omega, h, body->framed, r, omega, s);
        if (!(most <= TUMBLING_LONGEST && tumbling_ordinary(length))) return 0;
        check = TUMBLING_BY(turn)(body, from->attitude, from->omega, h, body->framed, r, omega, s, length, q, v);
    }
    if (check - check != 0) return 0;
    for (i = 0; i < 4; i++) to->attitude[i] = q[i];
    for (i = 0; i < 3; i++) to->omega[i] = v[i];
    return 1;
}
#undef TUMBLING_BY
#undef TUMBLING_NUMBER
#undef TUMBLING_BODY
#undef TUMBLING_ROOT

/* The step of `h` seconds. Returns the number of parts in which it was taken; 0 if it was not, and `state` is as it was:
   numbers that are not finite, an attitude of no length, a turn of more than about 2000 rad (times the
   largest |I_j - I_k| / I_i where that is above 1: moments that no solid has). */
static inline int tumbling_step(const tumbling_body *body, tumbling_state *state, tumbling_real h) {
    tumbling_state at = *state;
    tumbling_real r[3][3], omega[3], s[3], length, turn;
    int i, parts;
    if (tumbling_part(body, state, h, state)) return 1;
    length = tumbling_sqrt(tumbling_square(at.attitude));
    for (i = 0; i < 4; i++) at.attitude[i] = at.attitude[i] / length;
    turn = tumbling_sqrt(tumbling_by_one_spin(body, at.attitude, at.omega, h, body->framed, r, omega, s)) / (tumbling_real)0.5;
    if (!(turn <= 4096)) return 0;
    parts = (int)turn;
    if ((tumbling_real)parts < turn) parts++;
    if (parts < 1) parts = 1;
    for (i = 0; i < parts; i++) {
        if (!tumbling_part(body, &at, h / (tumbling_real)parts, &at)) return 0;
    }
    *state = at;
    return parts;
}

/* Where the compiler has vectors, as many bodies side by side as a register holds: 4 in single precision and 2 in
   double, or twice as many with AVX. A body's bits are those that it has alone. */
#if defined __GNUC__ && !defined TUMBLING_ONE_BY_ONE
#ifdef __AVX__
#define TUMBLING_LANES TUMBLING_OF(8, 4)
#else
#define TUMBLING_LANES TUMBLING_OF(4, 2)
#endif
typedef tumbling_real tumbling_lane __attribute__((vector_size(TUMBLING_LANES * sizeof(tumbling_real))));
typedef struct {
    tumbling_lane coupling[3], relative[3], twist[3], twist_2[6], bound[3], frame[4];
} tumbling_lanes;
static inline tumbling_lane tumbling_lane_sqrt(tumbling_lane x) {
#if defined __AVX__
    return (tumbling_lane)TUMBLING_OF(_mm256_sqrt_ps((__m256)x), _mm256_sqrt_pd((__m256d)x));
#elif defined __SSE2__
    return (tumbling_lane)TUMBLING_OF(_mm_sqrt_ps((__m128)x), _mm_sqrt_pd((__m128d)x));
#elif defined __aarch64__
    return (tumbling_lane)TUMBLING_OF(vsqrtq_f32((float32x4_t)x), vsqrtq_f64((float64x2_t)x));
#else
    int i;
    for (i = 0; i < TUMBLING_LANES; i++) x[i] = tumbling_sqrt(x[i]);
    return x;
#endif
}
/* One number of each body: where a row of them begins, and its place in the row. */
static inline tumbling_lane tumbling_gather(const tumbling_real *const *p, int i) {
#if TUMBLING_LANES == 2
    const tumbling_lane all = {p[0][i], p[1][i]};
#elif TUMBLING_LANES == 4
    const tumbling_lane all = {p[0][i], p[1][i], p[2][i], p[3][i]};
#else
    const tumbling_lane all = {p[0][i], p[1][i], p[2][i], p[3][i], p[4][i], p[5][i], p[6][i], p[7][i]};
#endif
    return all;
}
#ifdef TUMBLING_FLOAT
#define TUMBLING_BY(name) tumblingf_by_lanes_##name
#else
#define TUMBLING_BY(name) tumbling_by_lanes_##name
#endif
#define TUMBLING_NUMBER tumbling_lane
#define TUMBLING_BODY tumbling_lanes
#define TUMBLING_ROOT tumbling_lane_sqrt
#include "position_stage.h"
#else
#define TUMBLING_LANES 1
#endif

/* Bodies that go side by side: where what each needs is found. */
typedef struct {
    const tumbling_body *body[TUMBLING_LANES];
    tumbling_real *attitude[TUMBLING_LANES], *omega[TUMBLING_LANES];
    int count;
} tumbling_block;

/* The step of one body whose numbers lie as in an engine. Returns whether it was not stepped. */
static inline size_t tumbling_step_apart(const tumbling_body *body, tumbling_real *attitude, tumbling_real *omega, int w,
                                         tumbling_real h) {
    tumbling_state state;
    const int x = w == 0;
    int i;
    state.attitude[0] = attitude[w];
    for (i = 0; i < 3; i++) state.attitude[1 + i] = attitude[x + i], state.omega[i] = omega[i];
    if (!tumbling_step(body, &state, h)) return 1;
    attitude[w] = state.attitude[0];
    for (i = 0; i < 3; i++) attitude[x + i] = state.attitude[1 + i], omega[i] = state.omega[i];
    return 0;
}

/* Steps the bodies of a full block: of kind 0 all are steady, of the others none, and of kind 2 all are framed. Returns
   how many were not stepped. */
static inline size_t tumbling_step_block(const tumbling_block *block, int kind, tumbling_real h, int w) {
    size_t missed = 0;
    int k;
#ifdef TUMBLING_NUMBER
    tumbling_lanes body;
    tumbling_lane q[4], v[3], p[4], u[3], r[3][3], omega[3], s[3], length, most, check;
    const tumbling_real *rows[TUMBLING_LANES];
    const int x = w == 0;
    int i;
#define TUMBLING_TAKE(member, length, from, at) \
    do { \
        for (k = 0; k < TUMBLING_LANES; k++) rows[k] = block->from; \
        for (i = 0; i < (length); i++) (member)[i] = tumbling_gather(rows, i + (at)); \
    } while (0)
    TUMBLING_TAKE(q, 1, attitude[k], w);
    TUMBLING_TAKE(q + 1, 3, attitude[k], x);
    TUMBLING_TAKE(v, 3, omega[k], 0);
    length = (q[0] * q[0] + q[1] * q[1]) + (q[2] * q[2] + q[3] * q[3]);
    if (kind == 0) {
        most = ((v[0] * h) * (v[0] * h) + (v[1] * h) * (v[1] * h)) + (v[2] * h) * (v[2] * h);
        check = TUMBLING_BY(steady_turn)(q, v, h, most, length, p);
        for (i = 0; i < 3; i++) u[i] = v[i];
    } else {
        TUMBLING_TAKE(body.coupling, 3, body[k]->coupling, 0);
        TUMBLING_TAKE(body.relative, 3, body[k]->relative, 0);
        TUMBLING_TAKE(body.twist, 3, body[k]->twist, 0);
        TUMBLING_TAKE(body.twist_2, 6, body[k]->twist_2, 0);
        TUMBLING_TAKE(body.bound, 3, body[k]->bound, 0);
        if (kind == 2) TUMBLING_TAKE(body.frame, 4, body[k]->frame, 0);
        most = TUMBLING_BY(spin)(&body, q, v, h, kind == 2, r, omega, s);
        check = TUMBLING_BY(turn)(&body, q, v, h, kind == 2, r, omega, s, length, p, u);
    }
#undef TUMBLING_TAKE
    check = check - check;
    for (k = 0; k < TUMBLING_LANES; k++) {
        tumbling_real *to = block->attitude[k];
        if (!(most[k] <= TUMBLING_LONGEST && tumbling_ordinary(length[k]) && check[k] == 0)) {
            missed += tumbling_step_apart(block->body[k], to, block->omega[k], w, h);
            continue;
        }
        to[w] = p[0][k];
        for (i = 0; i < 3; i++) to[x + i] = p[1 + i][k], block->omega[k][i] = u[i][k];
    }
#else
    (void)kind;
    for (k = 0; k < TUMBLING_LANES; k++) {
        missed += tumbling_step_apart(block->body[k], block->attitude[k], block->omega[k], w, h);
    }
#endif
    return missed;
}

/* The step of `h` seconds of `count` bodies, which lie where the engine has them: the first of each kind, and the bytes
   from one to the next (of bodies zero if all have one body's moments). `w` is the place of w in an attitude, 0 or 3.
   Returns the number of bodies that were not stepped, which stay as they were; see tumbling_step. */
static inline size_t tumbling_step_all(size_t count, const tumbling_body *body, size_t body_bytes, tumbling_real *attitude,
                                       size_t attitude_bytes, tumbling_real *omega, size_t omega_bytes, int w,
                                       tumbling_real h) {
    tumbling_block blocks[3];
    size_t n, missed = 0;
    int kind, k;
    for (kind = 0; kind < 3; kind++) blocks[kind].count = 0;
    for (n = 0; n < count; n++) {
        tumbling_block *block;
        kind = tumbling_turn_square(omega, h) <= body->steady ? 0 : body->framed ? 2 : 1;
        block = &blocks[kind], k = block->count++;
        block->body[k] = body, block->attitude[k] = attitude, block->omega[k] = omega;
        if (block->count == TUMBLING_LANES) {
            block->count = 0;
            missed += tumbling_step_block(block, kind, h, w);
        }
        body = (const tumbling_body *)(const void *)((const char *)body + body_bytes);
        attitude = (tumbling_real *)(void *)((char *)attitude + attitude_bytes);
        omega = (tumbling_real *)(void *)((char *)omega + omega_bytes);
    }
    for (kind = 0; kind < 3; kind++) {
        const tumbling_block *block = &blocks[kind];
        for (k = 0; k < block->count; k++) {
            missed += tumbling_step_apart(block->body[k], block->attitude[k], block->omega[k], w, h);
        }
    }
    return missed;
}
#undef TUMBLING_LANES
#undef TUMBLING_BY
#undef TUMBLING_NUMBER
#undef TUMBLING_BODY
#undef TUMBLING_ROOT
#ifdef __clang__
#pragma float_control(pop)
#pragma STDC FP_CONTRACT DEFAULT
#pragma clang diagnostic pop
#endif
#undef TUMBLING_OF
#ifdef TUMBLING_FLOAT
#undef tumbling_real
#undef tumbling_body
#undef tumbling_state
#undef tumbling_sqrt
#undef tumbling_square
#undef tumbling_unit
#undef tumbling_share
#undef tumbling_prepare
#undef tumbling_of_inverse
#undef tumbling_principal_rows
#undef tumbling_part
#undef tumbling_step
#undef tumbling_ordinary
#undef tumbling_turn_square
#undef tumbling_by_one_spin
#undef tumbling_lane
#undef tumbling_lanes
#undef tumbling_block
#undef tumbling_gather
#undef tumbling_lane_sqrt
#undef tumbling_step_block
#undef tumbling_step_apart
#undef tumbling_step_all
#endif
#endif
#undef TUMBLING_FLOAT

/* The principal moments of a tensor, three rows of three numbers, and the turn from the principal axes to those of the
   tensor: for engines that keep the tensor alone. Macros, since C before C23 warns where an array of rows becomes one of
   constant rows. */
#ifndef tumbling_principal
#define tumbling_principal(tensor, moments, frame) \
    tumbling_principal_rows((tensor)[0], (tensor)[1], (tensor)[2], moments, frame)
#define tumblingf_principal(tensor, moments, frame) \
    tumblingf_principal_rows((tensor)[0], (tensor)[1], (tensor)[2], moments, frame)
#endif
#endif
