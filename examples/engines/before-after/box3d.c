/* The scenes in Box3D, as driver.rs has them in Rust: a scene a line on standard input, a record a scene into the folder
   that the command line names. */
#include "box3d/box3d.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#define MOST 1024
static const float H = 1.0f / 60.0f;
static b3WorldId world;
static b3BodyId bodies[MOST];

static void turned(const double q[4], const double v[3], double back, double out[3]) {
    double w = back * q[0], u[3], t[3];
    int i;
    for (i = 0; i < 3; i++) u[i] = q[1 + (i + 1) % 3] * v[(i + 2) % 3] - q[1 + (i + 2) % 3] * v[(i + 1) % 3];
    for (i = 0; i < 3; i++) t[i] = q[1 + (i + 1) % 3] * u[(i + 2) % 3] - q[1 + (i + 2) % 3] * u[(i + 1) % 3];
    for (i = 0; i < 3; i++) out[i] = v[i] + 2 * (w * u[i] + t[i]);
}

static void new_world(float gravity) {
    b3WorldDef def = b3DefaultWorldDef();
    def.gravity = (b3Vec3){0, -gravity, 0};
    def.workerCount = 1;
    world = b3CreateWorld(&def);
}

/* Mass, moments, attitude (w, x, y, z), spin in body axes, position and velocity; the last two may be left out. */
static b3BodyId free_body(const float *n, float at_x, float faster) {
    double q[4] = {n[4], n[5], n[6], n[7]}, v[3] = {n[8] * faster, n[9] * faster, n[10] * faster}, w[3];
    b3BodyDef def = b3DefaultBodyDef();
    b3MassData mass = {0};
    b3BodyId id;
    turned(q, v, 1, w);
    def.type = b3_dynamicBody;
    def.enableSleep = false;
    def.position.x = n[11] + at_x, def.position.y = n[12], def.position.z = n[13];
    def.rotation = (b3Quat){{n[5], n[6], n[7]}, n[4]};
    def.linearVelocity = (b3Vec3){n[14], n[15], n[16]};
    def.angularVelocity = (b3Vec3){(float)w[0], (float)w[1], (float)w[2]};
    id = b3CreateBody(world, &def);
    mass.mass = n[0];
    mass.inertia.cx.x = n[1], mass.inertia.cy.y = n[2], mass.inertia.cz.z = n[3];
    b3Body_SetMassData(id, mass);
    return id;
}

static void floor_slab(void) {
    b3BodyDef def = b3DefaultBodyDef();
    b3ShapeDef shape = b3DefaultShapeDef();
    b3BoxHull slab = b3MakeBoxHull(50, 1, 50);
    def.position.y = -1;
    shape.baseMaterial.friction = 1;
    b3CreateHullShape(b3CreateBody(world, &def), &shape, &slab.base);
}

static void stack(const float *n) {
    int i;
    new_world(9.81f);
    floor_slab();
    for (i = 0; i < (int)n[0]; i++) {
        b3BodyDef def = b3DefaultBodyDef();
        b3ShapeDef shape = b3DefaultShapeDef();
        b3BoxHull box = b3MakeBoxHull(n[1], n[2], n[3]);
        def.type = b3_dynamicBody;
        def.enableSleep = false;
        def.position.y = n[2] * (1 + 2 * (float)i);
        shape.density = 1;
        bodies[i] = b3CreateBody(world, &def);
        b3CreateHullShape(bodies[i], &shape, &box.base);
    }
}

static void top(const float *n) {
    b3ShapeDef shape = b3DefaultShapeDef();
    b3Sphere ball = {{n[0], n[1], n[2]}, n[3]};
    b3MassData mass;
    new_world(9.81f);
    floor_slab();
    bodies[0] = free_body(n + 4, 0, 1);
    mass = b3Body_GetMassData(bodies[0]);
    shape.density = 0;
    shape.baseMaterial.friction = 1;
    b3CreateSphereShape(bodies[0], &shape, &ball);
    b3Body_SetMassData(bodies[0], mass);
}

