/* `shading` for C and whatever can call C: Lambert, Phong and Blinn-Phong shading of many points in one call.

   Vectors are three floats, x, y, z; colors are three floats, r, g, b, of linear light. Buffers hold one
   after the other without gaps. No function keeps a pointer, allocates memory that you must free, or
   changes anything but its output. On an error the output stays as it was. */
#ifndef SHADING_H
#define SHADING_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* What a function returns. */
enum shading_status {
    SHADING_OK = 0,
    SHADING_NULL = 1,     /* a pointer is null, and its buffer is not empty */
    SHADING_ALIGNMENT = 2,/* a pointer to floats or structures is not a multiple of 4 */
    SHADING_SIZE = 3,     /* a buffer is larger than the address space */
    SHADING_OVERLAP = 4,  /* the output overlaps an input */
    SHADING_MODEL = 5,    /* there is no such model */
    SHADING_MATERIAL = 6, /* a reflectance that the model takes or the ambient light is negative or not finite, or m is negative or NaN */
    SHADING_LIGHT = 7     /* a light has an unknown kind, no direction, or a bad intensity, attenuation, range, angle or gltf */
};

enum shading_model { SHADING_LAMBERT = 0, SHADING_PHONG = 1, SHADING_BLINN_PHONG = 2 };

enum shading_kind { SHADING_DIRECTIONAL = 0, SHADING_POINT = 1, SHADING_SPOT = 2 };

/* A light of any kind. A kind ignores the members that it does not need. */
typedef struct shading_light {
    uint32_t kind;        /* an enum shading_kind */
    float position[3];    /* point, spot */
    float direction[3];   /* directional: toward the light; spot: along its axis, away from the lamp. Of any length */
    float intensity[3];   /* not negative */
    float attenuation[3]; /* point, spot: a, b, c of 1/(a + bq + cq^2), q the distance; not negative, not all 0 */
    float range;          /* point, spot: where the light ends, above 0; INFINITY for never */
    float inner, outer;   /* spot: half-angles in radians, 0 <= inner <= outer <= pi; equal for a hard edge */
    uint32_t gltf;        /* point, spot: 0 to end by max(0, 1 - (q/range)^4)^2, 1 to end as glTF does, without the square */
} shading_light;

typedef struct shading_material {
    float k_a[3], k_d[3], k_s[3]; /* reflectances */
    float m;                      /* shininess; a whole number is faster. Lambert ignores k_s and m */
} shading_material;

/* The light that each of `count` points sends to the eye: k_a I_a and, for each light in front of the surface,
   I (k_d max(0, N.L) + k_s max(0, cosine)^m), where the cosine is R.V for Phong and N.H for Blinn-Phong.

   points, normals, out: 3 * count floats. Normals have any length. A point whose normal has no direction, or that is
   at the eye, is black.
   eye, ambient: 3 floats. */
int32_t shading_shade(uint32_t model, size_t count, const float *points, const float *normals, const float *eye,
                      const shading_material *material, const float *ambient,
                      const shading_light *lights, size_t light_count, float *out);

/* The bytes of linear colors in sRGB, rounded to the nearest: 3 * count floats to 3 * count bytes. */
int32_t shading_to_srgb8(size_t count, const float *colors, uint8_t *out);

#ifdef __cplusplus
}
#endif

#endif
