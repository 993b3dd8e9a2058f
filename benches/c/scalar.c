/* Blinn-Phong point by point, as one writes it in C. Compiled with -O2. */
#include <math.h>
#include "scene.h"

typedef struct { float x, y, z; } vec3;

static inline float dot(vec3 a, vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

static vec3 shade(const struct scene *s, vec3 p, vec3 n, vec3 v)
{
    float sum[3];
    for (int k = 0; k < 3; k++)
        sum[k] = s->k_a[k] * s->ambient[k];
    for (size_t i = 0; i < s->lamp_count; i++) {
        const struct lamp *lamp = &s->lamps[i];
        vec3 l = {lamp->position[0] - p.x, lamp->position[1] - p.y, lamp->position[2] - p.z};
        float q = sqrtf(dot(l, l)), r = 1.0f / q;
        l = (vec3){l.x * r, l.y * r, l.z * r};
        float n_dot_l = dot(n, l);
        if (n_dot_l > 0.0f) {
            vec3 h = {l.x + v.x, l.y + v.y, l.z + v.z};
            float n_dot_h = dot(n, h) / sqrtf(dot(h, h));
            float highlight = n_dot_h > 0.0f ? powf(n_dot_h, s->m) : 0.0f;
            float attenuation = 1.0f / (s->attenuation[0] + q * (s->attenuation[1] + s->attenuation[2] * q));
            for (int k = 0; k < 3; k++)
                sum[k] += lamp->intensity[k] * attenuation * (s->k_d[k] * n_dot_l + s->k_s[k] * highlight);
        }
    }
    return (vec3){sum[0], sum[1], sum[2]};
}

void shade_scalar(const struct scene *s, size_t count, const vec3 *p, const vec3 *n, const vec3 *v, vec3 *image)
{
    for (size_t i = 0; i < count; i++)
        image[i] = shade(s, p[i], n[i], v[i]);
}
