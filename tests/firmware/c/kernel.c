#include "kernel.h"

#include <math.h>

static inline vec3 add(vec3 a, vec3 b) { return (vec3){a.x + b.x, a.y + b.y, a.z + b.z}; }
static inline vec3 sub(vec3 a, vec3 b) { return (vec3){a.x - b.x, a.y - b.y, a.z - b.z}; }
static inline vec3 mul(vec3 a, vec3 b) { return (vec3){a.x * b.x, a.y * b.y, a.z * b.z}; }
static inline vec3 scale(vec3 a, float s) { return (vec3){a.x * s, a.y * s, a.z * s}; }
static inline float dot(vec3 a, vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static inline vec3 unit(vec3 a) { return scale(a, 1.0f / sqrtf(dot(a, a))); }

static inline float power_whole(float base, float m) {
    float power = 1.0f;
    for (unsigned bits = (unsigned)m; bits; base *= base, bits >>= 1) {
        if (bits & 1) power *= base;
    }
    return power;
}

static inline vec3 blinn_phong(vec3 n, vec3 v, vec3 p, const material *surface, vec3 ambient,
                               const point_light *lights, int count,
                               float (*power)(float, float)) {
    vec3 diffuse = {0, 0, 0}, specular = {0, 0, 0};
    for (int i = 0; i < count; i++) {
        const point_light *light = &lights[i];
        vec3 to_light = sub(light->position, p);
        float q = sqrtf(dot(to_light, to_light));
        vec3 l = scale(to_light, 1.0f / q);
        float n_dot_l = dot(n, l);
        if (n_dot_l > 0.0f) {
            float attenuation = 1.0f / (light->a + q * (light->b + q * light->c));
            vec3 intensity = scale(light->intensity, attenuation);
            float n_dot_h = dot(n, unit(add(l, v)));
            float highlight = n_dot_h > 0.0f ? power(n_dot_h, surface->m) : 0.0f;
            diffuse = add(diffuse, scale(intensity, n_dot_l));
            specular = add(specular, scale(intensity, highlight));
        }
    }
    return add(mul(surface->k_a, ambient),
               add(mul(surface->k_d, diffuse), mul(surface->k_s, specular)));
}

vec3 blinn_phong_whole(vec3 n, vec3 v, vec3 p, const material *surface, vec3 ambient,
                       const point_light *lights, int count) {
    return blinn_phong(n, v, p, surface, ambient, lights, count, power_whole);
}

vec3 blinn_phong_real(vec3 n, vec3 v, vec3 p, const material *surface, vec3 ambient,
                      const point_light *lights, int count) {
    return blinn_phong(n, v, p, surface, ambient, lights, count, powf);
}
