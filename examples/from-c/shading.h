#include <stddef.h>
#include <stdint.h>

struct shading_lamp {
    float position[3], intensity[3];
    float attenuation[3]; /* a, b, c of 1/(a + bq + cq²) */
};

/* The light that the point p with the normal n sends along v. */
void shading_blinn_phong(const float p[3], const float n[3], const float v[3],
                         const float k_a[3], const float k_d[3], const float k_s[3], uint32_t m,
                         const struct shading_lamp *lamps, size_t count, float out[3]);
