/* The position stage of a physics engine: attitude and spin over a time step, with nothing else acting. It keeps energy
   and momentum to rounding, whatever the body, the spin and the step. In the engine's loop, after forces, damping,
   contacts and joints have changed the spin, it replaces the gyroscopic term and the update of the attitude.

   C99. Define TUMBLING_REAL as float before including this for single precision; it is double otherwise. Compiled with
   -ffp-contract=off it gives the same bits as the Rust library it is taken from, `tumbling::step::PositionStage`.

   Copyright (c) 2026 the tumbling maintainers
   SPDX-License-Identifier: MIT OR Apache-2.0 */
#ifndef TUMBLING_POSITION_STAGE_H
#define TUMBLING_POSITION_STAGE_H
#include <math.h>
#ifdef __FAST_MATH__
#error "-ffast-math takes away what tells a number from none: compile this without it"
#endif

#ifndef TUMBLING_REAL
#define TUMBLING_REAL double
#endif
typedef TUMBLING_REAL tumbling_real;

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
    return sizeof x == sizeof(float) ? (tumbling_real)sqrtf((float)x) : (tumbling_real)sqrt((double)x);
}
static inline tumbling_real tumbling_share(tumbling_real weight, tumbling_real over, tumbling_real apart, tumbling_real beside) {
    return apart == 0 ? 0 : (weight / over) * (apart / beside);
}
static inline tumbling_real tumbling_square(const tumbling_real q[4]) {
    return (q[0] * q[0] + q[1] * q[1]) + (q[2] * q[2] + q[3] * q[3]);
}

/* Moments (any unit) along the principal axes, and the turn from these to the body axes or NULL. A moment of infinity,
   or three of zero, mean locked axes: the spin then stays constant. One zero moment is a thin rod. Returns 0, and a body
   of constant spin, for moments that are negative or NaN, or one zero with two different ones. */
static inline int tumbling_prepare(tumbling_body *body, const tumbling_real moments[3], const tumbling_real frame[4]) {
    static const int pair[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};
    tumbling_real m[3], a[3], first[6], y, z, yz, lo, mid, hi, most = 1;
    int i, j, valid = 1, zeros = 0, locked = 0, order[3] = {0, 1, 2}, axes[3];
    for (i = 0; i < 3; i++) {
        m[i] = moments[i];
        valid &= m[i] >= 0;
        zeros += m[i] == 0;
        locked |= m[i] - m[i] != 0;
    }
    for (i = 0; i < 3; i++) { /* a rod is left alone: its other moments are equal */
        tumbling_real left = m[(i + 1) % 3], right = m[(i + 2) % 3];
        if (zeros == 1 && m[i] == 0) valid &= left == right;
        if (zeros == 2 && m[i] != 0) valid = 0;
    }
    locked |= !valid || zeros == 3;
    for (i = 0; i < 3; i++) {
        if (locked) m[i] = 1;
    }
    for (i = 0; i < 3; i++) {
        tumbling_real left = m[(i + 1) % 3], right = m[(i + 2) % 3];
        a[i] = m[i] == 0 ? 0 : (left - right) / m[i];
        if (zeros == 1 && !locked) a[i] = m[i] == 0 ? 0 : left == 0 ? -1 : 1;
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
    body->framed = frame != 0;
    for (i = 0; i < 4; i++) body->frame[i] = frame ? frame[i] / tumbling_sqrt(tumbling_square(frame)) : i == 0;
    return valid;
}

/* The principal moments of a symmetric tensor, and the turn from the principal axes to those of the tensor: for engines
   that keep the tensor alone. Jacobi's rotations, in double precision. */
static inline void tumbling_principal(const tumbling_real tensor[3][3], tumbling_real moments[3], tumbling_real frame[4]) {
    double m[3][3], q[4] = {1, 0, 0, 0};
    int i, j, k, n;
    for (i = 0; i < 3; i++) {
        for (j = 0; j < 3; j++) m[i][j] = (double)tensor[i][j];
    }
    for (n = 0; n < 24; n++) {
        double apart, t, c, s, half, p[4];
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
    for (i = 0; i < 3; i++) moments[i] = (tumbling_real)m[i][i];
    for (i = 0; i < 4; i++) frame[i] = (tumbling_real)q[i];
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
    tumbling_real mean, square, series, twist, more, pace, product, below, over, along, length, scale, check;
    tumbling_real epsilon = sizeof over == sizeof(float) ? (tumbling_real)1.1920928955078125e-7
                                                         : (tumbling_real)2.220446049250313e-16;
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
    pace = (1 - mean) + series;
    for (i = 0; i < 3; i++) {
        k[i] = 1 + body->relative[i] * twist;
        root[i] = tumbling_sqrt(pace + a[(i + 1) % 3] * a[(i + 2) % 3] * s[i]);
        bend[i] = a[i] * (omega[(i + 1) % 3] * h);
    }
    product = root[1] * root[2];
    for (i = 0; i < 3; i++) {
        sum[i] = omega[i] * (pace + root[(i + 1) % 3] * root[(i + 2) % 3]) + bend[i] * omega[(i + 2) % 3] * root[i];
    }
    below = pace * (pace * ((root[0] + root[1]) + root[2]) + (root[0] * product + bend[0] * bend[1] * bend[2]));
    for (i = 0; i < 3; i++) scaled[i] = sum[i] * h;
    for (i = 0; i < 3; i++) {
        c[i] = k[i] * (scaled[i] * pace);
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
    if (parts < turn) parts++;
    if (parts < 1) parts = 1;
    for (i = 0; i < parts; i++) {
        if (!tumbling_part(body, &at, h / (tumbling_real)parts, &at)) return 0;
    }
    *state = at;
    return parts;
}
#endif
