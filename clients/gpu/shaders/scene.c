/* The scene in C99 and C++11, and in Metal through shim.hpp: the colors of the points that it reads. */
#ifdef METAL
#include "shim.hpp"
#include "shading.metal"
using namespace metal;
using namespace shading;
#define IN_SPACE(name) name
#define VECTOR(x, y, z) float3(x, y, z)
#define SUB(a, b) ((a) - (b))
#define ADD(sums, n, v, m, light, p) sums = add_blinn_phong(sums, n, v, m, light, p)
#define TOTAL(sums, material, i_a) total(sums, material, i_a)
typedef float3 vec3;
#else
#include "shading.h"
#define IN_SPACE(name) shading_##name
#define VECTOR(x, y, z) shading_vector(x, y, z)
#define SUB(a, b) shading_sub(a, b)
#define ADD(sums, n, v, m, light, p) shading_add_blinn_phong(&sums, n, v, m, &light, p)
#define TOTAL(sums, material, i_a) shading_total(&sums, &material, i_a)
typedef shading_vec3 vec3;
#endif
#include <stdio.h>

/* A vector and a number of a buffer. */
static vec3 of(const float *x) {
    return VECTOR(x[0], x[1], x[2]);
}

int main(void) {
    float x[20];
    IN_SPACE(Light) lights[3];
    IN_SPACE(Material) material;
    int i;
    for (i = 0; i < 3; i++) {
        if (fread(x, 4, 20, stdin) != 20) {
            return 1;
        }
        lights[i].position = of(x);
        lights[i].is_sun = x[3];
        lights[i].intensity = of(x + 4);
        lights[i].limit = x[7];
        lights[i].coefficients = of(x + 8);
        lights[i].range = x[11];
        lights[i].axis = of(x + 12);
        lights[i].is_smoothstep = x[15];
        lights[i].cosines.x = x[16];
        lights[i].cosines.y = x[17];
        lights[i].is_gltf = x[18];
    }
    if (fread(x, 4, 12, stdin) != 12) {
        return 1;
    }
    material.k_a = of(x);
    material.m = x[3];
    material.k_d = of(x + 4);
    material.k_s = of(x + 8);
    while (fread(x, 4, 8, stdin) == 8) {
        vec3 color = VECTOR(0.0f, 0.0f, 0.0f);
        if (x[3] > 0.0f) {
            vec3 p = of(x), n = of(x + 4);
            IN_SPACE(Sums) sums = {VECTOR(0.0f, 0.0f, 0.0f), VECTOR(0.0f, 0.0f, 0.0f)};
            vec3 v = IN_SPACE(unit)(SUB(VECTOR(0.0f, 0.0f, 6.0f), p));
            if (n.x == 0.0f && n.y == 0.0f && n.z == 0.0f) {
                n = IN_SPACE(normal_sphere)(VECTOR(0.0f, 0.0f, 0.0f), p);
            } else {
                n = IN_SPACE(unit)(n);
            }
            for (i = 0; i < 3; i++) {
                ADD(sums, n, v, material.m, lights[i], p);
            }
            color = TOTAL(sums, material, VECTOR(0.2f, 0.2f, 0.2f));
        }
        x[0] = color.x;
        x[1] = color.y;
        x[2] = color.z;
        x[3] = 1.0f;
        fwrite(x, 4, 4, stdout);
    }
    return 0;
}
