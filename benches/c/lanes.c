/* Blinn-Phong over arrays, with a loop over the points for each light: gcc vectorizes this order of the two loops, and
   calls the vectorized powf of the C library. Compiled with -Ofast -march=native. */
#include <math.h>
#include <stddef.h>
#ifdef __SSE__
#include <xmmintrin.h>
#endif

/* k_a I_a, k_d, k_s; a, b, c of 1/(a + bq + cq²) */
struct material { float ambient[3], k_d[3], k_s[3], abc[3], m; };

static void add_lamp(const struct material s, const float *lamp, size_t count,
                     const float *restrict nx, const float *restrict ny, const float *restrict nz,
                     const float *restrict vx, const float *restrict vy, const float *restrict vz,
                     const float *restrict px, const float *restrict py, const float *restrict pz,
                     float *restrict red, float *restrict green, float *restrict blue)
{
    for (size_t i = 0; i < count; i++) {
        float lx = lamp[0] - px[i], ly = lamp[1] - py[i], lz = lamp[2] - pz[i];
        float q = sqrtf(lx * lx + ly * ly + lz * lz), over_q = 1.0f / q;
        lx *= over_q, ly *= over_q, lz *= over_q;
        float n_dot_l = nx[i] * lx + ny[i] * ly + nz[i] * lz;
        float hx = lx + vx[i], hy = ly + vy[i], hz = lz + vz[i];
        float n_dot_h = (nx[i] * hx + ny[i] * hy + nz[i] * hz) / sqrtf(hx * hx + hy * hy + hz * hz);
        float highlight = powf(n_dot_h > 0.0f ? n_dot_h : 0.0f, s.m);
        float arriving = 1.0f / (s.abc[0] + q * (s.abc[1] + s.abc[2] * q));
        float diffuse = n_dot_l > 0.0f ? arriving * n_dot_l : 0.0f;
        float specular = n_dot_l > 0.0f ? arriving * highlight : 0.0f;
        red[i] += s.k_d[0] * diffuse + s.k_s[0] * specular;
        green[i] += s.k_d[1] * diffuse + s.k_s[1] * specular;
        blue[i] += s.k_d[2] * diffuse + s.k_s[2] * specular;
    }
}

/* in: N, V, p; out: red, green, blue. Flushes subnormal numbers to zero, as gcc sets up the processor at the start of a
   program that it links with -Ofast; its powf needs that. */
void shade_lanes(const struct material *s, size_t lamps, const float (*lamp)[3], size_t count, float *const *in, float *const *out)
{
#ifdef __SSE__
    const unsigned before = _mm_getcsr();
    _mm_setcsr(before | 0x8040);
#endif
    for (int k = 0; k < 3; k++)
        for (size_t i = 0; i < count; i++)
            out[k][i] = s->ambient[k];
    for (size_t j = 0; j < lamps; j++)
        add_lamp(*s, lamp[j], count, in[0], in[1], in[2], in[3], in[4], in[5], in[6], in[7], in[8], out[0], out[1], out[2]);
#ifdef __SSE__
    _mm_setcsr(before);
#endif
}
