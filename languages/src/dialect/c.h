#ifndef SHADING_H
#define SHADING_H

#include <math.h>
#include <stdint.h>
#include <string.h>

typedef struct {
    float x, y;
} shading_vec2;

/* A vector, or red, green and blue. */
typedef struct {
    float x, y, z;
} shading_vec3;

static inline shading_vec3 shading_vector(float x, float y, float z) {
    shading_vec3 v = {x, y, z};
    return v;
}
static inline shading_vec3 shading_add(shading_vec3 a, shading_vec3 b) {
    return shading_vector(a.x + b.x, a.y + b.y, a.z + b.z);
}
static inline shading_vec3 shading_sub(shading_vec3 a, shading_vec3 b) {
    return shading_vector(a.x - b.x, a.y - b.y, a.z - b.z);
}
static inline shading_vec3 shading_mul(shading_vec3 a, shading_vec3 b) {
    return shading_vector(a.x * b.x, a.y * b.y, a.z * b.z);
}
static inline shading_vec3 shading_neg(shading_vec3 a) {
    return shading_vector(-a.x, -a.y, -a.z);
}
static inline shading_vec3 shading_scale(shading_vec3 a, float s) {
    return shading_vector(a.x * s, a.y * s, a.z * s);
}
static inline shading_vec3 shading_over(shading_vec3 a, float s) {
    return shading_vector(a.x / s, a.y / s, a.z / s);
}
static inline float shading_dot(shading_vec3 a, shading_vec3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
static inline shading_vec3 shading_cross(shading_vec3 a, shading_vec3 b) {
    return shading_vector(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}
static inline float shading_max(float x, float least) {
    return x > least ? x : least;
}
static inline float shading_min(float x, float most) {
    return x > most ? most : x;
}
static inline float shading_clamp(float x, float least, float most) {
    return shading_min(shading_max(x, least), most);
}
static inline shading_vec3 shading_at_most(shading_vec3 a, float most) {
    return shading_vector(shading_min(a.x, most), shading_min(a.y, most), shading_min(a.z, most));
}

{structs}

static inline int32_t shading_bits(float x) {
    int32_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}
static inline float shading_from_bits(int32_t bits) {
    float x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

static inline int32_t shading_above(float x, float least) {
    return (int32_t)((uint32_t)shading_bits(x) - (uint32_t)shading_bits(least));
}

/* e of x = 2^e z, where z is within [least, 2 least). */
static inline float shading_exponent(float x, float least) {
    int32_t above = shading_above(x, least);
    return (float)((above - (above & 0x7FFFFF)) / 0x800000);
}
/* z of x = 2^e z. */
static inline float shading_significand(float x, float least) {
    int32_t above = shading_above(x, least);
    return shading_from_bits(shading_bits(x) - (above - (above & 0x7FFFFF)));
}
/* 2^(n - 127) for the low byte n of the bits of x. */
static inline float shading_two_to_low_bits(float x) {
    return shading_from_bits((int32_t)((uint32_t)shading_bits(x) << 23));
}
/* How many numbers x is above another of the same exponent: x - shift, which a compiler may take apart. */
static inline float shading_steps_above(float x, float shift) {
    return (float)shading_above(x, shift);
}

{own}

/* Whether a square is so small or large that it is not exact. */
static inline int shading_is_extreme(float square) {
    return (uint32_t)shading_bits(square) - {low_bits}u >= {width}u;
}

{functions}

/* The least light of each level but 0, in sRGB. IEC 61966-2-1. */
static const float shading_edges_of_5_bits[31] = {
    {5_bits}
};
static const float shading_edges_of_6_bits[63] = {
    {6_bits}
};
static const float shading_edges_of_8_bits[255] = {
    {8_bits}
};

/* The level of light. The bits of numbers rise as they do, and are faster to compare without an FPU. */
static inline uint32_t shading_level(const float *edges, uint32_t count, float light) {
    uint32_t level = 0, step;
    for (step = count / 2; step > 0; step /= 2) {
        if (shading_bits(light) >= shading_bits(edges[level + step - 1])) {
            level += step;
        }
    }
    return level;
}

/* One channel of a color as an sRGB byte, rounded once. */
static inline uint8_t shading_to_srgb8(float channel) {
    return (uint8_t)shading_level(shading_edges_of_8_bits, 256, channel);
}

/* A color in sRGB for a display of 16 bits: 5 bits red, 6 green, 5 blue, each rounded once. */
static inline uint16_t shading_to_rgb565(shading_vec3 color) {
    uint32_t r = shading_level(shading_edges_of_5_bits, 32, color.x);
    uint32_t g = shading_level(shading_edges_of_6_bits, 64, color.y);
    uint32_t b = shading_level(shading_edges_of_5_bits, 32, color.z);
    return (uint16_t)(r << 11 | g << 5 | b);
}

#endif
