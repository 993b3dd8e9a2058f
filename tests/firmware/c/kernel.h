/* The same illumination as a C programmer writes it, for comparison with the crate: Blinn-Phong,
   three channels, point lights with attenuation. */
#ifndef KERNEL_H
#define KERNEL_H

typedef struct { float x, y, z; } vec3; /* also red, green and blue */

typedef struct {
    vec3 position, intensity;
    float a, b, c; /* attenuation 1/(a + bq + cq^2) */
} point_light;

typedef struct {
    vec3 k_a, k_d, k_s;
    float m;
} material;


vec3 blinn_phong_whole(vec3 n, vec3 v, vec3 p, const material *surface, vec3 ambient,
                       const point_light *lights, int count);
vec3 blinn_phong_real(vec3 n, vec3 v, vec3 p, const material *surface, vec3 ambient,
                      const point_light *lights, int count);

#endif
