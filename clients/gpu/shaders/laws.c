/* Shades the scenes that it reads, as the laws ask for them. */
#include "shading.h"
#include <stdio.h>

/* A light as in a buffer, where a number fills it. */
typedef struct {
    shading_Light light;
    float padding;
} Light;

typedef struct {
    shading_vec3 p;
    float model; /* 0: Lambert, 1: Phong, 2: Blinn-Phong */
    shading_vec3 n;
    float count;
    shading_vec3 v;
    float padding;
    shading_vec3 k_a;
    float m;
    shading_vec3 k_d;
    float padding_k_d;
    shading_vec3 k_s;
    float padding_k_s;
    shading_vec3 i_a;
    float padding_i_a;
    Light lights[8];
} Scene;

int main(void) {
    static Scene scene;
    while (fread(&scene, sizeof scene, 1, stdin) == 1) {
        shading_vec3 n = shading_unit(scene.n), v = shading_unit(scene.v), color;
        shading_Material material;
        shading_Sums sums = {{0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f}};
        float numbers[4] = {0.0f, 0.0f, 0.0f, 0.0f};
        int i;
        material.k_a = scene.k_a;
        material.m = scene.m;
        material.k_d = scene.k_d;
        material.k_s = scene.k_s;
        for (i = 0; i < (int)scene.count; i++) {
            const shading_Light *light = &scene.lights[i].light;
            if (scene.model == 0.0f) {
                shading_add_lambert(&sums, n, light, scene.p);
            } else if (scene.model == 1.0f) {
                shading_add_phong(&sums, n, v, material.m, light, scene.p);
            } else {
                shading_add_blinn_phong(&sums, n, v, material.m, light, scene.p);
            }
        }
        color = shading_total(&sums, &material, scene.i_a);
        numbers[0] = color.x;
        numbers[1] = color.y;
        numbers[2] = color.z;
        fwrite(numbers, sizeof numbers, 1, stdout);
    }
    return 0;
}
