/* Shades a dome from C, and writes the colors as floats: main FILE. */
#include <math.h>
#include <stdio.h>

#include "shading.h"

enum { SIDE = 64, COUNT = SIDE * SIDE };

static const float eye[3] = {0, 0, 5}, ambient[3] = {0.5f, 0.5f, 0.5f};
static const shading_material material = {{0.125f, 0.125f, 0.125f}, {0.5f, 0.375f, 0.25f}, {0.5f, 0.5f, 0.5f}, 32};
/* kind, position, direction, intensity, attenuation, range, inner and outer half-angle, gltf */
static const shading_light lights[] = {
    {SHADING_DIRECTIONAL, {0, 0, 0}, {-1, 2, 2}, {0.25f, 0.25f, 0.375f}, {0, 0, 0}, 0, 0, 0, 0},
    {SHADING_POINT, {2, 1, 2}, {0, 0, 0}, {1, 0.75f, 0.5f}, {1, 0, 0.25f}, INFINITY, 0, 0, 0},
    {SHADING_SPOT, {0, 3, 3}, {0, -1, -1}, {3, 1, 1}, {1, 0.5f, 0}, 8, 0.25f, 0.375f, 0},
};

int main(int count, char **arguments) {
    static float points[COUNT][3], normals[COUNT][3], colors[COUNT][3];
    if (count != 2) return fprintf(stderr, "usage: main FILE\n"), 2;
    for (int i = 0; i < COUNT; i++) {
        float x = (float)(i % SIDE - 32) / 32, y = (float)(32 - i / SIDE) / 32;
        points[i][0] = x, points[i][1] = y, points[i][2] = 1 - x * x - y * y;
        normals[i][0] = 2 * x, normals[i][1] = 2 * y, normals[i][2] = 1;
    }
    int status = shading_shade(SHADING_BLINN_PHONG, COUNT, points[0], normals[0], eye, &material, ambient, lights,
                               sizeof lights / sizeof *lights, colors[0]);
    if (status) return fprintf(stderr, "shading_shade: status %d\n", status), 1;
    FILE *file = fopen(arguments[1], "wb");
    int is_written = file && fwrite(colors, sizeof colors, 1, file) == 1;
    return (file && fclose(file)) || !is_written;
}
