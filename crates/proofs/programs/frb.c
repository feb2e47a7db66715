// Calls FRB, Celledoni and Zanna's closed form in Fortran 77 (ACM Algorithm 903, folder 0903 of
// github.com/ACM-TOMS/CALGO; nothing of it is in this repository).
//
//     gfortran -O2 -std=legacy -c frb_step.f quat_step.f
//     gcc -O2 frb.c frb_step.o -lgfortran -lm -o frb_matrix
//     gcc -O2 -DQUATERNION frb.c quat_step.o -lgfortran -lm -o frb_quaternion
//     ./frb_matrix NODES I1 I2 I3 W1 W2 W3 TIME...    for each time the spin and the attitude, body to world
//     ./frb_matrix                                    ns for one instant, the bodies and times of benches/exact.rs
//
// NODES are those of its quadrature for the third elliptic integral, meant for short steps; 0: the integral in full.
//
// FRB wants the moments in increasing order and a momentum of length 1. So the axes are sorted, and reversed where
// that alone would be a reflection; the time is multiplied by the momentum's length.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#ifdef QUATERNION
#define STEP quat_step_
enum { SIZE = 4 };
static double unturned[] = {1, 0, 0, 0};
#else
#define STEP frb_step_
enum { SIZE = 9 };
static double unturned[] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
#endif
void STEP(double *momentum, double *attitude, double *time, double *moments, double *start, double *turn, int *order);
static int nodes = 0;

typedef struct {
    int axis[3];
    double sign, length, moments[3], start[3];
} Body;

static Body sorted(const double *moments, const double *spin) {
    Body body = {{0, 1, 2}, 1, 0, {0}, {0}};
    for (int pass = 0; pass < 3; ++pass) {
        int *low = body.axis + pass % 2;
        if (moments[low[0]] > moments[low[1]]) {
            const int kept = low[0];
            low[0] = low[1], low[1] = kept, body.sign = -body.sign;
        }
    }
    for (int k = 0; k < 3; ++k) {
        body.moments[k] = moments[body.axis[k]];
        body.start[k] = body.sign * body.moments[k] * spin[body.axis[k]];
        body.length += body.start[k] * body.start[k];
    }
    body.length = sqrt(body.length);
    for (int k = 0; k < 3; ++k) body.start[k] /= body.length;
    return body;
}

static void answer(Body body, double time) {
    double momentum[3] = {NAN, NAN, NAN}, attitude[SIZE], spin[3], turn[SIZE], scaled = body.length * time;
    for (int k = 0; k < SIZE; ++k) attitude[k] = NAN;
    STEP(momentum, attitude, &scaled, body.moments, body.start, unturned, &nodes);
    for (int k = 0; k < 3; ++k) spin[body.axis[k]] = body.sign * momentum[k] * body.length / body.moments[k];
    turn[0] = attitude[0];
    for (int k = 0; k < 3; ++k) {
        if (SIZE == 4) turn[1 + body.axis[k]] = body.sign * attitude[1 + k];
        // Fortran holds a matrix by columns.
        for (int l = 0; SIZE == 9 && l < 3; ++l) turn[3 * body.axis[k] + body.axis[l]] = attitude[k + 3 * l];
    }
    for (int k = 0; k < 3; ++k) printf("%.17g ", spin[k]);
    for (int k = 0; k < SIZE; ++k) printf("%.17g%s", turn[k], k < SIZE - 1 ? " " : "\n");
}

static double seconds(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return now.tv_sec + 1e-9 * now.tv_nsec;
}

// The times go from `from` on, in shares `of` those of the bench.
static double least(Body body, double from, double of) {
    double least = INFINITY, momentum[3], attitude[SIZE];
    for (int run = 0; run < 500; ++run) {
        const double start = seconds();
        for (int k = 0; k < 1024; ++k) {
            double time = body.length * (from + of * (k * 37 % 1024 * 0.117));
            STEP(momentum, attitude, &time, body.moments, body.start, unturned, &nodes);
        }
        least = fmin(least, (seconds() - start) / 1024);
    }
    return 1e9 * least;
}

static void print_times(const char *name, Body body) {
    printf("%s %.0f ns, at 1e9 periods %.0f ns, ", name, least(body, 0, 1), least(body, 1e10, 1));
    nodes = 5;
    printf("%s in short steps %.0f ns\n", name, least(body, 0, 0.002));
    nodes = 0;
}

int main(int count, char **argument) {
    double number[6] = {0.8333, 1.0833, 0.4167, 0.3, 0.4, 1.0};
    const double flipping[3] = {1, 1e-3, 1e-3};
    if (count < 2) {
        print_times("generic", sorted(number, number + 3));
        print_times("flipping", sorted(number, flipping));
        return 0;
    }
    nodes = atoi(argument[1]);
    for (int k = 0; count > 7 && k < 6; ++k) number[k] = strtod(argument[k + 2], NULL);
    for (int k = 8; k < count; ++k) answer(sorted(number, number + 3), strtod(argument[k], NULL));
    return 0;
}
