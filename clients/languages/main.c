/* Shades a dome from C: main FILE.ppm writes a picture that any viewer opens, main FILE the colors as floats. */
#include <stdio.h>
#include <string.h>

#include "shading.h"

enum { SIDE = 64, COUNT = SIDE * SIDE };

static void set(float vector[3], float x, float y, float z) {
    vector[0] = x, vector[1] = y, vector[2] = z;
}

static int write(const char *path, const char *header, const void *data, size_t size) {
    FILE *file = fopen(path, "wb");
    int is_written = file && fputs(header, file) >= 0 && fwrite(data, size, 1, file) == 1;
    return (file && fclose(file)) || !is_written;
}

int main(int count, char **arguments) {
    static float points[COUNT][3], normals[COUNT][3], colors[COUNT][3];
    static uint8_t pixels[COUNT][3];
    shading_light lights[3] = {
        shading_default_light(SHADING_DIRECTIONAL),
        shading_default_light(SHADING_POINT),
        shading_default_light(SHADING_SPOT),
    };
    shading_light *sun = &lights[0], *lamp = &lights[1], *spot = &lights[2];
    shading_scene scene = shading_default_scene();
    shading_error error;
    int is_failed;

    if (count != 2) return fprintf(stderr, "usage: main FILE\n"), 2;
    for (int i = 0; i < COUNT; i++) {
        float x = (float)(i % SIDE - 32) / 32, y = (float)(32 - i / SIDE) / 32;
        set(points[i], x, y, 1 - x * x - y * y);
        set(normals[i], 2 * x, 2 * y, 1);
    }

    set(sun->toward, -1, 2, 2);
    set(sun->intensity, 0.25f, 0.25f, 0.375f);
    set(lamp->position, 2, 1, 2);
    set(lamp->intensity, 1, 0.75f, 0.5f);
    set(lamp->attenuation, 1, 0, 0.25f);
    set(spot->position, 0, 3, 3);
    set(spot->axis, 0, -1, -1);
    set(spot->intensity, 3, 1, 1);
    set(spot->attenuation, 1, 0.5f, 0);
    spot->range = 8;
    spot->inner = 0.25f;
    spot->outer = 0.375f;

    scene.count = COUNT;
    scene.points = points[0];
    scene.normals = normals[0];
    scene.lights = lights;
    scene.light_count = sizeof lights / sizeof *lights;
    scene.material.m = 32;
    set(scene.eye, 0, 0, 5);
    set(scene.ambient, 0.5f, 0.5f, 0.5f);
    set(scene.material.k_a, 0.125f, 0.125f, 0.125f);
    set(scene.material.k_d, 0.5f, 0.375f, 0.25f);
    set(scene.material.k_s, 0.5f, 0.5f, 0.5f);
    if (shading_shade(&scene, colors[0], &error)) return fprintf(stderr, "%s\n", error.text), 1;

    const char *ending = strrchr(arguments[1], '.');
    if (ending && strcmp(ending, ".ppm") == 0) {
        shading_to_srgb8(COUNT, colors[0], pixels[0]);
        is_failed = write(arguments[1], "P6\n64 64\n255\n", pixels, sizeof pixels);
    } else {
        is_failed = write(arguments[1], "", colors, sizeof colors);
    }
    if (is_failed) perror(arguments[1]);
    return is_failed;
}
