/* The position stage of a physics engine: attitude and spin over a time step, with nothing else acting. It keeps energy
   and momentum to rounding, whatever the body, the spin and the step. In the engine's loop, after forces, damping,
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
#ifndef TUMBLING_POSITION_STAGE_VERSION
#define TUMBLING_POSITION_STAGE_VERSION "0.1.0"
#include <float.h>
#include <math.h>
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
#define tumbling_spin tumblingf_spin
#define tumbling_part tumblingf_part
#define tumbling_step tumblingf_step
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
/* A body, prepared once: pure numbers. `frame` (w, x, y, z) takes principal axes to body axes, if `framed`. */
typedef struct {
    tumbling_real coupling[3], modulus[3], relative[3], twist[3], twist_2[6], bound[3], frame[4];
    int framed;
} tumbling_body;

/* Attitude (w, x, y, z; body to world; length 1) and spin in world axes, rad/s. */
typedef struct {
    tumbling_real attitude[4], omega[3];
} tumbling_state;

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
        body->modulus[i] = a[(i + 1) % 3] * a[(i + 2) % 3];
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
    for (i = 0; i < 3; i++) sum += body->bound[i] * 0 + body->twist[i] * 0 + body->modulus[i] * 0;
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

/* The spin along the principal axes; the rotation matrix from these to the world; the bound of the turn's square. */
static inline tumbling_real tumbling_spin(const tumbling_body *body, const tumbling_state *from, tumbling_real h,
                                   tumbling_real r[3][3], tumbling_real omega[3], tumbling_real squares[3]) {
    const tumbling_real *p = from->attitude, *f = body->frame, *v = from->omega;
    tumbling_real w = p[0], x = p[1], y = p[2], z = p[3], x2, y2, z2;
    int i;
    if (body->framed) {
        w = p[0] * f[0] - p[1] * f[1] - p[2] * f[2] - p[3] * f[3];
        x = p[0] * f[1] + p[1] * f[0] + p[2] * f[3] - p[3] * f[2];
        y = p[0] * f[2] - p[1] * f[3] + p[2] * f[0] + p[3] * f[1];
        z = p[0] * f[3] + p[1] * f[2] - p[2] * f[1] + p[3] * f[0];
    }
    x2 = x + x, y2 = y + y, z2 = z + z;
    r[0][0] = 1 - (y * y2 + z * z2), r[0][1] = x * y2 - w * z2, r[0][2] = x * z2 + w * y2;
    r[1][0] = x * y2 + w * z2, r[1][1] = 1 - (x * x2 + z * z2), r[1][2] = y * z2 - w * x2;
    r[2][0] = x * z2 - w * y2, r[2][1] = y * z2 + w * x2, r[2][2] = 1 - (x * x2 + y * y2);
    for (i = 0; i < 3; i++) {
        omega[i] = r[0][i] * v[0] + r[1][i] * v[1] + r[2][i] * v[2];
        squares[i] = (omega[i] * h) * (omega[i] * h);
    }
    return body->bound[0] * squares[0] + body->bound[1] * squares[1] + body->bound[2] * squares[2];
}

