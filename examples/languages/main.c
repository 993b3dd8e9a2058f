/* Shades a buffer of points from C, compares each bit with the crate's, tries every error, and races against the
   same by hand: main FOLDER, with the files that `scene` writes. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "by_hand.h"
#include "scene.h"
#include "shading.h"

static float points[3 * POINTS], normals[3 * POINTS], expected[3 * POINTS], ours[3 * POINTS], theirs[3 * POINTS];

_Static_assert(sizeof(shading_light) == 68 && sizeof(shading_material) == 40, "the sizes that the library has");

static void demand(int holds, const char *what) {
    if (holds) return;
    fprintf(stderr, "C: %s\n", what);
    exit(1);
}

static void read_floats(const char *folder, const char *name, float *into) {
    char path[4096];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *file = fopen(path, "rb");
    demand(file && fread(into, 12, POINTS, file) == POINTS, path);
    fclose(file);
}

static int32_t shade_with(const shading_material *surface, const shading_light *light, size_t count) {
    return shading_shade(SHADING_BLINN_PHONG, POINTS, points, normals, eye, surface, ambient, light, count, ours);
}

static void try_every_error(void) {
    float kept = ours[0];
    shading_material dark = material;
    shading_light bad = lights[1];
    demand(shading_shade(2, 1, NULL, normals, eye, &material, ambient, lights, 4, ours) == SHADING_NULL, "null points");
    demand(shading_shade(2, 1, points, normals, NULL, &material, ambient, lights, 4, ours) == SHADING_NULL, "null eye");
    demand(shading_shade(2, 1, points, normals, eye, &material, ambient, lights, 4, NULL) == SHADING_NULL, "null out");
    demand(shading_shade(2, 1, (float *)((char *)points + 2), normals, eye, &material, ambient, lights, 4, ours) ==
           SHADING_ALIGNMENT, "misaligned points");
    demand(shading_shade(2, SIZE_MAX, points, normals, eye, &material, ambient, lights, 4, ours) == SHADING_SIZE, "size");
    demand(shading_shade(2, 2, points, normals, eye, &material, ambient, lights, 4, points + 3) == SHADING_OVERLAP, "overlap");
    demand(shading_shade(3, 1, points, normals, eye, &material, ambient, lights, 4, ours) == SHADING_MODEL, "model");
    dark.k_d[1] = -1;
    demand(shade_with(&dark, lights, LIGHTS) == SHADING_MATERIAL, "negative reflectance");
    dark = material, dark.m = NAN;
    demand(shade_with(&dark, lights, LIGHTS) == SHADING_MATERIAL, "m of NaN");
    bad.range = 0;
    demand(shade_with(&material, &bad, 1) == SHADING_LIGHT, "a range of 0");
    bad = lights[1], bad.unsquared = 2;
    demand(shade_with(&material, &bad, 1) == SHADING_LIGHT, "unsquared is 2");
    bad = lights[3], bad.inner = 1;
    demand(shade_with(&material, &bad, 1) == SHADING_LIGHT, "inner beyond outer");
    bad.kind = 3;
    demand(shade_with(&material, &bad, 1) == SHADING_LIGHT, "an unknown kind");
    demand(ours[0] == kept, "an error changed the output");
    demand(shading_shade(2, 0, NULL, NULL, eye, &material, ambient, NULL, 0, NULL) == SHADING_OK, "nothing to do");
}

static double seconds(void) {
    struct timespec now;
    timespec_get(&now, TIME_UTC);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

int main(int count, char **arguments) {
    demand(count == 2, "usage: main FOLDER");
    read_floats(arguments[1], "points", points);
    read_floats(arguments[1], "normals", normals);
    read_floats(arguments[1], "colors", expected);
    demand(shade_with(&material, lights, LIGHTS) == SHADING_OK, "an error");
    demand(memcmp(ours, expected, sizeof ours) == 0, "other bits than the crate's");
    try_every_error();

    double least_ours = 1e9, least_theirs = 1e9;
    for (int pass = 0; pass < 20; pass++) {
        double start = seconds();
        shade_with(&material, lights, LIGHTS);
        double between = seconds();
        shade_by_hand(POINTS, points, normals, eye, &material, ambient, lights, LIGHTS, theirs);
        double end = seconds();
        if (between - start < least_ours) least_ours = between - start;
        if (end - between < least_theirs) least_theirs = end - between;
    }
    for (int i = 0; i < 3 * POINTS; i++)
        demand(fabsf(theirs[i] - ours[i]) <= 1e-4f * (1 + ours[i]), "the version by hand computes something else");
    printf("C: %.1f ms, %.2f of the time by hand; all bits are the crate's\n", 1e3 * least_ours, least_ours / least_theirs);
    return 0;
}
