/* The illumination of kernel.h in fixed point with 16 bits after the point, as firmware for a processor
   without floating point is usually written: nothing saturates. */
#ifndef KERNEL_FIXED_H
#define KERNEL_FIXED_H

#include <stdint.h>

typedef int32_t fixed; /* in units of 1/65536 */

#define FIXED(number) ((fixed)((number) * 65536.0 + ((number) < 0 ? -0.5 : 0.5)))

typedef struct { fixed x, y, z; } fixed_vec3; /* also red, green and blue */

typedef struct {
    fixed_vec3 position, intensity;
    fixed a, b, c; /* attenuation 1/(a + bq + cq^2) */
} fixed_point_light;

typedef struct {
    fixed_vec3 k_a, k_d, k_s;
    unsigned m;
} fixed_material;

fixed_vec3 blinn_phong_fixed(fixed_vec3 n, fixed_vec3 v, fixed_vec3 p, const fixed_material *surface,
                             fixed_vec3 ambient, const fixed_point_light *lights, int count);

#endif
