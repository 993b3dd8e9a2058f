/* What a renderer in C or C++ would write by itself, with the lights of the scene: the race's opponent. */
#ifndef BY_HAND_H
#define BY_HAND_H

#include <math.h>
#include <stddef.h>

#include "shading.h"

typedef struct vector { float x, y, z; } vector;

static inline vector vector_of(const float *v) { vector r = {v[0], v[1], v[2]}; return r; }
static inline vector scaled(vector v, float s) { vector r = {v.x * s, v.y * s, v.z * s}; return r; }
static inline vector sum(vector a, vector b) { vector r = {a.x + b.x, a.y + b.y, a.z + b.z}; return r; }
static inline float dot(vector a, vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static inline vector unit(vector v) { return scaled(v, 1.0f / sqrtf(dot(v, v))); }

static inline void shade_by_hand(size_t count, const float *points, const float *normals, const float *eye,
                                 const shading_material *material, const float *ambient,
                                 const shading_light *lights, size_t light_count, float *out) {
    for (size_t i = 0; i < count; i++) {
        vector p = vector_of(points + 3 * i), n = unit(vector_of(normals + 3 * i));
        vector v = unit(sum(vector_of(eye), scaled(p, -1.0f)));
        float *color = out + 3 * i;
        for (int c = 0; c < 3; c++) color[c] = material->k_a[c] * ambient[c];
        for (const shading_light *light = lights; light < lights + light_count; light++) {
            vector l = vector_of(light->direction);
            float factor = 1.0f;
            if (light->kind == SHADING_DIRECTIONAL) {
                l = unit(l);
            } else {
                l = sum(vector_of(light->position), scaled(p, -1.0f));
                float q = sqrtf(dot(l, l));
                l = scaled(l, 1.0f / q);
                const float *a = light->attenuation;
                factor = 1.0f / (a[0] + a[1] * q + a[2] * q * q);
                if (isfinite(light->range)) {
                    float share = q / light->range, window = 1.0f - share * share * share * share;
                    window = window > 0.0f ? window : 0.0f;
                    factor *= light->unsquared ? window : window * window;
                }
            }
            if (light->kind == SHADING_SPOT) {
                float cosine = -dot(l, unit(vector_of(light->direction)));
                float inner = cosf(light->inner), outer = cosf(light->outer);
                float t = (cosine - outer) / (inner - outer);
                t = t < 0.0f ? 0.0f : t > 1.0f ? 1.0f : t;
                factor *= t * t;
            }
            float n_dot_l = dot(n, l);
            if (n_dot_l <= 0.0f) continue;
            float n_dot_h = dot(n, unit(sum(l, v)));
            float highlight = n_dot_h > 0.0f ? powf(n_dot_h, material->m) : 0.0f;
            for (int c = 0; c < 3; c++)
                color[c] += light->intensity[c] * factor * (material->k_d[c] * n_dot_l + material->k_s[c] * highlight);
        }
    }
}

#endif
