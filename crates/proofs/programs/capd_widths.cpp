// How wide CAPD encloses the free motion of a body: Euler's equations and the attitude's quaternion, stepped by Taylor
// series with proven remainders (CAPD::DynSys, github.com/CAPDGroup/CAPD, GPL; nothing of it is in this repository).
//
//     g++ -O2 capd_widths.cpp $(capd-config --cflags --libs) -o capd_widths
//     ./capd_widths 3|7 ORDER HALF_PERIOD I1 I2 I3 W1 W2 W3
//
// 3 steps the spin alone, 7 the quaternion too. It prints, after 1, 10, 100, ... half periods, the widest component of
// the spin relative to its greatest one, that of the quaternion, and the seconds of processor time until then; it ends
// where CAPD finds no enclosure of a step. Numbers are read as the floats next to their decimals, and are those floats.
#include "capd/capdlib.h"
#include <cstdio>
#include <ctime>
using namespace capd;

static double widest(const IVector &x, int from, int to) {
    double most = 0;
    for (int k = from; k < to; ++k) most = std::max(most, rightBound(x[k]) - leftBound(x[k]));
    return most;
}

int main(int count, char **argv) {
    const int size = count == 10 ? atoi(argv[1]) : 0;
    if ((size != 3 && size != 7) || atoi(argv[2]) < 1) {
        fprintf(stderr, "usage: capd_widths 3|7 ORDER HALF_PERIOD I1 I2 I3 W1 W2 W3\n");
        return 2;
    }
    double number[7];
    for (int k = 0; k < 7; ++k) number[k] = strtod(argv[k + 3], nullptr);
    const std::string spin = "a*y*z,b*z*x,c*x*y";
    const std::string turn = ",-0.5*(q*x+r*y+s*z),0.5*(p*x+r*z-s*y),0.5*(p*y+s*x-q*z),0.5*(p*z+q*y-r*x)";
    IMap law(size == 3 ? "par:a,b,c;var:x,y,z;fun:" + spin + ";" : "par:a,b,c;var:x,y,z,p,q,r,s;fun:" + spin + turn + ";");
    const char *names[] = {"a", "b", "c"};
    for (int k = 0; k < 3; ++k) {
        const interval next(number[1 + (k + 1) % 3]), last(number[1 + (k + 2) % 3]);
        law.setParameter(names[k], (next - last) / interval(number[1 + k]));
    }
    IOdeSolver solver(law, atoi(argv[2]));
    solver.setAbsoluteTolerance(1e-18);
    solver.setRelativeTolerance(1e-18);
    ITimeMap run(solver);
    IVector start(size);
    for (int k = 0; k < 3; ++k) start[k] = interval(number[4 + k]);
    if (size == 7) start[3] = interval(1.0);
    C0HOTripletonSet set(start);
    try {
        for (double flips = 1; flips <= 1e6; flips *= 10) {
            const IVector x = run(interval(flips * number[0]), set);
            double greatest = 0;
            for (int k = 0; k < 3; ++k) greatest = std::max(greatest, rightBound(abs(x[k])));
            printf("%g half periods: spin %.0e, quaternion %.0e, %.1f s\n", flips, widest(x, 0, 3) / greatest,
                   widest(x, 3, size), double(clock()) / CLOCKS_PER_SEC);
            fflush(stdout);
        }
    } catch (std::exception &error) {
        printf("no enclosure of a step: %s\n", error.what());
    }
}
