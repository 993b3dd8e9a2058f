/* Blinn-Phong over structures of arrays, with a loop over the points for each light, so that the
   compiler vectorizes it and calls the vectorized powf of the C library. Compiled with -Ofast
   -march=native. gcc vectorizes this order of the two loops, but not the other. */
#include <math.h>
#ifdef __SSE__
#include <xmmintrin.h>
#endif
#include "scene.h"

struct arrays {
    const float *p[3], *n[3], *v[3];
    float *image[3];
};

static void add_light(const struct scene scene, const struct lamp lamp, size_t count,
                      const float *restrict px, const float *restrict py, const float *restrict pz,
                      const float *restrict nx, const float *restrict ny, const float *restrict nz,
                      const float *restrict vx, const float *restrict vy, const float *restrict vz,
                      float *restrict red, float *restrict green, float *restrict blue)
{
    const float *k_d = scene.k_d, *k_s = scene.k_s, *a = scene.attenuation;
    for (size_t i = 0; i < count; i++) {
        float lx = lamp.position[0] - px[i], ly = lamp.position[1] - py[i], lz = lamp.position[2] - pz[i];
        float q = sqrtf(lx * lx + ly * ly + lz * lz), over_q = 1.0f / q;
        lx *= over_q, ly *= over_q, lz *= over_q;
        float n_dot_l = nx[i] * lx + ny[i] * ly + nz[i] * lz;
        float hx = lx + vx[i], hy = ly + vy[i], hz = lz + vz[i];
        float n_dot_h = (nx[i] * hx + ny[i] * hy + nz[i] * hz) / sqrtf(hx * hx + hy * hy + hz * hz);
        float highlight = powf(n_dot_h > 0.0f ? n_dot_h : 0.0f, scene.m);
        float arriving = 1.0f / (a[0] + q * (a[1] + a[2] * q));
        float diffuse = n_dot_l > 0.0f ? arriving * n_dot_l : 0.0f;
        float specular = n_dot_l > 0.0f ? arriving * highlight : 0.0f;
        red[i] += lamp.intensity[0] * (k_d[0] * diffuse + k_s[0] * specular);
        green[i] += lamp.intensity[1] * (k_d[1] * diffuse + k_s[1] * specular);
        blue[i] += lamp.intensity[2] * (k_d[2] * diffuse + k_s[2] * specular);
    }
}

static void shade(const struct scene *s, size_t count, const struct arrays *all)
{
    for (int k = 0; k < 3; k++)
        for (size_t i = 0; i < count; i++)
            all->image[k][i] = s->k_a[k] * s->ambient[k];
    for (size_t j = 0; j < s->lamp_count; j++)
        add_light(*s, s->lamps[j], count, all->p[0], all->p[1], all->p[2], all->n[0], all->n[1], all->n[2],
                  all->v[0], all->v[1], all->v[2], all->image[0], all->image[1], all->image[2]);
}

/* Flushes subnormal numbers to zero, as gcc sets up the processor at the start of a program that it
   links with -Ofast; its powf needs that. */
void shade_lanes(const struct scene *s, size_t count, const struct arrays *all)
{
#ifdef __SSE__
    const unsigned before = _mm_getcsr();
    _mm_setcsr(before | 0x8040);
    shade(s, count, all);
    _mm_setcsr(before);
#else
    shade(s, count, all);
#endif
}
