/* `shading` for C and whatever can call C: Lambert, Phong and Blinn-Phong shading of many points in one call.

   Vectors are three floats, x, y, z; colors are three floats, r, g, b, of linear light. Buffers hold one
   after the other without gaps. No function keeps a pointer, allocates memory that you must free, or
   changes anything but its output. On an error the output stays as it was. Large calls use all
   processors; the environment variable RAYON_NUM_THREADS limits them. */
#ifndef SHADING_H
#define SHADING_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* What a function returns. shading_status_text gives the sentence of each. */
enum shading_status {
    SHADING_OK = 0,
    SHADING_NULL = 1,         /* the pointer is null, and its buffer is not empty */
    SHADING_ALIGNMENT = 2,    /* the pointer is not a multiple of its type's alignment */
    SHADING_SIZE = 3,         /* the buffer is larger than the address space */
    SHADING_OVERLAP = 4,      /* the output overlaps this input */
    SHADING_COUNT = 5,        /* a number of values or a switch is none of those allowed */
    SHADING_MODEL = 6,        /* there is no such model */
    SHADING_POINTS = 7,       /* a coordinate of points or vertices is not finite, or is outside of the grid of implicit */
    SHADING_NORMALS = 8,      /* a coordinate of normals is not finite */
    SHADING_EYE = 9,          /* a coordinate of eye is not finite */
    SHADING_REFLECTANCE = 10, /* k_a, k_d or k_s is negative, not finite or an image's byte, or all are 0 */
    SHADING_SHININESS = 11,   /* m is negative or NaN */
    SHADING_AMBIENT = 12,     /* ambient is negative or not finite */
    SHADING_VISIBLE = 13,     /* a fraction is not within 0 and 1 */
    SHADING_KIND = 14,        /* there is no such kind of light */
    SHADING_POSITION = 15,    /* the position of a light is not finite */
    SHADING_TOWARD = 16,      /* the direction toward a light is 0 or not finite */
    SHADING_AXIS = 17,        /* the axis of a spot is 0 or not finite */
    SHADING_INTENSITY = 18,   /* an intensity is negative or not finite */
    SHADING_ATTENUATION = 19, /* a coefficient is negative or not finite, or all are 0 */
    SHADING_RANGE = 20,       /* a range is not above 0 */
    SHADING_ANGLES = 21,      /* inner and outer are not half-angles in radians, 0 <= inner <= outer <= pi */
    SHADING_GLTF = 22,        /* gltf is neither 0 nor 1 */
    SHADING_HEIGHTS = 23,     /* a height is not finite */
    SHADING_STEP = 24,        /* dx, dy or dz is 0 or not finite */
    SHADING_FACES = 25,       /* a face has an index that is not a vertex's */
    SHADING_CREASE = 26,      /* crease is not an angle in radians, 0 <= crease <= pi */
    SHADING_VALUES = 27       /* a value of implicit is not finite */
};

enum shading_model { SHADING_LAMBERT = 0, SHADING_PHONG = 1, SHADING_BLINN_PHONG = 2 };

enum shading_kind { SHADING_DIRECTIONAL = 0, SHADING_POINT = 1, SHADING_SPOT = 2 };

/* A light of any kind. Take shading_default_light and set what differs. A kind ignores the members that it does
   not need. The comments give the defaults; what has none must be set. */
typedef struct shading_light {
    uint32_t kind;        /* an enum shading_kind */
    float position[3];    /* point, spot */
    float toward[3];      /* directional: the direction to the light, of any length */
    float axis[3];        /* spot: the direction in which it shines, of any length */
    float intensity[3];   /* 1, 1, 1 */
    float attenuation[3]; /* point, spot: a, b, c of 1/(a + bq + cq^2), where q is the distance. 1, 0, 0 */
    float range;          /* point, spot: the distance at which the light ends. INFINITY */
    float inner, outer;   /* spot: the half-angles in radians between which the edge softens. 0 and pi/4 */
    uint32_t gltf;        /* point, spot: 1 ends the light as glTF does, by 1 - (q/range)^4 without the square. 0 */
} shading_light;

typedef struct shading_material {
    float k_a[3], k_d[3], k_s[3]; /* what the surface reflects of each channel, usually from 0 to 1. At least one must be
                                     set, here or in each; the others are 0. shading_from_srgb8 decodes bytes */
    float m;                      /* the shininess; a whole number is faster. Lambert ignores k_s and m. 1 */
} shading_material;

/* Values that differ from point to point, such as textures. Each pointer is null, or points to one value for each
   point, which counts instead of the one for all points. */
