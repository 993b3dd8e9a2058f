/* Reads scenes, and writes what each function of shading_fixed.h gives for them. */
#include "shading_fixed.h"

#include <stdio.h>

enum { ARGUMENTS = 88, LIGHT = 22, RESULTS = 61 };

static const int32_t *arguments;
static int32_t results[RESULTS], *next_result;

static shading_fixed_vec3 vector(int i) {
    return shading_fixed_vector(arguments[i], arguments[i + 1], arguments[i + 2]);
}

static void give(int32_t x) { *next_result++ = x; }

static void give3(shading_fixed_vec3 v) {
    give(v.x);
    give(v.y);
    give(v.z);
}

static shading_fixed_light light(int i) {
    const int32_t *x = arguments + i;
    shading_fixed_light light = {(uint8_t)x[0], x[1] != 0, x[2] != 0, vector(i + 3), vector(i + 6), x[9], x[10],
                                 x[11], x[12], x[13], vector(i + 14), x[17], x[18]};
    return light;
}

static void compute(void) {
    shading_fixed_vec3 n = vector(0), v = vector(3), p = vector(6), i_a = vector(19);
    shading_fixed_material material = {vector(10), vector(13), vector(16), (uint32_t)arguments[9]};
    shading_fixed_sum lambert = SHADING_FIXED_DARK, phong = SHADING_FIXED_DARK, blinn = SHADING_FIXED_DARK;
    /* A lamp that the crate's types refuse, as a rule. */
    shading_fixed_light unchecked = {SHADING_FIXED_KIND_LAMP, false, false, {0, 0, 0}, i_a, n.x, n.y, n.z,
                                     v.x & INT32_MAX, 0, {0, 0, 0}, 0, 0};
    int i;
    give3(shading_fixed_unit(n));
    give(shading_fixed_length(p));
    give3(shading_fixed_reflection(n, v));
    give3(shading_fixed_half_vector(n, v));
    give(shading_fixed_term_lambert(n, v));
    give(shading_fixed_term_phong(n, v, material.m));
    give(shading_fixed_term_blinn(v, n, material.m));
    give(shading_fixed_sqrt(n.x));
    give3(shading_fixed_normal_plane(p.x, p.y, p.z));
    give3(shading_fixed_normal_sphere(n, p));
    give3(shading_fixed_normal_triangle(n, v, p));
    give3(shading_fixed_normal_facing(n, v, p));
    give3(shading_fixed_attenuated(&unchecked, p.x & INT32_MAX));
    for (i = LIGHT; i < ARGUMENTS; i += LIGHT) {
        shading_fixed_light one = light(i);
        shading_fixed_arrival arrival = shading_fixed_arrival_at(&one, p);
        give3(arrival.l);
        give(arrival.distance);
        give3(arrival.intensity);
        shading_fixed_add_lambert(&lambert, n, &one, p);
        shading_fixed_add_phong(&phong, n, v, material.m, &one, p);
        shading_fixed_add_blinn_phong(&blinn, n, v, material.m, &one, p);
    }
    give3(shading_fixed_total(&lambert, &material, i_a));
    give3(shading_fixed_total(&phong, &material, i_a));
    give3(shading_fixed_total(&blinn, &material, i_a));
    give(shading_fixed_to_rgb565(n));
    give(shading_fixed_to_srgb8(n.x));
}

/* Writes the encodings of all light from below black to above white. */
static void levels(void) {
    shading_fixed light;
    for (light = -2; light < 65540; light++) {
        int32_t both[2];
        both[0] = shading_fixed_to_rgb565(shading_fixed_vector(light, light, light));
        both[1] = shading_fixed_to_srgb8(light);
        fwrite(both, sizeof both, 1, stdout);
    }
}

int main(int argc, char **argv) {
    static int32_t read[ARGUMENTS];
    if (argc == 2 && argv[1][0] == 'l') {
        levels();
        return 0;
    }
    arguments = read;
    while (fread(read, sizeof read, 1, stdin) == 1) {
        next_result = results;
        compute();
        fwrite(results, sizeof results, 1, stdout);
    }
    return 0;
}
