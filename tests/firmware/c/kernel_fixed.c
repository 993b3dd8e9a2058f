#include "kernel_fixed.h"

#define ONE 65536

static inline fixed times(fixed a, fixed b) { return (fixed)((int64_t)a * b >> 16); }

/* 2^32 / a, up to a unit: one division of 32 bits instead of one of 64. */
static inline fixed reciprocal(fixed a) { return (fixed)(UINT32_MAX / (uint32_t)a); }

static inline fixed_vec3 add(fixed_vec3 a, fixed_vec3 b) {
    return (fixed_vec3){a.x + b.x, a.y + b.y, a.z + b.z};
}
static inline fixed_vec3 sub(fixed_vec3 a, fixed_vec3 b) {
    return (fixed_vec3){a.x - b.x, a.y - b.y, a.z - b.z};
}
static inline fixed_vec3 mul(fixed_vec3 a, fixed_vec3 b) {
    return (fixed_vec3){times(a.x, b.x), times(a.y, b.y), times(a.z, b.z)};
}
static inline fixed_vec3 scale(fixed_vec3 a, fixed s) {
    return (fixed_vec3){times(a.x, s), times(a.y, s), times(a.z, s)};
}

/* The three products are rounded together. */
static inline fixed dot(fixed_vec3 a, fixed_vec3 b) {
    return (fixed)(((int64_t)a.x * b.x + (int64_t)a.y * b.y + (int64_t)a.z * b.z) >> 16);
}

/* Digit by digit: 16 digits of the root of x, and 8 more of the zeros behind it. */
static fixed root(fixed x) {
    uint32_t bits = (uint32_t)x, rest = 0, root = 0;
    for (int digit = 0; digit < 24; digit++) {
        rest = rest << 2 | bits >> 30, bits <<= 2, root <<= 1;
        if (rest > root << 1) rest -= (root << 1) + 1, root++;
    }
    return (fixed)root;
}

static inline fixed_vec3 unit(fixed_vec3 a) { return scale(a, reciprocal(root(dot(a, a)))); }

static inline fixed power(fixed base, unsigned m) {
    fixed power = ONE;
    for (; m; base = times(base, base), m >>= 1) {
        if (m & 1) power = times(power, base);
    }
    return power;
}

fixed_vec3 blinn_phong_fixed(fixed_vec3 n, fixed_vec3 v, fixed_vec3 p, const fixed_material *surface,
                             fixed_vec3 ambient, const fixed_point_light *lights, int count) {
    fixed_vec3 diffuse = {0, 0, 0}, specular = {0, 0, 0};
    for (int i = 0; i < count; i++) {
        const fixed_point_light *light = &lights[i];
        fixed_vec3 to_light = sub(light->position, p);
        fixed q = root(dot(to_light, to_light));
        fixed_vec3 l = scale(to_light, reciprocal(q));
        fixed n_dot_l = dot(n, l);
        if (n_dot_l > 0) {
            fixed attenuation = reciprocal(light->a + times(q, light->b + times(q, light->c)));
            fixed_vec3 intensity = scale(light->intensity, attenuation);
            fixed n_dot_h = dot(n, unit(add(l, v)));
            fixed highlight = n_dot_h > 0 ? power(n_dot_h, surface->m) : 0;
            diffuse = add(diffuse, scale(intensity, n_dot_l));
            specular = add(specular, scale(intensity, highlight));
        }
    }
    return add(mul(surface->k_a, ambient),
               add(mul(surface->k_d, diffuse), mul(surface->k_s, specular)));
}