static void wheel(const float *n) {
    b3RevoluteJointDef def = b3DefaultRevoluteJointDef();
    new_world(0);
    bodies[0] = free_body(n + 3, 0, 1);
    bodies[1] = free_body(n + 20, 0, 1);
    def.base.bodyIdA = bodies[0], def.base.bodyIdB = bodies[1];
    def.base.localFrameA = def.base.localFrameB = b3Transform_identity;
    def.base.localFrameA.p = (b3Vec3){n[0] - n[14], n[1] - n[15], n[2] - n[16]};
    def.base.localFrameB.p = (b3Vec3){n[0] - n[31], n[1] - n[32], n[2] - n[33]};
    b3CreateRevoluteJoint(world, &def);
}

static void record(FILE *file, int count, int steps, int every) {
    int i, k, n;
    for (n = 0; n <= steps; n++) {
        for (i = 0; n % every == 0 && i < count; i++) {
            b3Quat r = b3Body_GetRotation(bodies[i]);
            b3Vec3 v = b3Body_GetAngularVelocity(bodies[i]), u = b3Body_GetLinearVelocity(bodies[i]);
            b3Pos p = b3Body_GetPosition(bodies[i]);
            double q[4] = {r.s, r.v.x, r.v.y, r.v.z};
            double spin[3] = {v.x, v.y, v.z}, w[3];
            turned(q, spin, -1, w);
            fprintf(file, "%.17g", n / 60.0);
            for (k = 0; k < 4; k++) fprintf(file, ",%.17g", q[k]);
            for (k = 0; k < 3; k++) fprintf(file, ",%.17g", w[k]);
            if (count > 1) fprintf(file, ",%.9g,%.9g,%.9g,%.9g,%.9g,%.9g", p.x, p.y, p.z, u.x, u.y, u.z);
            fprintf(file, "\n");
        }
        b3World_Step(world, H, 4);
    }
}

static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return 1e6 * (double)t.tv_sec + 1e-3 * (double)t.tv_nsec;
}

int main(int count, char **words) {
    static char line[4096], path[1024];
    while (count > 1 && fgets(line, sizeof line, stdin)) {
        char kind[64], name[64], *rest;
        int steps, every, used, i, k, shown = 1;
        float n[64] = {0};
        FILE *file;
        if (sscanf(line, "%63s %63s %d %d%n", kind, name, &steps, &every, &used) < 4) continue;
        for (i = 0, rest = line + used; i < 64; i++) n[i] = strtof(rest, &rest);
        if (strncmp(kind, "time", 4) == 0) {
            for (k = 0; k < every; k++) {
                double start;
                if (strcmp(kind, "time-stack") == 0) stack(n);
                else {
                    new_world(0);
                    for (i = 0; i < (int)n[0]; i++) free_body(n + 1, 3 * (float)i, 1 + 0.001f * (float)(i % 100));
                }
                b3World_Step(world, H, 4);
                start = now();
                for (i = 0; i < steps; i++) b3World_Step(world, H, 4);
                printf("%.3f ", (now() - start) / steps);
                b3DestroyWorld(world);
            }
            printf("\n");
            continue;
        }
        snprintf(path, sizeof path, "%s/%s.csv", words[1], name);
        file = fopen(path, "w");
        if (!file) return 1;
        fprintf(file, "# engine: Box3D 0.1.0+30c67b5\n# dt: 1/60 s\n");
        if (strcmp(kind, "free") == 0) {
            new_world(0);
            bodies[0] = free_body(n, 0, 1);
            fprintf(file, "# inertia: %.9g %.9g %.9g kg m2\nt,qw,qx,qy,qz,wx,wy,wz\n", n[1], n[2], n[3]);
        } else if (strcmp(kind, "top") == 0) top(n);
        else if (strcmp(kind, "wheel") == 0) wheel(n), shown = 2;
        else stack(n), shown = (int)n[0];
        record(file, shown, steps, every);
        fclose(file);
        b3DestroyWorld(world);
    }
    return 0;
}
