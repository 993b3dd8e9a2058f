/* Blinn-Phong, one point after the other, as it is written first. SHADE is the name of the function: it is compiled with
   -O2 and with -Ofast. */
#include <math.h>
#include <stddef.h>

/* k_a I_a, k_d, k_s; a, b, c of 1/(a + bq + cq²) */
struct material { float ambient[3], k_d[3], k_s[3], abc[3], m; };
struct point { float n[3], v[3], p[3]; };

static float dot(const float *a, const float *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

void SHADE(const struct material *s, size_t lamps, const float (*lamp)[3], size_t count, const struct point *points, float (*image)[3])
{
    for (size_t i = 0; i < count; i++) {
        const struct point *at = &points[i];
        float sum[3] = { s->ambient[0], s->ambient[1], s->ambient[2] };
        for (size_t j = 0; j < lamps; j++) {
            float l[3] = { lamp[j][0] - at->p[0], lamp[j][1] - at->p[1], lamp[j][2] - at->p[2] };
            float q = sqrtf(dot(l, l));
            for (int k = 0; k < 3; k++) l[k] /= q;
            float n_dot_l = dot(at->n, l);
            if (n_dot_l > 0.0f) {
                float h[3] = { l[0] + at->v[0], l[1] + at->v[1], l[2] + at->v[2] };
                float n_dot_h = fmaxf(dot(at->n, h) / sqrtf(dot(h, h)), 0.0f);
                float highlight = powf(n_dot_h, s->m);
                float denominator = s->abc[0] + s->abc[1] * q + s->abc[2] * q * q;
                for (int k = 0; k < 3; k++) sum[k] += (s->k_d[k] * n_dot_l + s->k_s[k] * highlight) / denominator;
            }
        }
        for (int k = 0; k < 3; k++) image[i][k] = sum[k];
    }
}