typedef struct shading_each {
    const float *eye, *k_a, *k_d, *k_s; /* 3 * count floats */
    const float *m;                     /* count floats */
    const float *ambient;               /* 3 * count floats */
    const float *visible;               /* light_count * count fractions from 0 to 1 of the light that reaches a point:
                                           all points of the first light, then all of the second */
} shading_each;

/* Take shading_default_scene and set what differs. */
typedef struct shading_scene {
    uint32_t model;            /* an enum shading_model. SHADING_BLINN_PHONG */
    uint32_t parts;            /* 1 for the ambient, the diffuse and the specular part one after the other. 0 */
    size_t count;              /* how many points. 0 */
    const float *points;       /* 3 * count floats */
    const float *normals;      /* 3 * count floats, of any length. A point whose normal is 0 is black */
    float eye[3];              /* a point that is at the eye is black */
    float ambient[3];          /* the ambient light. 1, 1, 1 */
    shading_material material;
    const shading_light *lights;
    size_t light_count;        /* 0 */
    shading_each each;         /* all null */
} shading_scene;

/* What is wrong. */
typedef struct shading_error {
    int32_t status;
    size_t light;   /* the index of the light, or SIZE_MAX if it is about none */
    size_t index;   /* the index of the point, texel, height, vertex or face, or SIZE_MAX */
    char text[256]; /* such as: lights[1].intensity: expected finite numbers of 0 or more, got (-1, 0, 0) */
} shading_error;

shading_scene shading_default_scene(void);

shading_light shading_default_light(uint32_t kind);

/* The sentence of a status. It is valid forever. */
const char *shading_status_text(int32_t status);

/* The light that each point sends to the eye: k_a I_a and, for each light in front of the surface,
   I (k_d max(0, N.L) + k_s max(0, cosine)^m), where the cosine is R.V for Phong and N.H for Blinn-Phong.

   out: 3 * count floats, or 9 * count for the parts.
   error: null, or where to write what is wrong. */
int32_t shading_shade(const shading_scene *scene, float *out, shading_error *error);

/* The bytes of linear colors in sRGB, rounded to the nearest: 3 * count floats to 3 * count bytes. */
int32_t shading_to_srgb8(size_t count, const float *colors, uint8_t *out);

/* The same with an opaque alpha, for a canvas: 3 * count floats to 4 * count bytes. */
int32_t shading_to_srgba8(size_t count, const float *colors, uint8_t *out);

/* The linear colors of sRGB bytes, for k_d: 3 * count bytes to 3 * count floats. */
int32_t shading_from_srgb8(size_t count, const uint8_t *texture, float *out);

/* The unit normals (-dz/dx, -dz/dy, 1) of a grid of heights, row by row. The slopes are exact for parabolas.

   dx, dy: what x grows by from a column to the next, and y from a row to the next; dy is negative if the first row
   is the top of an image and y points up.
   out: 3 * rows * columns floats. */
int32_t shading_height_field(size_t rows, size_t columns, const float *z, float dx, float dy, float *out,
                             shading_error *error);

/* The unit normals of a mesh of triangles, counter-clockwise as seen from outside. The triangles around a vertex are weighted
   by their angles there. A vertex without triangles has the normal 0.

   vertices, faces: 3 * count floats, and 3 * face_count indices of vertices.
   crease: negative for one normal for each vertex; then out has 3 * count floats. Otherwise the greatest angle in radians
       between triangles that are one smooth surface; then out has 9 * face_count floats, a normal for each corner of each
       triangle. */
int32_t shading_mesh_normals(size_t count, const float *vertices, size_t face_count, const uint32_t *faces, float crease,
                             float *out, shading_error *error);

/* The unit normals of an implicit surface, on which a field of values is constant, at points of it. They point to where
   the values grow. They are approximate: the gradient at the nodes of the grid is that of central differences, and is
   interpolated in between. A point at which the gradient is 0 has the normal 0. Whoever knows the exact gradient passes it
   to shading_shade, whose normals have any length.

   values: layers * rows * columns floats, row by row and layer by layer. The first is at the point (0, 0, 0).
   dx, dy, dz: what x grows by from a column to the next, y from a row to the next, and z from a layer to the next.
   points: 3 * count floats, in the grid.
   out: 3 * count floats. */
int32_t shading_implicit(size_t layers, size_t rows, size_t columns, const float *values, float dx, float dy, float dz,
                         size_t count, const float *points, float *out, shading_error *error);

#ifdef __cplusplus
}
#endif

#endif
