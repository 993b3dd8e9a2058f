/* The ball by the header for C in single precision, and one point lit by some lamps; the scene is that of mod.rs. */
#include "shading.h"

static const shading_Light lamp = {
    {2.0f, 3.0f, 4.0f}, 0.0f, {1.0f, 0.9f, 0.8f}, 3.4028235e38f, {0.5f, 0.0f, 0.03f}, 3.4028235e38f, {0.0f, 0.0f, 1.0f},
    0.0f, {-1.0f, -1.0f}, 0.0f};

static const shading_Material brass = {{0.3f, 0.3f, 0.3f}, 28.0f, {0.78f, 0.57f, 0.11f}, {0.99f, 0.94f, 0.81f}};

void f32_in_c(int16_t right, int16_t up, float *color) {
    const shading_vec3 v = {0.0f, 0.0f, 1.0f}, i_a = {0.1f, 0.1f, 0.1f};
    float x = (float)right * (1.0f / 120.0f), y = (float)up * (1.0f / 120.0f);
    shading_vec3 p = {x, y, sqrtf(1.0f - x * x - y * y)}, n = shading_unit(p);
    shading_Sums sums = {{0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f}};
    shading_vec3 total;
    shading_add_blinn_phong(&sums, n, v, brass.m, &lamp, p);
    total = shading_total(&sums, &brass, i_a);
    color[0] = total.x;
    color[1] = total.y;
    color[2] = total.z;
}

void point_in_c(const shading_vec3 *n, const shading_vec3 *v, const shading_Material *material, const shading_vec3 *i_a,
                const shading_Light *lamps, uint32_t count, shading_vec3 *color) {
    shading_Sums sums = {{0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f}};
    for (uint32_t i = 0; i < count; i++) shading_add_blinn_phong(&sums, *n, *v, material->m, &lamps[i], *n);
    *color = shading_total(&sums, material, *i_a);
}

/* A lamp alone, as a program without suns and spots has them. */
typedef struct {
    shading_vec3 position;
    shading_vec3 intensity;
    float limit;
    shading_vec3 coefficients;
    float range, is_gltf;
} Lamp;

void lamps_in_c(const shading_vec3 *n, const shading_vec3 *v, const shading_Material *material, const shading_vec3 *i_a,
                const Lamp *lamps, uint32_t count, shading_vec3 *color) {
    shading_Sums sums = {{0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f}};
    for (uint32_t i = 0; i < count; i++) {
        const Lamp *lamp = &lamps[i];
        shading_Light light = {lamp->position, 0.0f, lamp->intensity, lamp->limit, lamp->coefficients, lamp->range,
                               {0.0f, 0.0f, 1.0f}, 0.0f, {-1.0f, -1.0f}, lamp->is_gltf};
        shading_add_blinn_phong(&sums, *n, *v, material->m, &light, *n);
    }
    *color = shading_total(&sums, material, *i_a);
}