/* One part of a step, of half a radian at most. Returns 0, and leaves `to`, if it is longer or not finite. */
static inline int tumbling_part(const tumbling_body *body, const tumbling_state *from, tumbling_real h, tumbling_state *to) {
    const tumbling_real *a = body->coupling, *t = body->twist, *u = body->twist_2, *q = from->attitude;
    tumbling_real r[3][3], omega[3], s[3], e[3], k[3], root[3], bend[3], sum[3], scaled[3], c[3], b[3], change[3], n[3];
    tumbling_real mean, square, series, twist, more, rate, product, below, over, along, length, scale, check;
    const tumbling_real epsilon = TUMBLING_OF(FLT_EPSILON, DBL_EPSILON);
    int i;
    square = tumbling_spin(body, from, h, r, omega, s);
    length = tumbling_square(q);
    check = length - 1 < 0 ? -(length - 1) : length - 1;
    if (!(square <= (tumbling_real)0.5 * (tumbling_real)0.5 * (tumbling_real)1.0001f && check <= epsilon * 32)) return 0;
    for (i = 0; i < 3; i++) e[i] = body->modulus[i] * s[i];
    mean = (e[0] + e[1] + e[2]) * ((tumbling_real)1 / 3);
    for (i = 0; i < 3; i++) e[i] = mean - e[i];
    square = e[0] * e[0] + e[1] * e[1] + e[2] * e[2];
    series = square * ((tumbling_real)1 / 10 + square * ((tumbling_real)1 / 300)) + (e[0] * e[1]) * e[2] * ((tumbling_real)1 / 7);
    twist = t[0] * s[0] + t[1] * s[1] + t[2] * s[2];
    more = s[0] * (u[0] * s[0] + u[1] * s[1] + u[2] * s[2]) + s[1] * (u[3] * s[1] + u[4] * s[2]) + s[2] * (u[5] * s[2]);
    twist = twist + more * (1 + twist * ((tumbling_real)17 / 14));
    rate = (1 - mean) + series;
    for (i = 0; i < 3; i++) {
        k[i] = 1 + body->relative[i] * twist;
        root[i] = tumbling_sqrt(rate + a[(i + 1) % 3] * a[(i + 2) % 3] * s[i]);
        bend[i] = a[i] * (omega[(i + 1) % 3] * h);
    }
    product = root[1] * root[2];
    for (i = 0; i < 3; i++) {
        sum[i] = omega[i] * (rate + root[(i + 1) % 3] * root[(i + 2) % 3]) + bend[i] * omega[(i + 2) % 3] * root[i];
    }
    below = rate * (rate * ((root[0] + root[1]) + root[2]) + (root[0] * product + bend[0] * bend[1] * bend[2]));
    for (i = 0; i < 3; i++) scaled[i] = sum[i] * h;
    for (i = 0; i < 3; i++) {
        c[i] = k[i] * (scaled[i] * rate);
        b[i] = k[i] * (a[i] * (scaled[(i + 1) % 3] * sum[(i + 2) % 3]));
    }
    along = (c[0] * b[0] + c[1] * b[1]) + c[2] * b[2];
    scale = (below * below + c[0] * c[0]) + (c[1] * c[1] + c[2] * c[2]);
    scale = 1 / (below * tumbling_sqrt(scale * length));
    over = scale * below;
    scale = scale * over;
    for (i = 0; i < 3; i++) {
        int j = (i + 1) % 3, l = (i + 2) % 3;
        change[i] = below * (below * b[i] + (c[j] * b[l] - c[l] * b[j])) + c[i] * along;
    }
    for (i = 0; i < 3; i++) {
        n[i] = from->omega[i] + ((r[i][0] * change[0] + r[i][1] * change[1]) + r[i][2] * change[2]) * scale;
    }
    if (body->framed) {
        const tumbling_real *f = body->frame;
        tumbling_real x[3];
        for (i = 0; i < 3; i++) x[i] = f[1 + (i + 1) % 3] * c[(i + 2) % 3] - f[1 + (i + 2) % 3] * c[(i + 1) % 3];
        for (i = 0; i < 3; i++) x[i] = x[i] + x[i];
        for (i = 0; i < 3; i++) {
            b[i] = c[i] + (f[0] * x[i] + (f[1 + (i + 1) % 3] * x[(i + 2) % 3] - f[1 + (i + 2) % 3] * x[(i + 1) % 3]));
        }
        for (i = 0; i < 3; i++) c[i] = b[i];
    }
    check = n[0] + n[1] + n[2] + over;
    if (check - check != 0) return 0;
    {
        tumbling_real w = q[0], x = q[1], y = q[2], z = q[3], d = below;
        to->attitude[0] = (w * d - (x * c[0] + y * c[1] + z * c[2])) * over;
        to->attitude[1] = (x * d + (w * c[0] + (y * c[2] - z * c[1]))) * over;
        to->attitude[2] = (y * d + (w * c[1] + (z * c[0] - x * c[2]))) * over;
        to->attitude[3] = (z * d + (w * c[2] + (x * c[1] - y * c[0]))) * over;
    }
    for (i = 0; i < 3; i++) to->omega[i] = n[i];
    return 1;
}

/* The step of `h` seconds. Returns the number of parts in which it was taken; 0 if it was not, and `state` is as it was:
   numbers that are not finite, an attitude of no length, a turn of more than about 2000 rad (times the
   largest |I_j - I_k| / I_i where that is above 1: moments that no solid has). */
static inline int tumbling_step(const tumbling_body *body, tumbling_state *state, tumbling_real h) {
    tumbling_state at = *state;
    tumbling_real r[3][3], omega[3], squares[3], length, turn;
    int i, parts;
    if (tumbling_part(body, state, h, state)) return 1;
    length = tumbling_sqrt(tumbling_square(at.attitude));
    for (i = 0; i < 4; i++) at.attitude[i] = at.attitude[i] / length;
    turn = tumbling_sqrt(tumbling_spin(body, &at, h, r, omega, squares)) / (tumbling_real)0.5;
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
#undef tumbling_spin
#undef tumbling_part
#undef tumbling_step
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
